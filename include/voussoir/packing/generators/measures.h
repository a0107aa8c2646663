// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_generators_measures_h
#define voussoir_packing_generators_measures_h

#include <string>
#include <vector>

namespace Voussoir
{
/** A length that a user gives. */
struct Measure
{
  /** The entry of it, without its section: "Brick length". */
  std::string entry;
  /** Its value; a length. */
  double value;
};

/**
 * Check that measures are positive and finite.
 *
 * @param section of their entries: "Packing/wall".
 * @throws InputError naming the first that is not.
 */
void check_measures(const std::string &section,
                    const std::vector<Measure> &measures);

/** True if @p a differs from @p b by what a user does not write, at most. */
bool is_same_length(double a, double b);

/**
 * The number of parts that make a whole, both positive; a whole number of 1 at
 * least, which need not be one that an unsigned int holds.
 *
 * @throws InputError with the nearest lengths that fit if it is not whole.
 */
double number_of_parts(const std::string &section,
                       const Measure &whole,
                       const Measure &part);
} // namespace Voussoir

#endif
