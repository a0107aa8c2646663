// SPDX-License-Identifier: LGPL-2.1-or-later

// Stones that cannot be seen whole from their centre: convex pieces cover them
// and form a tree; L-shaped stones carry what pairs of rectangles with joints
// of any strength carry; the stress of the pieces meets the tractions, is in
// balance piece by piece, continuous across the cuts, and has the mean that the
// forces have; a uniform stress comes back; a body force is integrated exactly.

#include <voussoir/analyses/factors/load_factor.h>
#include <voussoir/analyses/ranges/ranges.h>
#include <voussoir/base/geometry.h>
#include <voussoir/packing/convex_pieces.h>
#include <voussoir/packing/polygons/matching.h>
#include <voussoir/stress/cell_means.h>
#include <voussoir/stress/cell_pieces.h>
#include <voussoir/stress/reconstruction.h>

#include "polygons.h"
#include "tests.h"
#include <map>

namespace test_concave_stones
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

using Ring = std::vector<Point<2>>;

Packing<2> packing_of(const std::vector<Ring> &rings)
{
  PolygonList polygons = list_of(rings);
  return Packing<2>(match_polygons(polygons, 1e-10));
}

Ring rectangle(const double x, const double y, const double b, const double h)
{
  return {{x, y}, {x + b, y}, {x + b, y + h}, {x, y + h}};
}

/**
 * Long bricks with a short one on their left end, glued to them or not, and
 * bricks beside that. The pairs of courses are shifted.
 *
 * @param pairs takes the numbers of cells that would be glued.
 */
std::vector<Ring> quoins(const bool glued,
                         std::vector<std::array<unsigned int, 2>> &pairs)
{
  std::vector<Ring> rings;
  for (unsigned int level = 0; level < 4; ++level)
    for (unsigned int k = 0; k < 3; ++k)
    {
      const double x = 4. * k + 2. * (level % 2), y = 2. * level;
      if (glued)
        rings.push_back({{x, y},
                         {x + 4., y},
                         {x + 4., y + 1.},
                         {x + 1., y + 1.},
                         {x + 1., y + 2.},
                         {x, y + 2.}});
      else
      {
        const unsigned int n = rings.size();
        pairs.push_back({{n, n + 1}});
        rings.push_back(rectangle(x, y, 4., 1.));
        rings.push_back(rectangle(x, y + 1., 1., 1.));
      }
      rings.push_back(rectangle(x + 1., y + 1., 3., 1.));
    }
  return rings;
}

Loads weight(const Packing<2> &packing, const double x, const double y)
{
  Loads loads;
  loads.traction.resize(packing.boundary_edges().size());
  loads.body = BodyForce(packing, [=](const Point<2> &, unsigned int) {
    return Tensor<1, 2>({x, y});
  });
  return loads;
}

/** The wall under its weight, and a part of it to the right. */
Scene wall_of_quoins(const bool glued,
                     const Kinematics &kinematics,
                     const double mu,
                     const double x,
                     const double y)
{
  std::vector<std::array<unsigned int, 2>> pairs;
  const Packing<2> packing = on_ground(packing_of(quoins(glued, pairs)));
  std::vector<double> strengths(packing.interfaces().size(), 0.4),
      tension(strengths.size(), 0.);
  for (unsigned int e = 0; e < strengths.size(); ++e)
    for (const auto &[a, b] : pairs)
      if (packing.interfaces()[e].cell_minus == a &&
          packing.interfaces()[e].cell_plus == b)
        strengths[e] = tension[e] = 1e3;
  Scene scene(packing, strengths, weight(packing, x, y), kinematics);
  if (!pairs.empty())
    scene.tensile_strength = tension;
  if (mu > 0.)
    scene.coefficient.assign(strengths.size(), mu);
  return scene;
}

/** How much of its weight may push the wall sideways. */
double
factor_of(const bool glued, const Kinematics &kinematics, const double mu)
{
  LoadFactorControls controls;
  controls.tolerance = 1e-10;
  const auto answer =
      find_load_factor(wall_of_quoins(glued, kinematics, mu, 0., -1.),
                       wall_of_quoins(glued, kinematics, mu, 1., 0.), controls,
                       Terminal::silent());
  check_error("  width", answer.factor->width(), 1e-9);
  return answer.factor->carried;
}

/** The ranges of the forces of the ground on each brick. */
Ranges
ranges_of(const bool glued, const Kinematics &kinematics, const double mu)
{
  const Scene scene = wall_of_quoins(glued, kinematics, mu, 0.01, -1.);
  const unsigned int n = scene.packing.interfaces().size();
  RangesWanted wanted = {std::vector<bool>(n, false), false};
  std::fill(wanted.interfaces.end() - scene.packing.n_supports(),
            wanted.interfaces.end(), true);
  return find_ranges(scene, wanted, Terminal::silent());
}

/** The largest difference of ranges of supports, the last ones. */
double difference(const std::vector<Range> &one,
                  const std::vector<Range> &other)
{
  double largest = 0.;
  for (unsigned int k = 1; k <= 3; ++k)
    largest = std::max(
        {largest,
         std::abs(one[one.size() - k].least - other[other.size() - k].least),
         std::abs(one[one.size() - k].greatest -
                  other[other.size() - k].greatest)});
  return largest;
}

void glued_pairs()
{
  for (const Kinematics *kinematics : {&translations(), &rotations()})
    for (const double mu : {0., 0.5})
    {
      std::cout << kinematics->name() << ", mu = " << mu << std::endl;
      const double glued = factor_of(true, *kinematics, mu);
      const double strong = factor_of(false, *kinematics, mu);
      check_error("  L-shaped or of any strength",
                  std::abs(glued - strong) / glued, 1e-9);
      std::cout << "  factor " << glued << std::endl;
      const Ranges of_glued = ranges_of(true, *kinematics, mu);
      const Ranges of_strong = ranges_of(false, *kinematics, mu);
      check_error("  least and greatest normal forces",
                  difference(of_glued.normal, of_strong.normal), 1e-9 * 4.);
      check_error("  and tangential ones",
                  difference(of_glued.tangential, of_strong.tangential),
                  1e-9 * 4.);
      std::cout << "  the first from " << -of_glued.normal.end()[-3].greatest
                << " to " << -of_glued.normal.end()[-3].least << std::endl;
    }
}

/** Shapes with hidden sides, each alone. */
std::vector<std::pair<std::string, Ring>> shapes()
{
  return {
      {"L", {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 2}, {0, 2}}},
      {"U", {{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {1, 1}, {1, 3}, {0, 3}}},
      {"comb",
       {{0, 0},
        {7, 0},
        {7, 2},
        {6, 2},
        {6, 1},
        {5, 1},
        {5, 2.5},
        {4, 2.5},
        {4, 1},
        {3, 1},
        {3, 2},
        {2, 2},
        {2, 1},
        {1, 1},
        {1, 3},
        {0, 3}}},
      {"skew", {{0, 0}, {6, -1}, {5.5, 0.2}, {1.3, 0.9}, {2, 4}, {0.4, 3.7}}}};
}

void pieces_cover()
{
  for (const auto &[name, ring] : shapes())
  {
    std::map<std::pair<unsigned int, unsigned int>, unsigned int> sides;
    double area = 0.;
    bool convex = true;
    const auto pieces = convex_pieces(ring);
    for (const auto &piece : pieces)
    {
      Ring of_piece;
      for (std::size_t k = 0; k < piece.size(); ++k)
      {
        of_piece.push_back(ring[piece[k]]);
        ++sides[std::minmax(piece[k], piece[(k + 1) % piece.size()])];
      }
      for (std::size_t k = 0; k < piece.size(); ++k)
        convex &= cross(of_piece[(k + 1) % piece.size()] - of_piece[k],
                        of_piece[(k + 2) % piece.size()] - of_piece[k]) >= 0.;
      area += signed_area(of_piece);
    }
    unsigned int n_cuts = 0;
    for (const auto &[ends, number] : sides)
      n_cuts += number == 2;
    check(name + ": convex pieces, a tree",
          convex && n_cuts + 1 == pieces.size() && pieces.size() > 1);
    check_error("  area", std::abs(area - signed_area(ring)), 1e-14);
  }
}

/** The forces on all pieces and the stress in them, with their checks. */
void check_stress(const Scene &scene, const InterfaceForces &forces)
{
  const CellPieces pieces(scene.packing);
  const Packing<2> &cut = pieces.as_packing();
  const CellForces on_pieces = pieces.forces(scene, forces);
  double force = 0., torque = 0., continuity = 0., mean = 0., largest = 0.;
  // Of each side that is a cut: its force, by the piece's cell and the ends.
  std::map<std::tuple<unsigned int, double, double>, Tensor<1, 2>> at;
  std::vector<double> residual = residual_torques(scene, forces);
  std::vector<Tensor<2, 2>> integral(scene.packing.n_cells());
  for (unsigned int p = 0; p < cut.n_cells(); ++p)
  {
    const unsigned int c = pieces.cell_of()[p];
    Tensor<1, 2> sum;
    double turning = 0.;
    for (unsigned int i = 0; i < cut.n_sides(p); ++i)
    {
      const unsigned int s = cut.first_side(p) + i;
      const Point<2> a = cut.vertex(p, i), b = cut.vertex(p, i + 1);
      const Tensor<1, 2> arm = a + 0.5 * (b - a) - cut.centre(p);
      const Tensor<1, 2> &F = on_pieces.on_side[s];
      const Tensor<1, 2> &D = on_pieces.shift_on_side[s];
      largest = std::max(largest, F.norm());
      sum += F;
      turning += cross(arm, F) + cross(0.5 * (b - a), D);
      integral[c] +=
          outer_product(F, a + 0.5 * (b - a) - scene.packing.centre(c)) +
          outer_product(D, 0.5 * (b - a));
      const Point<2> middle = a + 0.5 * (b - a);
      const auto [entry, is_new] =
          at.emplace(std::make_tuple(c, middle[0], middle[1]), F);
      if (!is_new)
        continuity = std::max(continuity, (entry->second + F).norm());
      if (!on_pieces.body.empty())
      {
        const Tensor<1, 2> &b_i = on_pieces.body[s];
        const Tensor<1, 2> to_triangle =
            ((a - cut.centre(p)) + (b - cut.centre(p))) / 3.;
        sum += b_i;
        turning += cross(to_triangle, b_i);
        integral[c] += outer_product(b_i, cut.centre(p) + to_triangle -
                                              scene.packing.centre(c));
      }
    }
    force = std::max(force, sum.norm());
    // What torque a cell has left, its pieces have by their areas.
    const double share = cut.area(p) / scene.packing.area(c) * residual[c];
    torque = std::max(torque, std::abs(turning - share));
  }
  const auto means = cell_mean_stresses(scene, forces);
  for (unsigned int c = 0; c < scene.packing.n_cells(); ++c)
    mean =
        std::max(mean, (integral[c] / scene.packing.area(c) - means[c]).norm());
  check_error("  forces on pieces", force / largest, 1e-9);
  check_error("  their torques", torque / largest, 1e-9);
  check_error("  forces across cuts", continuity / largest, 1e-9);
  check_error("  mean of the pieces", mean / largest, 1e-9);
  const StressField field =
      reconstruct_stress(cut, on_pieces, {}, Terminal::silent());
  check("  stress in all pieces", field.undetermined.empty());
}

void walls()
{
  for (const Kinematics *kinematics : {&translations(), &rotations()})
  {
    std::cout << "Wall of quoins, " << kinematics->name() << std::endl;
    std::vector<std::array<unsigned int, 2>> none;
    const Packing<2> packing = on_ground(packing_of(quoins(true, none)));
    check("  hidden sides", packing.not_seen_whole().size() == 12);
    const Scene scene(packing,
                      std::vector<double>(packing.interfaces().size(), 0.5),
                      weight(packing, 0.05, -1.), *kinematics);
    const InterfaceForces forces = Solver(least_energy).forces(scene);
    check_error("  balance", certify(scene, forces).error(), 1e-9);
    check_stress(scene, forces);
  }
}

void uniform_stress()
{
  const Tensor<2, 2> S = tensor(-3., 0.7, 0.7, -1.5);
  for (const auto &[name, ring] : shapes())
  {
    std::cout << name << " under a uniform stress" << std::endl;
    for (const Kinematics *kinematics : {&translations(), &rotations()})
    {
      const Packing<2> packing = packing_of({ring});
      std::vector<Tensor<1, 2>> g;
      for (const auto &edge : packing.boundary_edges())
        g.push_back(S * edge.normal);
      const Scene scene(packing, {}, {g, {}, {}}, *kinematics);
      const CellPieces pieces(packing);
      for (const Reconstruction &how : {Reconstruction(), {true, 1, 1}})
      {
        const StressField field =
            reconstruct_stress(pieces.as_packing(), pieces.forces(scene, {}),
                               how, Terminal::silent());
        double error = 0.;
        for (const SubCellStress &in : field.sub_cells)
          error = std::max({error, (in.stress - S).norm(), in.skew});
        check_error("  comes back", error, 1e-11);
      }
    }
  }
}

/** By Green's formula, for a linear body force. */
void body_forces()
{
  for (const auto &[name, ring] : shapes())
  {
    const Packing<2> packing = packing_of({ring});
    const BodyForce b(packing, [](const Point<2> &x, unsigned int) {
      return Tensor<1, 2>({x[0], 1. - x[1]});
    });
    double Ix = 0., Iy = 0.;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const Point<2> &p = ring[i], &q = ring[(i + 1) % ring.size()];
      const double c = p[0] * q[1] - p[1] * q[0];
      Ix += c * (p[0] + q[0]) / 6.;
      Iy += c * (p[1] + q[1]) / 6.;
    }
    const Tensor<1, 2> F = b.force(packing, 0);
    check_error(name + ": a linear body force",
                std::abs(F[0] - Ix) + std::abs(F[1] - packing.area(0) + Iy),
                1e-13);
  }
}

void run()
{
  pieces_cover();
  body_forces();
  uniform_stress();
  walls();
  glued_pairs();
}

const RoomTest test("concave_stones", run);
} // namespace test_concave_stones
