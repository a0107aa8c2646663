// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/base/none.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polygons/facing_sides.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace Voussoir
{
namespace
{
using dealii::Point;
using dealii::Tensor;
using Box = dealii::BoundingBox<2>;

/** A side of a cell, counterclockwise around it. */
struct Side
{
  unsigned int cell;
  Point<2> start;
  Point<2> end;
  /** The unit vector from start to end. */
  Tensor<1, 2> along;
  double length;
};

/** The sides of all polygons, one after the other. */
std::vector<Side> sides_of(const PolygonList &polygons)
{
  std::vector<Side> sides;
  for (unsigned int c = 0; c < polygons.polygons.size(); ++c)
  {
    const auto &ring = polygons.polygons[c].ring;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const Point<2> &a = ring[i], &b = ring[(i + 1) % ring.size()];
      const double length = a.distance(b);
      sides.push_back({c, a, b, (b - a) / length, length});
    }
  }
  return sides;
}

/**
 * What two sides have in common on the line of their joint, from low to high: a
 * coordinate that begins where the first side does, and runs along with it.
 */
struct Facing
{
  std::array<std::size_t, 2> side;
  /** The coordinate at which each side starts. */
  std::array<double, 2> origin;
  /** Its change along each side over the change of place; of the other side
   * negative. */
  std::array<double, 2> slope;
  double low, high;

  /** The distance from the start of side @p k at coordinate @p s. */
  double on_side(const unsigned int k, const double s) const
  {
    return (s - origin[k]) / slope[k];
  }
  /** The coordinate at the distance @p t from the start of side @p k. */
  double coordinate(const unsigned int k, const double t) const
  {
    return origin[k] + t * slope[k];
  }
};

/** Keep of an interval where a linear function is between two values. */
void clip(double &low,
          double &high,
          const std::array<double, 2> &values,
          const double least,
          const double greatest)
{
  const double slope = (values[1] - values[0]) / (high - low);
  const double start = low;
  for (const auto &[limit, sign] :
       {std::pair(greatest, 1.), std::pair(least, -1.)})
  {
    const double at_low = sign * (values[0] - limit),
                 at_high = sign * (values[1] - limit);
    if (at_low > 0. && at_high > 0.)
      high = low;
    else if (at_low > 0.)
      low = std::max(low, start + (limit - values[0]) / slope);
    else if (at_high > 0.)
      high = std::min(high, start + (limit - values[0]) / slope);
  }
}

/** Where two sides face each other, if they do. */
std::optional<Facing> facing_of(const std::vector<Side> &sides,
                                const std::size_t i,
                                const std::size_t j,
                                const FacingLimits &limits)
{
  const Side &one = sides[i], &other = sides[j];
  // The half of an angle that is small has a sine of full precision.
  const double half_sine = 0.5 * (one.along + other.along).norm();
  if (!(half_sine <= std::sin(0.5 * limits.angle)))
    return {};
  const Tensor<1, 2> sum = one.along - other.along;
  const Tensor<1, 2> along = sum / sum.norm();
  Facing facing = {{{i, j}},
                   {{0., (other.start - one.start) * along}},
                   {{one.along * along, other.along * along}},
                   0.,
                   0.};
  facing.low = std::max(0., facing.coordinate(1, other.length));
  facing.high =
      std::min(facing.coordinate(0, one.length), facing.coordinate(1, 0.));
  if (!(facing.high - facing.low > limits.tolerance))
    return {};
  // The distance from the first side to the second, out of the first's cell.
  const auto gap = [&](const double s) {
    return cross(other.start + facing.on_side(1, s) * other.along -
                     (one.start + facing.on_side(0, s) * one.along),
                 along);
  };
  clip(facing.low, facing.high, {{gap(facing.low), gap(facing.high)}},
       -limits.tolerance, limits.joint_width + limits.tolerance);
  if (!(facing.high - facing.low > limits.tolerance))
    return {};
  return facing;
}

/** Finds the joints of one list; one object, used once. */
class SideJoiner
{
public:
  SideJoiner(PolygonList &polygons, const FacingLimits &limits)
      : polygons(polygons), limits(limits), sides(sides_of(polygons)),
        on_side(sides.size())
  {}

  CellLoops join()
  {
    find_joints();
    for (std::size_t s = 0; s < sides.size(); ++s)
      polygons.passes([&] { part(s); });
    polygons.refuse_faults();
    return cut();
  }

private:
  /** A joint as one of its two sides sees it. */
  struct Part
  {
    std::size_t joint;
    unsigned int k;
    double begin, end; ///< distances from the start of the side
  };

  void find_joints()
  {
    std::vector<Box> boxes;
    for (const Side &side : sides)
    {
      boxes.emplace_back(std::array<Point<2>, 2>{{side.start, side.end}});
      boxes.back().extend(limits.tolerance);
    }
    const auto tree = dealii::pack_rtree_of_indices(boxes);
    std::vector<std::size_t> near;
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      near.clear();
      Box box = boxes[i];
      box.extend(limits.joint_width);
      tree.query(boost::geometry::index::intersects(box),
                 std::back_inserter(near));
      std::sort(near.begin(), near.end());
      for (const std::size_t j : near)
        if (sides[i].cell < sides[j].cell)
          if (const auto facing = facing_of(sides, i, j, limits))
          {
            on_side[i].push_back(joints.size());
            on_side[j].push_back(joints.size());
            joints.push_back(*facing);
          }
    }
  }

  /** The joints along a side that are left, in their order along it. */
  std::vector<Part> parts(const std::size_t side) const
  {
    std::vector<Part> found;
    for (const std::size_t e : on_side[side])
    {
      const Facing &joint = joints[e];
      if (!(joint.high - joint.low > limits.tolerance))
        continue;
      const unsigned int k = joint.side[0] == side ? 0 : 1;
      const double a = joint.on_side(k, joint.low),
                   b = joint.on_side(k, joint.high);
      found.push_back({e, k, std::min(a, b), std::max(a, b)});
    }
    std::sort(found.begin(), found.end(), [](const Part &a, const Part &b) {
      return std::make_pair(a.begin, a.end) < std::make_pair(b.begin, b.end);
    });
    return found;
  }

  /** Let the joints along a side end where the next begins. */
  void part(const std::size_t side)
  {
    std::vector<Part> found = parts(side);
    for (std::size_t i = 0; i + 1 < found.size();)
    {
      Part &one = found[i], &next = found[i + 1];
      const double common = std::min(one.end, next.end) - next.begin;
      const bool first_is_shorter = one.end - one.begin < next.end - next.begin;
      Part &shorter = first_is_shorter ? one : next;
      const double length = shorter.end - shorter.begin;
      if (!(common > 0.))
        ++i;
      else if (common > 0.5 * std::min(length, limits.joint_width) &&
               length > limits.joint_width)
        refuse(side, one, next);
      else if (common > 0.5 * length)
      {
        // The corner of a neighbour.
        joints[shorter.joint].high = joints[shorter.joint].low;
        found.erase(found.begin() + i + (first_is_shorter ? 0 : 1));
        i -= i > 0;
      }
      else
      {
        const double middle = next.begin + 0.5 * common;
        move_end(one, one.end, middle);
        move_end(next, next.begin, middle);
        ++i;
      }
    }
  }

  /** Move the end @p from of a part to @p to, on both sides of its joint. */
  void move_end(Part &part, double &from, const double to)
  {
    const bool is_begin = &from == &part.begin;
    from = to;
    Facing &joint = joints[part.joint];
    const double s = joint.coordinate(part.k, to);
    // The coordinate runs against the second side.
    (is_begin == (part.k == 0) ? joint.low : joint.high) = s;
  }

  [[noreturn]] void
  refuse(const std::size_t side, const Part &one, const Part &next) const
  {
    const auto other = [&](const Part &part) {
      const unsigned int c = sides[joints[part.joint].side[1 - part.k]].cell;
      return text("cell ", c, " (", polygons.record_name, ' ',
                  polygons.polygons[c].record, ")");
    };
    polygons.refuse(
        DrawingFault::Kind::hidden_cell, sides[side].cell,
        text("faces both ", other(one), " and ", other(next), " at ",
             text_of_point(sides[side].start + next.begin * sides[side].along),
             " within the joint width ", limits.joint_width,
             ", so that one of them lies behind the other; lower the joint "
             "width, or redraw them."));
  }

  /** The loops with the ends of all joints as vertices. */
  CellLoops cut() const
  {
    CellLoops cells;
    std::vector<std::array<unsigned int, 2>> side_of_joint(joints.size(),
                                                           {{none, none}});
    std::vector<unsigned int> loop;
    const auto add_vertex = [&](const Point<2> &p) {
      loop.push_back(cells.vertices.size());
      cells.vertices.push_back(p);
    };
    for (std::size_t s = 0; s < sides.size(); ++s)
    {
      const Side &side = sides[s];
      if (s > 0 && sides[s - 1].cell != side.cell)
      {
        cells.add(loop);
        loop.clear();
      }
      add_vertex(side.start);
      double last = 0.;
      const auto add_cut = [&](const double at) {
        if (at - last > limits.tolerance && side.length - at > limits.tolerance)
        {
          add_vertex(side.start + at * side.along);
          last = at;
        }
      };
      for (const Part &part : parts(s))
      {
        add_cut(part.begin);
        side_of_joint[part.joint][part.k] =
            cells.loops.size() + loop.size() - 1;
        add_cut(part.end);
      }
    }
    cells.add(loop);
    for (const auto &pair : side_of_joint)
      if (pair[0] != none)
        cells.facing.push_back(pair);
    return cells;
  }

  PolygonList &polygons;
  const FacingLimits &limits;
  const std::vector<Side> sides;
  std::vector<Facing> joints;
  /** The joints along each side. */
  std::vector<std::vector<std::size_t>> on_side;
};
} // namespace

CellLoops join_facing_sides(PolygonList &polygons, const FacingLimits &limits)
{
  return SideJoiner(polygons, limits).join();
}
} // namespace Voussoir
