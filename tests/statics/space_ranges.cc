// SPDX-License-Identifier: LGPL-2.1-or-later

// Ranges of forces over all states in space, and supports that move: those of
// extruded scenes are those in the plane times the thickness; one block has its
// closed forms; what is clamped has no bound.

#include <voussoir/analyses/ranges/ranges.h>
#include <voussoir/analyses/ranges/settlement.h>
#include <voussoir/analyses/ranges/space_ranges.h>
#include <voussoir/scene/proofs/reactions.h>

#include "extruded_scenes.h"
#include <limits>
#include <map>

namespace test_space_ranges
{
using namespace Voussoir;

/** A carried scene with its weight and some push, of one of the laws. */
Laws laws_of(const unsigned int k)
{
  Laws laws = {k % 3 == 0 ? 0. : 1.5,
               k % 3 == 1 ? 0. : 0.7,
               k % 3 == 2 ? 1. : 0.,
               k % 2 == 0,
               {},
               {}};
  laws.dead[0] = 0.05;
  laws.dead[1] = -1.;
  return laws;
}

Packing<2> packing_of(const unsigned int k)
{
  // Grains at the sides do not stay without tension.
  return on_foot(k % 3 < 2 ? wall(3, 3, 2., 1.) : random_packing(10, k + 1));
}

/** The interface in space of each interface in the plane. */
std::vector<unsigned int> faces_of(const Packing<2> &plane,
                                   const Packing<3> &space)
{
  std::map<std::pair<unsigned int, unsigned int>, unsigned int> by_cells;
  for (unsigned int e = 0; e < space.interfaces().size(); ++e)
  {
    const auto &i = space.interfaces()[e];
    by_cells[{i.cell_minus, i.cell_plus}] = e;
  }
  std::vector<unsigned int> faces;
  for (const auto &i : plane.interfaces())
    faces.push_back(by_cells.at({i.cell_minus, i.cell_plus}));
  return faces;
}

/** The largest difference of a range, the plane's times a factor. */
double difference(const Range &space, const Range &plane, const double factor)
{
  const double ends[] = {factor * plane.least, factor * plane.greatest};
  return std::max(std::abs(space.least - std::min(ends[0], ends[1])),
                  std::abs(space.greatest - std::max(ends[0], ends[1])));
}

void ranges_of_extruded_scenes()
{
  double largest = 0., of_reactions = 0., error = 0., width = 0.;
  unsigned int n_compared = 0;
  for (unsigned int k = 0; k < 12; ++k)
  {
    const Laws laws = laws_of(k);
    const Packing<2> packing = packing_of(k);
    const Scene in_plane = scene_in_plane(packing, laws, laws.dead);
    const SpaceCase of = in_space(packing, laws);
    const SpaceScene scene(of.blocks(),
                           body_force(of.packing, upright(laws.dead)));
    const std::size_t n = packing.interfaces().size();
    const RangesWanted wanted = {std::vector<bool>(n, true), true};
    const Ranges plane = find_ranges(in_plane, wanted, Terminal::silent());
    const SpaceRanges space = find_ranges(scene, wanted, Terminal::silent());
    const std::vector<unsigned int> faces = faces_of(packing, of.packing);
    for (unsigned int e = 0; e < n; ++e)
    {
      const unsigned int f = faces[e];
      if (plane.is_unbounded(e) || space.is_unbounded(f))
      {
        check("both without bound",
              plane.is_unbounded(e) == space.is_unbounded(f));
        continue;
      }
      ++n_compared;
      largest = std::max(
          largest, difference(space.normal[f], plane.normal[e], thickness));
      const dealii::Tensor<1, 2> t = packing.interfaces()[e].tangent();
      const unsigned int i = std::abs(t[0]) > std::abs(t[1]) ? 0 : 1;
      largest =
          std::max(largest, difference(space.shear[f][2 * i],
                                       plane.tangential[e], t[i] * thickness));
    }
    check("supports", space.reactions.size() == plane.reactions.size());
    for (unsigned int s = 0; s < plane.reactions.size(); ++s)
      for (unsigned int i = 0; i < 2; ++i)
        of_reactions = std::max(of_reactions,
                                difference(space.reactions[s][2 * i],
                                           plane.reactions[s][i], thickness));
    error = std::max(error, space.proofs.error_of_states);
    width = std::max(width, space.proofs.width / space.reference);
  }
  check("interfaces that were compared", n_compared > 150);
  check_error("ranges of forces", largest, 1e-7);
  check_error("ranges of reactions", of_reactions, 1e-7);
  check_error("states that attain them", error, 1e-9);
  check_error("width of proofs", width, 1e-6);
}

/** A box of 1 x 0.5 x 0.5 that weighs 0.25, on the ground. */
SpaceCase box()
{
  CellFaces cells;
  add_box(cells, {0., 0., 0.}, {1., 0.5, 0.5});
  return SpaceCase(Packing<3>(cells));
}

void one_block()
{
  SpaceCase of = box();
  of.mu = 0.6;
  const SpaceLoads weight = body_force(of.packing, vector(0.2, 0., -1.));
  const SpaceScene scene(of.blocks(), weight);
  const RangesWanted wanted = {{true}, true};
  const SpaceRanges found = find_ranges(scene, wanted, Terminal::silent());
  check("one block on the ground is determined", found.is_determined(0));
  check_error("  its normal force", std::abs(found.normal[0].least + 0.25),
              1e-9);
  check_error("  its shear force", std::abs(found.shear[0][0].greatest + 0.05),
              1e-9);
  check_error("  its reaction", std::abs(found.reactions[0][2].greatest - 0.25),
              1e-9);
  // Held between two sides as well, they press it with any force.
  SpaceCase held = box();
  CellFaces cells;
  add_box(cells, {0., 0., 0.}, {1., 0.5, 0.5});
  held.packing = Packing<3>(cells);
  std::vector<bool> sides;
  for (const auto &face : held.packing.boundary_faces())
    sides.push_back(std::abs(face.normal[0]) > 0.5);
  held.packing.support(sides);
  held.mu = 0.6;
  const SpaceScene clamped(held.blocks(),
                           body_force(held.packing, vector(0., 0., -1.)));
  const SpaceRanges any =
      find_ranges(clamped, {{true, true}, false}, Terminal::silent());
  check("a clamped block is pressed without bound",
        any.is_unbounded(0) && any.is_unbounded(1) &&
            any.normal[0].least == -std::numeric_limits<double>::infinity());
  // Each side bears at most mu N, and at least what the other one cannot.
  check_error("  and at least by its weight over 2 mu",
              std::abs(any.normal[0].greatest + 0.25 / (2. * 0.6)), 1e-9);
}

/**
 * Two blocks on the ground between two sides, which may press them with any
 * force or with none: many states have the least pressure, of any size
 * elsewhere.
 */
void two_blocks_between_sides()
{
  CellFaces cells;
  add_box(cells, {0., 0., 0.}, {1., 0.5, 0.5});
  add_box(cells, {1., 0., 0.}, {2., 0.5, 0.5});
  SpaceCase of{Packing<3>(cells)};
  of.packing = Packing<3>(cells);
  std::vector<bool> is_held;
  for (const auto &face : of.packing.boundary_faces())
    is_held.push_back(std::abs(face.normal[0]) > 0.5 || face.normal[2] < -0.5);
  of.packing.support(is_held);
  of.mu = 1.;
  const SpaceScene scene(of.blocks(),
                         body_force(of.packing, vector(0., 0., -1.)));
  const std::size_t n = of.packing.interfaces().size();
  const SpaceRanges found = find_ranges(
      scene, {std::vector<bool>(n, true), false}, Terminal::silent());
  double least = 0.;
  for (unsigned int e = 0; e < n; ++e)
  {
    check("pressed without bound", found.is_unbounded(e));
    least = std::max(least, std::abs(found.normal[e].greatest));
  }
  check_error("or not at all", least, 1e-6);
}

/** A fall of the right half of the ground. */
void settlements_of_extruded_scenes()
{
  double work = 0., closing = 0., error = 0., width = 0.;
  for (unsigned int k = 0; k < 8; ++k)
  {
    Laws laws = laws_of(k);
    laws.turns = true;
    const Packing<2> packing = packing_of(k);
    const SpaceCase of = in_space(packing, laws);
    double right = 0.;
    for (const auto &i : packing.interfaces())
      right = std::max(right, i.midpoint()[0]);
    std::vector<SupportMotion> plane;
    std::vector<SpaceSupportMotion> space;
    const auto falls = [&](const double x) { return x > 0.5 * right; };
    const unsigned int n = packing.n_supports();
    for (unsigned int s = 0; s < n; ++s)
    {
      const auto &i = *(packing.interfaces().end() - n + s);
      plane.push_back({});
      plane.back().displacement[1] = falls(i.midpoint()[0]) ? -0.01 : 0.;
      const auto &f = *(of.packing.interfaces().end() - n + s);
      space.push_back({});
      space.back().displacement[2] = falls(f.centroid[0]) ? -0.01 : 0.;
    }
    const Settlement in_plane =
        find_settlement(scene_in_plane(packing, laws, laws.dead), plane);
    const SpaceScene scene(of.blocks(),
                           body_force(of.packing, upright(laws.dead)));
    const auto found = find_settlement(scene, space);
    work = std::max(work, std::abs(found.work - thickness * in_plane.work));
    closing = std::max(closing, found.closing_violation);
    error = std::max(error, certify(scene, found.forces).error());
    width = std::max(width, std::abs(found.width));
    // The blocks on it follow it, since nothing holds them up.
    check("a motion", found.motion.displacement.size() == packing.n_cells());
  }
  check_error("work of the ground", work, 1e-9);
  check_error("joints close", closing, 1e-9);
  check_error("states", error, 1e-9);
  check_error("width", width, 1e-9);
}

void run()
{
  ranges_of_extruded_scenes();
  one_block();
  two_blocks_between_sides();
  settlements_of_extruded_scenes();
}

const RoomTest test("space_ranges", run);
} // namespace test_space_ranges
