// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/generators/measures.h>

#include <cmath>

namespace Voussoir
{
namespace
{
/**
 * The relative difference at which lengths of the user still mean the same: ten
 * digits are enough to name them.
 */
constexpr double resolution_of_measures = 1e-9;
} // namespace

void check_measures(const std::string &section,
                    const std::vector<Measure> &measures)
{
  for (const Measure &measure : measures)
    if (!std::isfinite(measure.value) || measure.value <= 0.)
      throw InputError(text("'", section, "/", measure.entry, "' is ",
                            text_of_number(measure.value),
                            "; it must be positive and finite."));
}

bool is_same_length(const double a, const double b)
{
  return std::abs(a - b) <= resolution_of_measures * b;
}

double number_of_parts(const std::string &section,
                       const Measure &whole,
                       const Measure &part)
{
  const double quotient = whole.value / part.value;
  const double nearest = std::round(quotient);
  if (nearest >= 1. && is_same_length(quotient, nearest))
    return nearest;
  const double below = std::floor(quotient);
  const std::string least = text_to_copy((below + 1.) * part.value);
  throw InputError(text(
      "'", section, "/", whole.entry, "' is ", text_to_copy(whole.value),
      ", which is not a whole number of times '", part.entry, "', ",
      text_to_copy(part.value), "; the nearest ",
      below < 1. ? "is " + least
                 : "are " + text_to_copy(below * part.value) + " and " + least,
      "."));
}
} // namespace Voussoir
