// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/fields/tables.h>
#include <voussoir/output/vtu/field_arrays.h>
#include <voussoir/output/vtu/interfaces_vtu.h>
#include <voussoir/output/vtu/vtu_values.h>

#include <algorithm>
#include <cstdint>

namespace Voussoir
{
using VtuValues::vector;

namespace
{
/** A grid of one line for each interface. */
VtuFile lines_of(const std::vector<Packing<2>::Interface> &interfaces)
{
  const auto points = [&](std::size_t p, std::size_t end, double *place) {
    for (; p < end; ++p)
    {
      const Packing<2>::Interface &i = interfaces[p / 2];
      const auto x = vector(p % 2 == 0 ? i.start : i.end);
      place = std::copy(x.begin(), x.end(), place);
    }
  };
  const auto ends = [](std::size_t e, std::size_t end, std::int64_t *place) {
    for (; e < end; ++e)
      *place++ = 2 * (e + 1);
  };
  return VtuFile::separate(VtuFile::Shape::line,
                           {2 * interfaces.size(), points},
                           {interfaces.size(), ends});
}
} // namespace

void write_interfaces_vtu(std::ostream &out, const Results &results)
{
  VtuFile file = lines_of(results.scene.packing.interfaces());
  add_fields(file, interface_fields().arrays(results));
  file.write(out);
}

void write_mechanism_joints_vtu(std::ostream &out,
                                const Scene &scene,
                                const Motion &motion)
{
  const MovingScene moving(scene, motion);
  VtuFile file = lines_of(scene.packing.interfaces());
  add_fields(file, mechanism_joint_fields().arrays(moving));
  file.write(out);
}
} // namespace Voussoir
