// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_generators_block_resolution_h
#define voussoir_packing_polyhedra_generators_block_resolution_h

#include <voussoir/packing/generators/measures.h>

namespace Voussoir
{
/**
 * Check that blocks are larger than the distances by which faces that touch are
 * told from others.
 *
 * @param section of the generator, which a message names: "Packing/dome".
 * @param edges of blocks, each with the entries that it follows from, in
 *   quotes.
 * @param size of the packing; a length.
 * @throws InputError on the first that is less than a millionth of the size.
 */
void check_resolution(const std::string &section,
                      const std::vector<Measure> &edges,
                      double size);
} // namespace Voussoir

#endif
