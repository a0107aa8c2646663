// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_vtu_stress_pieces_h
#define voussoir_output_vtu_stress_pieces_h

#include <voussoir/output/result_directory.h>
#include <voussoir/stress/stress_part.h>

#include <string>

namespace Voussoir
{
/**
 * Write stress.pvtu, and beside it each process its part, stress_0.vtu and so
 * on, all processes at a time. On the root; the others, which must see the same
 * directory, write_stress_piece().
 *
 * @throws InputError if a process cannot write.
 */
void write_stress_pieces(ResultDirectory &files,
                         const StressPart &part,
                         const ProcessGroup &processes);

/** True if @p name is that of the part of a process. */
bool is_stress_piece(const std::string &name);

/** The name of this task, to which the root calls; see ProcessGroup::call(). */
inline const std::string writing_task = "writing";

/** The part of another process in write_stress_pieces(). */
void write_stress_piece(const StressPart &part, const ProcessGroup &processes);
} // namespace Voussoir

#endif
