// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_space_settlement_h
#define voussoir_analyses_space_settlement_h

#include <voussoir/analyses/space/answer.h>
#include <voussoir/terminal/terminal.h>

#include <vector>

namespace Voussoir
{
/**
 * Put the forces and the motion that go with a displacement of the supports in
 * the place of those of least energy, and say what the blocks do.
 *
 * @param of_supports SpaceMotion::of_supports.
 * @throws InputError, SolverError as find_settlement() does.
 */
void settle(SpaceAnswer &answer,
            const std::vector<SpaceSupportMotion> &of_supports,
            Terminal &terminal);
} // namespace Voussoir

#endif
