// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/vtu/drawing_check_vtu.h>
#include <voussoir/output/vtu/vtu_file.h>
#include <voussoir/output/vtu/vtu_values.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace Voussoir
{
namespace
{
using dealii::Point;

/** A polygon of the grid, or a line. */
struct Shape
{
  std::vector<Point<2>> ring;
  std::int32_t cell;
  std::int32_t fault;
  double size;
  bool is_line = false;

  bool can_be_drawn() const { return ring.size() > (is_line ? 1 : 2); }
};

std::int32_t number_of(const DrawingFault::Kind kind)
{
  return static_cast<std::int32_t>(kind) + 1;
}

/** The cells and, over them, what overlaps and gaps cover and open lines. */
std::vector<Shape> shapes_of(const DrawingCheck &check)
{
  std::vector<Shape> shapes;
  for (std::size_t c = 0; c < check.rings.size(); ++c)
    shapes.push_back({check.rings[c], static_cast<std::int32_t>(c), 0, 0.});
  for (const DrawingFault &fault : check.faults)
    for (const unsigned int c : fault.cells)
      // The first fault of a cell is the most severe.
      if (c < check.rings.size() && shapes[c].fault == 0)
      {
        shapes[c].fault = number_of(fault.kind);
        shapes[c].size = fault.size;
      }
  for (const DrawingFault &fault : check.faults)
  {
    shapes.push_back({fault.outline, -1, number_of(fault.kind), fault.size});
    shapes.push_back({fault.line, -1, number_of(fault.kind), fault.size, true});
  }
  shapes.erase(std::remove_if(shapes.begin(), shapes.end(),
                              [](const Shape &s) { return !s.can_be_drawn(); }),
               shapes.end());
  return shapes;
}
} // namespace

void write_drawing_check_vtu(std::ostream &out, const DrawingCheck &check)
{
  const std::vector<Shape> shapes = shapes_of(check);
  std::vector<std::int64_t> ends;
  std::vector<Point<2>> points;
  for (const Shape &shape : shapes)
  {
    points.insert(points.end(), shape.ring.begin(), shape.ring.end());
    ends.push_back(points.size());
  }
  VtuFile file = VtuFile::separate(
      VtuFile::Shape::polygon,
      {points.size(),
       [&points](std::size_t i, const std::size_t end, double *place) {
         for (; i < end; ++i)
         {
           const auto x = VtuValues::vector(points[i]);
           place = std::copy(x.begin(), x.end(), place);
         }
       }},
      {ends.size(), [&ends](auto begin, auto end, std::int64_t *place) {
         std::copy(ends.begin() + begin, ends.begin() + end, place);
       }});
  file.set_shapes([&shapes](auto begin, auto end, std::uint8_t *types) {
    for (; begin < end; ++begin)
      *types++ = static_cast<std::uint8_t>(shapes[begin].is_line
                                               ? VtuFile::Shape::polyline
                                               : VtuFile::Shape::polygon);
  });
  const auto add = [&](const std::string &name, const auto &value) {
    VtuValues::add_cell_field(file, name, [&shapes, value](std::size_t i) {
      return VtuValues::scalar(value(shapes[i]));
    });
  };
  add("cell", [](const Shape &shape) { return shape.cell; });
  add("fault", [](const Shape &shape) { return shape.fault; });
  add("size", [](const Shape &shape) { return shape.size; });
  file.write(out);
}

DrawingCheck check_of_gaps(const Packing<2> &packing)
{
  DrawingCheck check;
  check.rings.resize(packing.n_cells());
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
      check.rings[c].push_back(packing.vertex(c, i));
  for (const Gap &gap : packing.gaps())
  {
    DrawingFault fault(DrawingFault::Kind::gap, {gap.cells[0], gap.cells[1]},
                       "");
    fault.size = gap.width;
    fault.outline.assign(gap.outline.begin(), gap.outline.end());
    check.faults.push_back(fault);
  }
  return check;
}
} // namespace Voussoir
