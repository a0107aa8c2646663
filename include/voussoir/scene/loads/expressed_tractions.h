// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_loads_expressed_tractions_h
#define voussoir_scene_loads_expressed_tractions_h

#include <voussoir/packing/packing.h>
#include <voussoir/scene/loads/resultant.h>
#include <voussoir/scene/loads/segment_tractions.h>

#include <string>
#include <vector>

namespace Voussoir
{
/**
 * Put the mean and the first moment of a traction on edges of the boundary.
 *
 * @param expression "g_x; g_y" in x, y and the outward unit normal nx, ny; S.
 * @param parameter that it is from, for messages.
 * @param chosen the edges that it acts on, one for each of the boundary.
 * @param tractions of these edges, which are set.
 * @param requested to which they are added.
 * @param warnings to which those on integrals that are not exact are added.
 * @throws InputError as Expression does, or naming the place if a value is not
 *   finite or varies too fast for its mean.
 */
void set_expressed_tractions(const Packing<2> &packing,
                             const std::string &expression,
                             const std::string &parameter,
                             const std::vector<bool> &chosen,
                             EdgeTractions &tractions,
                             Resultant &requested,
                             std::vector<std::string> &warnings);
} // namespace Voussoir

#endif
