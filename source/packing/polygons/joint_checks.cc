// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/geometry.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/convex_overlap.h>
#include <voussoir/packing/convex_pieces.h>
#include <voussoir/packing/polygons/joint_checks.h>
#include <voussoir/packing/polygons/polygon_checks.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace Voussoir
{
namespace
{
using dealii::Point;
using dealii::Tensor;
using Ring = std::vector<Point<2>>;
using Box = dealii::BoundingBox<2>;

/** The largest joint width over the mean size of a block. */
constexpr double largest_width = 2. / 3.;

/** The root of the area of a cell; a length. */
double size_of(const PolygonList &polygons, const unsigned int cell)
{
  return std::sqrt(std::abs(signed_area(polygons.polygons[cell].ring)));
}

/** The largest cell that is not larger than the mean, the first of those alike.
 */
unsigned int cell_of_mean_size(const PolygonList &polygons, const double mean)
{
  constexpr double more = 1. + 1e-9; // than rounding: all may be alike
  unsigned int found = 0;
  double largest = 0.;
  for (unsigned int c = 0; c < polygons.polygons.size(); ++c)
  {
    const double size = size_of(polygons, c);
    if (size > more * largest && size <= more * mean)
    {
      found = c;
      largest = size;
    }
  }
  return found;
}

/** "cell 3 (line 4)" */
std::string name_of(const PolygonList &polygons, const unsigned int cell)
{
  return text("cell ", cell, " (", polygons.record_of(cell), ")");
}

/** What must not cross: the strip of a joint, or a part of a block. */
struct Obstacle
{
  /** One cell of a block, or the two of a joint. */
  std::vector<unsigned int> cells;
  /** Convex, counterclockwise. */
  Ring ring;
  /** The least distance between the sides of a joint. */
  double gap = 0.;

  bool is_joint() const { return cells.size() == 2; }
};

/** The strip between two sides of cells; none if they touch. */
std::optional<Obstacle> strip_of(const std::array<unsigned int, 2> &pair,
                                 const CellLoops &cells,
                                 const double tolerance)
{
  Obstacle strip;
  std::array<std::array<Point<2>, 2>, 2> ends;
  for (unsigned int k = 0; k < 2; ++k)
  {
    const unsigned int c = cells.cell_of_side(pair[k]);
    strip.cells.push_back(c);
    for (unsigned int end = 0; end < 2; ++end)
      ends[k][end] = cells.vertex(c, pair[k] - cells.first[c] + end);
  }
  const auto &[one, other] = ends;
  const Tensor<1, 2> along = (one[1] - one[0]) / one[0].distance(one[1]);
  const double at_start = cross(other[1] - one[0], along),
               at_end = cross(other[0] - one[1], along);
  strip.gap = std::min(at_start, at_end);
  if (!(std::max(at_start, at_end) > tolerance))
    return {};
  strip.ring.push_back(one[0]);
  if (at_start > tolerance)
    strip.ring.push_back(other[1]);
  if (at_end > tolerance)
    strip.ring.push_back(other[0]);
  strip.ring.push_back(one[1]);
  return strip;
}

/** The strips of all joints, and behind them all blocks in convex pieces. */
std::vector<Obstacle> obstacles_of(const PolygonList &polygons,
                                   const CellLoops &cells,
                                   const double tolerance)
{
  std::vector<Obstacle> obstacles;
  for (const auto &pair : cells.facing)
    if (auto strip = strip_of(pair, cells, tolerance))
      obstacles.push_back(std::move(*strip));
  for (unsigned int c = 0; c < polygons.polygons.size(); ++c)
  {
    const Ring &ring = polygons.polygons[c].ring;
    for (const std::vector<unsigned int> &numbers : convex_pieces(ring))
    {
      Ring piece;
      for (const unsigned int v : numbers)
        piece.push_back(ring[v]);
      obstacles.push_back({{c}, piece});
    }
  }
  return obstacles;
}

/** A fault of a joint. */
DrawingFault fault_of(const PolygonList &polygons,
                      const Obstacle &joint,
                      const std::string &fault)
{
  Point<2> sum;
  for (const Point<2> &p : joint.ring)
    sum += p;
  const unsigned int c = joint.cells[0];
  DrawingFault found = polygons.fault(
      DrawingFault::Kind::impossible_joint, c,
      text("faces ", name_of(polygons, joint.cells[1]), " across ", joint.gap,
           " at ", text_of_point(sum / static_cast<double>(joint.ring.size())),
           ", ", fault));
  found.cells = joint.cells;
  found.size = joint.gap;
  found.outline = joint.ring;
  return found;
}

/** That there is room for another block between the two of a joint. */
void check_room(const PolygonList &polygons, const Obstacle &joint)
{
  const bool first_is_larger =
      size_of(polygons, joint.cells[0]) >= size_of(polygons, joint.cells[1]);
  const unsigned int larger = joint.cells[first_is_larger ? 0 : 1];
  const double size = size_of(polygons, larger);
  if (joint.gap > size)
    throw fault_of(polygons, joint,
                   text("more than the size ", size, " of ",
                        name_of(polygons, larger),
                        ", the root of its area, so that this is an opening "
                        "rather than a joint; lower 'Packing/polygons/Joint "
                        "width', or draw what is between them."));
}

/** That a joint and what it crosses, which may each reach too far by the
 * tolerance, cannot both be. */
void check_crossing(const PolygonList &polygons,
                    const Obstacle &joint,
                    const Obstacle &other,
                    const double tolerance)
{
  const double deepest = 2. * tolerance;
  if (!(overlap_depth(joint.ring, other.ring, deepest) > deepest))
    return;
  const std::string crossed = name_of(polygons, other.cells[0]);
  throw fault_of(
      polygons, joint,
      other.is_joint()
          ? text("and in the same place ", crossed, " faces ",
                 name_of(polygons, other.cells[1]), " across ", other.gap,
                 ", so that either may be the joint; lower 'Packing/polygons/"
                 "Joint width', or draw what is between them.")
          : text("but ", crossed,
                 " lies between them; lower 'Packing/"
                 "polygons/Joint width', or redraw them."));
}
} // namespace

void check_joint_width(const PolygonList &polygons,
                       const double joint_width,
                       const double scale)
{
  const double mean = mean_size(polygons);
  const double limit = largest_width * mean;
  if (joint_width <= limit)
    return;
  const unsigned int c = cell_of_mean_size(polygons, mean);
  const double in_file = joint_width * scale;
  throw InputError(text(
      "'Packing/polygons/Joint width' = '", joint_width,
      "' is more than two thirds of the mean size ", mean,
      " of a block, the root of its area, which ", name_of(polygons, c), " at ",
      text_of_point(polygons.polygons[c].ring[0]), " has with ",
      size_of(polygons, c),
      ": blocks would be joined across openings. Give the width of the widest "
      "joint",
      scale != 1. && in_file <= limit
          ? text(": it is a length after 'Scale' = '", scale, "', and ",
                 joint_width, " in the drawing is ", in_file, " there.")
          : "."));
}

void check_joints(PolygonList &polygons,
                  const CellLoops &cells,
                  const double tolerance)
{
  const std::vector<Obstacle> obstacles =
      obstacles_of(polygons, cells, tolerance);
  std::vector<Box> boxes;
  boxes.reserve(obstacles.size());
  for (const Obstacle &obstacle : obstacles)
    boxes.emplace_back(obstacle.ring);
  const auto tree = dealii::pack_rtree_of_indices(boxes);
  std::vector<std::size_t> near;
  for (std::size_t i = 0; i < obstacles.size() && obstacles[i].is_joint(); ++i)
  {
    polygons.passes([&] { check_room(polygons, obstacles[i]); });
    near.clear();
    tree.query(boost::geometry::index::intersects(boxes[i]),
               std::back_inserter(near));
    std::sort(near.begin(), near.end()); // so that messages do not depend on it
    for (const std::size_t j : near)
      if (j > i)
        polygons.passes([&] {
          check_crossing(polygons, obstacles[i], obstacles[j], tolerance);
        });
  }
}
} // namespace Voussoir
