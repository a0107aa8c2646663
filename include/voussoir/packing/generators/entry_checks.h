// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_generators_entry_checks_h
#define voussoir_packing_generators_entry_checks_h

#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
/**
 * Check the values of entries that measure something.
 *
 * @param section of the entries below "Packing", which a message names.
 * @param measures the entries, each with its value.
 * @throws InputError on the first that is not positive and finite.
 */
void check_measures(
    const std::string &section,
    const std::vector<std::pair<std::string, double>> &measures);

/**
 * Check that blocks are larger than what places are known and compared to.
 *
 * @param section below "Packing", which a message names.
 * @param measures lengths of blocks, each with what makes it.
 * @param largest the size of the packing; a length.
 * @throws InputError on the first that is less than a millionth of it: faces
 *   that touch are told from others to a billionth.
 */
void check_resolution(
    const std::string &section,
    const std::vector<std::pair<std::string, double>> &measures,
    double largest);
} // namespace Voussoir

#endif
