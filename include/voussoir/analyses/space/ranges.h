// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_space_ranges_h
#define voussoir_analyses_space_ranges_h

#include <voussoir/analyses/space/answer.h>
#include <voussoir/terminal/terminal.h>

namespace Voussoir
{
/**
 * Find the ranges of forces of a scene whose loads are carried, and say them.
 *
 * @throws SolverError as find_ranges() does.
 */
void add_ranges(SpaceAnswer &answer,
                const RangesWanted &wanted,
                Terminal &terminal);
} // namespace Voussoir

#endif
