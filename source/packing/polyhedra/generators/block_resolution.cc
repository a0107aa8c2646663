// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/generators/block_resolution.h>

namespace Voussoir
{
namespace
{
/**
 * The shortest edge over the size of the packing: three digits above a
 * billionth, at which computed faces still touch.
 */
constexpr double shortest_edge = 1e-6;
} // namespace

void check_resolution(const std::string &section,
                      const std::vector<Measure> &edges,
                      const double size)
{
  for (const Measure &edge : edges)
    if (!(edge.value >= shortest_edge * size))
      throw InputError(text("'", section, "' has blocks with edges of ",
                            text_of_number(edge.value), ", which follows from ",
                            edge.entry, "; they must be at least ",
                            shortest_edge * size,
                            ", a millionth of the size of the packing."));
}
} // namespace Voussoir
