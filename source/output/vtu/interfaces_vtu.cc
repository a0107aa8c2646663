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
/** A grid of one line for each of @p list, between two members of it. */
template <typename Element, typename Place>
VtuFile lines_of(const std::vector<Element> &list,
                 Place Element::*const start,
                 Place Element::*const end_of_line)
{
  const auto points = [&list, start, end_of_line](
                          std::size_t p, std::size_t end, double *place) {
    for (; p < end; ++p)
    {
      const auto x = vector(list[p / 2].*(p % 2 == 0 ? start : end_of_line));
      place = std::copy(x.begin(), x.end(), place);
    }
  };
  const auto ends = [](std::size_t e, std::size_t end, std::int64_t *place) {
    for (; e < end; ++e)
      *place++ = 2 * (e + 1);
  };
  return VtuFile::separate(VtuFile::Shape::line, {2 * list.size(), points},
                           {list.size(), ends});
}

VtuFile interfaces_of(const Scene &scene)
{
  using Interface = Packing<2>::Interface;
  return lines_of(scene.packing.interfaces(), &Interface::start,
                  &Interface::end);
}

VtuFile links_of(const Scene &scene)
{
  return lines_of(scene.links, &Link::on_minus, &Link::on_plus);
}

void write(std::ostream &out, VtuFile file, const BoundFields &arrays)
{
  add_fields(file, arrays);
  file.write(out);
}
} // namespace

void write_interfaces_vtu(std::ostream &out, const Results &results)
{
  write(out, interfaces_of(results.scene), interface_fields().arrays(results));
}

void write_mechanism_joints_vtu(std::ostream &out,
                                const Scene &scene,
                                const Motion &motion)
{
  write(out, interfaces_of(scene),
        mechanism_joint_fields().arrays(MovingScene(scene, motion)));
}

void write_links_vtu(std::ostream &out, const Results &results)
{
  write(out, links_of(results.scene), link_fields().arrays(results));
}

void write_mechanism_links_vtu(std::ostream &out,
                               const Scene &scene,
                               const Motion &motion)
{
  write(out, links_of(scene),
        mechanism_link_fields().arrays(MovingScene(scene, motion)));
}
} // namespace Voussoir
