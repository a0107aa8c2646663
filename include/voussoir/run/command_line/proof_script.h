// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_command_line_proof_script_h
#define voussoir_run_command_line_proof_script_h

#include <functional>
#include <string>
#include <vector>

namespace Voussoir
{
/**
 * Have results proven again from their files, by contrib/check_proof:
 * arithmetic of its own in Python, since a proof that shares code with what it
 * proves would share its faults.
 *
 * @param directories of results.
 * @param take gets a line on each.
 * @return whether all of them are proven.
 * @throws InputError if the script or Python is not there.
 */
bool prove_again(const std::vector<std::string> &directories,
                 const std::function<void(const std::string &line)> &take);
} // namespace Voussoir

#endif
