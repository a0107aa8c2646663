// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/invalid_index.h>
#include <voussoir/packing/polygons/crossing_pairs.h>
#include <voussoir/packing/polygons/facing_sides.h>
#include <voussoir/packing/polygons/joint_checks.h>

#include <algorithm>
#include <array>
#include <utility>

namespace Voussoir
{
namespace
{
using dealii::Point;

/** The pairs of sides that face each other with nothing between them. */
std::vector<SidePair> find_pairs(const std::vector<PolygonSide> &sides,
                                 const FacingLimits &limits)
{
  const SideTree tree(sides, limits.tolerance);
  std::vector<SidePair> pairs;
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (const std::size_t j : tree.near(i, limits.joint_width))
      if (sides[i].cell < sides[j].cell)
        if (const auto pair = facing_pair(sides, {{i, j}}, limits))
          for (const SidePair &part : tree.uncovered(*pair))
            pairs.push_back(part);
  return without_crossings(pairs, limits.tolerance);
}

/** Finds the joints of one list; one object, used once. */
class SideJoiner
{
public:
  SideJoiner(PolygonList &polygons, const FacingLimits &limits)
      : polygons(polygons), limits(limits), sides(sides_of(polygons)),
        joints(find_pairs(sides, limits))
  {}

  CellLoops join()
  {
    part_joints();
    CellLoops cells = cut();
    check_joints(polygons, cells, limits.tolerance);
    polygons.refuse_faults();
    return cells;
  }

private:
  /** A joint as one of its two sides sees it. */
  struct Part
  {
    std::size_t joint;
    unsigned int k;
    double begin, end; ///< distances from the start of the side
    double length() const { return end - begin; }
  };

  /** The joints along each side, in their order along it. */
  std::vector<std::vector<Part>> parts() const
  {
    std::vector<std::vector<Part>> of_side(sides.size());
    for (std::size_t e = 0; e < joints.size(); ++e)
      for (unsigned int k = 0; k < 2; ++k)
      {
        const double a = joints[e].on_side(k, joints[e].low),
                     b = joints[e].on_side(k, joints[e].high);
        of_side[joints[e].side[k]].push_back(
            {e, k, std::min(a, b), std::max(a, b)});
      }
    for (std::vector<Part> &along : of_side)
      std::sort(along.begin(), along.end(), [](const Part &a, const Part &b) {
        return std::make_pair(a.begin, a.end) < std::make_pair(b.begin, b.end);
      });
    return of_side;
  }

  /** Let parts of a side that overlap end midway, all as they were found. */
  void part_joints()
  {
    std::vector<SidePair> parted = joints;
    const auto move_end = [&](const Part &part, const bool is_begin,
                              const double to) {
      const double s = joints[part.joint].coordinate(part.k, to);
      SidePair &joint = parted[part.joint];
      // The coordinate runs against the second side.
      if (is_begin == (part.k == 0))
        joint.low = std::max(joint.low, s);
      else
        joint.high = std::min(joint.high, s);
    };
    for (const std::vector<Part> &along : parts())
      for (auto one = along.begin(); one != along.end(); ++one)
        for (auto next = one + 1; next != along.end() && next->begin < one->end;
             ++next)
        {
          const double common = std::min(one->end, next->end) - next->begin;
          const Part &shorter = one->length() < next->length() ? *one : *next;
          if (common > 0.5 * shorter.length())
            parted[shorter.joint].high = parted[shorter.joint].low;
          else
          {
            const double middle = next->begin + 0.5 * common;
            move_end(*one, false, middle);
            move_end(*next, true, middle);
          }
        }
    const auto has_vanished = [this](const SidePair &joint) {
      return !(joint.length() > limits.tolerance);
    };
    parted.erase(std::remove_if(parted.begin(), parted.end(), has_vanished),
                 parted.end());
    joints = std::move(parted);
  }

  /** The loops with the ends of all joints as vertices. */
  CellLoops cut() const
  {
    CellLoops cells;
    std::vector<std::array<unsigned int, 2>> side_of_joint(
        joints.size(), {{invalid_index, invalid_index}});
    std::vector<unsigned int> loop;
    const auto add_vertex = [&](const Point<2> &p) {
      loop.push_back(cells.vertices.size());
      cells.vertices.push_back(p);
    };
    const std::vector<std::vector<Part>> of_side = parts();
    for (std::size_t s = 0; s < sides.size(); ++s)
    {
      const PolygonSide &side = sides[s];
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
      for (const Part &part : of_side[s])
      {
        add_cut(part.begin);
        side_of_joint[part.joint][part.k] =
            cells.loops.size() + loop.size() - 1;
        add_cut(part.end);
      }
    }
    cells.add(loop);
    for (const auto &pair : side_of_joint)
      if (pair[0] != invalid_index)
        cells.facing.push_back(pair);
    return cells;
  }

  PolygonList &polygons;
  const FacingLimits &limits;
  const std::vector<PolygonSide> sides;
  std::vector<SidePair> joints;
};
} // namespace

CellLoops join_facing_sides(PolygonList &polygons, const FacingLimits &limits)
{
  return SideJoiner(polygons, limits).join();
}
} // namespace Voussoir
