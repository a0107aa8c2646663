// SPDX-License-Identifier: LGPL-2.1-or-later

// Joints of some width: forces act midway between the blocks, and moments are
// balanced with the width in them. The factors of walls
// do not feel the width where their statics agree; a stack that is cut with a
// kerf has the forces of one that is cut without, wherever it stands; and so
// have random stones apart from each other.

#include <voussoir/analyses/factors/load_factor.h>
#include <voussoir/base/geometry.h>
#include <voussoir/stress/cell_means.h>
#include <voussoir/stress/side_forces.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include "polygons.h"
#include "tests.h"
#include <map>
#include <numeric>

namespace test_mortar_joints
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

using Ring = std::vector<Point<2>>;

/** A wall of which the joints are that wide, and overlap by 1 whatever that. */
std::vector<Ring> running_bond(const double gap)
{
  const double length = 2. + gap, height = 0.6;
  std::vector<Ring> rings;
  for (int course = 0; course < 8; ++course)
  {
    const double y = course * (height + gap);
    double x = 0.;
    const auto add = [&](const double b) {
      rings.push_back(rectangle(x, y, b, height));
      x += b + gap;
    };
    if (course % 2 == 1)
      add(1.);
    for (int k = 0; k < 6 - course % 2; ++k)
      add(length);
    if (course % 2 == 1)
      add(1.);
  }
  return rings;
}

/** A force on each cell. */
Loads force_on_cells(const Packing<2> &packing, const double x, const double y)
{
  Loads loads;
  loads.traction.resize(packing.boundary_edges().size());
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    loads.body.add(packing, c, Tensor<1, 2>({x, y}));
  return loads;
}

double
factor_of(const Packing<2> &packing, const double strength, const double mu)
{
  // Bricks rest on 2 of the ground, whatever their length.
  std::vector<double> strengths;
  for (const Packing<2>::Interface &i : packing.interfaces())
    strengths.push_back(
        i.cell_plus == packing.ground() ? 2. / i.length * strength : strength);
  const Kinematics &kinematics = mu > 0. ? rotations() : translations();
  Scene dead(packing, strengths, force_on_cells(packing, 0., -1.), kinematics);
  Scene live(packing, strengths, force_on_cells(packing, 1., 0.), kinematics);
  if (mu > 0.)
    dead.coefficient = live.coefficient =
        std::vector<double>(strengths.size(), mu);
  const LoadFactorAnswer answer =
      find_load_factor(dead, live, {}, Terminal::silent());
  check_error("  width", answer.factor->width(), 1e-8);
  return answer.factor->carried;
}

void test_walls()
{
  std::cout << "Running bond under weight and as much to the side" << std::endl;
  const double exact =
      factor_of(on_ground(joined(running_bond(0.), 0.)), 1., 0);
  for (const double gap : {0.001, 0.01, 0.1})
  {
    const Packing<2> blocks = joined(running_bond(gap), gap);
    const double factor = factor_of(on_ground(blocks), 1., 0.);
    check_error("  the same factor", std::abs(factor - exact) / exact, 1e-9);
    check_error("  areas to rounding",
                std::abs(blocks.area() - 0.6 * (44. * (2. + gap) + 8.)), 1e-13);
  }
}

void test_columns()
{
  std::cout << "Columns of 1 x 1 with joints of 0.2 overturn" << std::endl;
  for (const unsigned int n : {1, 2, 5, 20})
  {
    std::vector<Ring> rings;
    for (unsigned int k = 0; k < n; ++k)
      rings.push_back(rectangle(0., 1.2 * k, 1., 1.));
    // The weight leaves the base where the mean height of the blocks meets it.
    const double exact = 0.5 / (0.5 + 0.6 * (n - 1.));
    check_error(
        "  factor",
        std::abs(factor_of(on_ground(joined(rings, 0.2)), 0., 5.) / exact - 1.),
        1e-8);
  }
}

/** Random stones of a convex polygon, cut with a kerf. */
struct Stack
{
  Stack(const unsigned int seed, const double kerf)
  {
    boost::random::mt19937 generator(seed);
    boost::random::uniform_real_distribution<double> number(-1., 1.);
    const unsigned int n = 2 + seed % 7;
    // Beds that fall to either side, and sides that lean.
    std::vector<std::array<double, 2>> heights(n + 1);
    for (unsigned int k = 0; k <= n; ++k)
      for (double &height : heights[k])
        height = k + (k > 0 ? 0.3 * number(generator) : 0.);
    const double lean = 0.1 * number(generator);
    for (unsigned int k = 0; k < n; ++k)
    {
      const auto place = [&](const unsigned int i, const unsigned int side) {
        return Point<2>(3. * side + lean * heights[i][side], heights[i][side]);
      };
      // The kerf takes as much from both, along the normal of the bed.
      const auto cut = [&](const unsigned int i, const double sign) {
        const Tensor<1, 2> bed = place(i, 1) - place(i, 0);
        return i == 0 || i == n ? 0.
                                : sign * 0.5 * kerf * bed.norm() /
                                      cross(bed, Tensor<1, 2>({lean, 1.}));
      };
      const Tensor<1, 2> up({lean, 1.});
      rings.push_back({place(k, 0) + cut(k, 1.) * up,
                       place(k, 1) + cut(k, 1.) * up,
                       place(k + 1, 1) + cut(k + 1, -1.) * up,
                       place(k + 1, 0) + cut(k + 1, -1.) * up});
      forces.push_back(Tensor<1, 2>(
          {0.05 * number(generator), -1. - 0.5 * number(generator)}));
    }
  }

  std::vector<Ring> rings;
  /** On each stone, at the centroid of the stones without a kerf. */
  std::vector<Tensor<1, 2>> forces;
};

/** A drawing that is turned, scaled and in another order. */
struct Placed
{
  Placed(const std::vector<Ring> &drawn,
         const double angle,
         const double scale,
         const unsigned int shuffle)
      : turn(tensor(std::cos(angle),
                    -std::sin(angle),
                    std::sin(angle),
                    std::cos(angle))),
        order(drawn.size())
  {
    std::iota(order.begin(), order.end(), 0);
    boost::random::mt19937 generator(shuffle);
    for (unsigned int k = order.size(); k > 1; --k)
      std::swap(order[k - 1], order[generator() % k]);
    for (const unsigned int k : order)
    {
      Ring ring;
      for (const Point<2> &p : drawn[k])
        ring.push_back(Point<2>(scale * (turn * p)));
      std::rotate(ring.begin(), ring.begin() + generator() % ring.size(),
                  ring.end());
      rings.push_back(ring);
    }
  }

  Tensor<2, 2> turn;
  /** For each stone its number in the drawing. */
  std::vector<unsigned int> order;
  std::vector<Ring> rings;
};

/** The force through each bed, on the stone above it, from below upwards. */
std::vector<Tensor<1, 2>> forces_on_beds(const Stack &stack,
                                         const double kerf,
                                         const double angle,
                                         const double scale,
                                         const unsigned int shuffle)
{
  const Placed placed(stack.rings, angle, scale, shuffle);
  const Tensor<2, 2> &turn = placed.turn;
  const std::vector<unsigned int> &order = placed.order;
  Packing<2> packing = joined(placed.rings, 1.001 * scale * kerf, 1e-9 * scale);
  std::vector<bool> rests;
  for (const auto &edge : packing.boundary_edges())
    rests.push_back(std::abs((transpose(turn) * edge.midpoint())[1]) <
                    1e-9 * scale);
  packing.support(rests);
  Loads loads;
  loads.traction.resize(packing.boundary_edges().size());
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    loads.body.add(packing, c, turn * stack.forces[order[c]]);
  const unsigned int n = packing.interfaces().size();
  const Scene scene(std::move(packing), std::vector<double>(n, 10. / scale),
                    loads);
  const InterfaceForces forces = Solver(least_energy, 1e-12).forces(scene);
  std::vector<Tensor<1, 2>> on_bed(stack.rings.size());
  for (unsigned int e = 0; e < n; ++e)
  {
    const auto &i = scene.packing.interfaces()[e];
    const unsigned int minus = order[i.cell_minus];
    const unsigned int plus = i.cell_plus == scene.packing.ground()
                                  ? dealii::numbers::invalid_unsigned_int
                                  : order[i.cell_plus];
    const bool is_above = plus + 1 == minus; // the ground counts as -1
    on_bed[is_above ? minus : plus] =
        transpose(turn) * ((is_above ? 1. : -1.) * forces.on_cell_minus(i, e));
  }
  return on_bed;
}

void test_drawings()
{
  std::cout << "200 stacks, cut with a kerf, turned, scaled and shuffled"
            << std::endl;
  double largest = 0.;
  for (unsigned int seed = 0; seed < 200; ++seed)
  {
    const Stack solid(seed, 0.), cut(seed, 0.08);
    const auto original = forces_on_beds(solid, 1e-9, 0., 1., 0);
    const auto found = forces_on_beds(cut, 0.08, 0.1 * seed,
                                      std::pow(10., seed % 7 - 3.), seed);
    for (unsigned int k = 0; k < original.size(); ++k)
      largest = std::max(largest,
                         (original[k] - found[k]).norm() / original[k].norm());
  }
  check_error("the same forces", largest, 1e-9);
}

/** Random stones that shrank to their centres, so that all joints are open. */
std::vector<Ring> shrunk_stones(const unsigned int seed)
{
  const Packing<2> packing = random_packing(10 + seed % 20, seed + 1);
  std::vector<Ring> rings(packing.n_cells());
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
      rings[c].push_back(packing.centre(c) +
                         0.999 * (packing.vertex(c, i) - packing.centre(c)));
  return rings;
}

/** The forces between stones, on the one that comes first in @p rings. */
std::map<std::pair<unsigned int, unsigned int>, Tensor<1, 2>>
forces_between(const std::vector<Ring> &rings,
               const double angle,
               const double scale,
               const unsigned int shuffle)
{
  const Placed placed(rings, angle, scale, shuffle);
  Packing<2> packing = joined(placed.rings, 1e-3 * scale, 1e-9 * scale);
  std::vector<bool> rests;
  for (const auto &edge : packing.boundary_edges())
    rests.push_back((transpose(placed.turn) * edge.normal)[1] < -1. + 1e-9);
  packing.support(rests);
  Loads loads;
  loads.traction.resize(packing.boundary_edges().size());
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    loads.body.add(packing, c, placed.turn * Tensor<1, 2>({0.01, -1.}));
  const unsigned int n = packing.interfaces().size();
  const Scene scene(std::move(packing), std::vector<double>(n, 1e3 / scale),
                    loads);
  const InterfaceForces forces = Solver(least_energy, 1e-12).forces(scene);
  std::map<std::pair<unsigned int, unsigned int>, Tensor<1, 2>> between;
  for (unsigned int e = 0; e < n; ++e)
  {
    const auto &i = scene.packing.interfaces()[e];
    const unsigned int minus = placed.order[i.cell_minus];
    const unsigned int plus = i.cell_plus == scene.packing.ground()
                                  ? rings.size()
                                  : placed.order[i.cell_plus];
    between[std::minmax(minus, plus)] +=
        transpose(placed.turn) *
        ((minus < plus ? 1. : -1.) * forces.on_cell_minus(i, e));
  }
  return between;
}

void test_random_stones()
{
  std::cout << "200 drawings of random stones, turned, scaled and shuffled"
            << std::endl;
  double largest = 0.;
  bool same_joints = true;
  for (unsigned int seed = 0; seed < 200; ++seed)
  {
    const std::vector<Ring> rings = shrunk_stones(seed);
    const auto original = forces_between(rings, 0., 1., 0);
    const auto found =
        forces_between(rings, 0.1 * seed, std::pow(10., seed % 7 - 3.), seed);
    double size = 0.;
    for (const auto &[pair, force] : original)
      size = std::max(size, force.norm());
    same_joints &= original.size() == found.size();
    for (const auto &[pair, force] : original)
    {
      const auto other = found.find(pair);
      same_joints &= other != found.end();
      if (other != found.end())
        largest = std::max(largest, (force - other->second).norm() / size);
    }
  }
  check("the same joints", same_joints);
  check_error("the same forces", largest, 1e-9);
}

void test_moments()
{
  std::cout << "A wall with joints of 0.1, pushed, whose blocks turn"
            << std::endl;
  const Packing<2> blocks = on_ground(joined(running_bond(0.1), 0.1));
  const Loads loads = force_on_cells(blocks, 0.1, -1.);
  const unsigned int n = blocks.interfaces().size();
  const Scene scene(blocks, std::vector<double>(n, 2.), loads, rotations());
  const InterfaceForces forces = Solver(least_energy).forces(scene);
  const Certificate certificate = certify(scene, forces);
  check_error("balance", certificate.error(), 1e-10);
  // Once more from the tractions on the blocks' own sides.
  double force = 0., torque = 0., skew = 0.;
  for (unsigned int c = 0; c < scene.packing.n_cells(); ++c)
  {
    Tensor<1, 2> sum = scene.load[c];
    double turning = scene.load_torque[c];
    for (unsigned int i = 0; i < scene.packing.n_sides(c); ++i)
    {
      const SideForce of_side = side_force(scene, forces, c, i);
      const Point<2> a = scene.packing.vertex(c, i);
      const Tensor<1, 2> half = 0.5 * (scene.packing.vertex(c, i + 1) - a);
      const Tensor<1, 2> arm = a + half - scene.packing.centre(c);
      sum += of_side.force;
      turning += cross(arm, of_side.force) + cross(half, of_side.shift);
    }
    force = std::max(force, sum.norm());
    torque = std::max(torque, std::abs(turning));
  }
  for (const Tensor<2, 2> &mean : cell_mean_stresses(scene, forces))
    skew = std::max(skew, std::abs(mean[0][1] - mean[1][0]));
  check_error("forces on the sides", force, 1e-10);
  check_error("their moments", torque, 1e-10);
  check_error("symmetry of the mean stress", skew, 1e-10);
}

void run()
{
  test_walls();
  test_columns();
  test_drawings();
  test_random_stones();
  test_moments();
}

const RoomTest test("mortar_joints", run);
} // namespace test_mortar_joints
