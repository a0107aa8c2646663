// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_summary_versions_h
#define voussoir_output_summary_versions_h

#include <nlohmann/json.hpp>

#include <string>

namespace Voussoir
{
/** The versions of the program and of its libraries, by their names. */
nlohmann::ordered_json library_versions();

/**
 * The commit of the program, with "-dirty" if files differ from it; empty if it
 * was not built in a repository.
 */
std::string commit();
} // namespace Voussoir

#endif
