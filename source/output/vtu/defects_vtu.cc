// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/invalid_index.h>
#include <voussoir/output/vtu/defects_vtu.h>
#include <voussoir/output/vtu/vtu_file.h>
#include <voussoir/output/vtu/vtu_values.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <numeric>

namespace Voussoir
{
bool have_places(const std::vector<CellDefect> &defects)
{
  return std::any_of(defects.begin(), defects.end(),
                     [](const CellDefect &d) { return d.has_place(); });
}

void write_defects_vtu(std::ostream &out,
                       const std::vector<CellDefect> &defects)
{
  std::vector<CellDefect> placed;
  std::copy_if(defects.begin(), defects.end(), std::back_inserter(placed),
               [](const CellDefect &d) { return d.has_place(); });
  VtuFile file = VtuFile::separate(
      VtuFile::Shape::vertex,
      {placed.size(),
       [&placed](std::size_t i, const std::size_t end, double *place) {
         for (; i < end; ++i)
           place = std::copy(placed[i].place.begin_raw(),
                             placed[i].place.end_raw(), place);
       }},
      {placed.size(), [](auto begin, auto end, std::int64_t *place) {
         std::iota(place, place + (end - begin), begin + 1);
       }});
  const auto add = [&](const std::string &name, const auto &value) {
    VtuValues::add_cell_field(file, name, [&placed, value](std::size_t i) {
      return VtuValues::scalar(value(placed[i]));
    });
  };
  using Number = std::int32_t;
  add("kind", [](const CellDefect &d) -> Number { return d.kind; });
  add("cell", [](const CellDefect &d) -> Number { return d.cell; });
  add("face", [](const CellDefect &d) -> Number {
    return d.face == invalid_index ? -1 : static_cast<Number>(d.face);
  });
  add("count", [](const CellDefect &d) -> Number { return d.count; });
  add("size", [](const CellDefect &d) { return d.size; });
  file.write(out);
}
} // namespace Voussoir
