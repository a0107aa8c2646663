// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/generators/entry_checks.h>

#include <cmath>

namespace Voussoir
{
void check_measures(const std::string &section,
                    const std::vector<std::pair<std::string, double>> &measures)
{
  for (const auto &[entry, value] : measures)
    if (!std::isfinite(value) || value <= 0.)
      throw InputError(text("'Packing/", section, '/', entry, "' is ", value,
                            "; it must be positive and finite."));
}

void check_resolution(
    const std::string &section,
    const std::vector<std::pair<std::string, double>> &measures,
    const double largest)
{
  // Three digits above the distance to which faces touch, a billionth.
  constexpr double smallest_over_largest = 1e-6;
  for (const auto &[what, value] : measures)
    if (!(value >= smallest_over_largest * largest))
      throw InputError(text("The blocks of 'Packing/", section, "' measure ",
                            value, " because of ", what,
                            ", which is less than a millionth of the size ",
                            largest, "; they would not be told apart."));
}
} // namespace Voussoir
