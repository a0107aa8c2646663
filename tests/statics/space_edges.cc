// SPDX-License-Identifier: LGPL-2.1-or-later

// Blocks that stand on edges and tips, against statics: a cube on its edge, a
// wedge between two walls, a tetrahedron, a table on three tips, bars that
// cross, walls on edges and tips. Forces and motions are judged from the scene;
// places and units do not matter. Cohesion holds next to nothing there.

#include "space_scenes.h"

namespace test_space_edges
{
using namespace Voussoir;
using dealii::Point;

/** What the width of a joint may change, over the size of a block. */
constexpr double of_width = 2e-6;

/** Blocks, the last of which are fixed, with joints at edges. */
struct Stand
{
  CellFaces cells;
  unsigned int n_fixed;
  double mu;

  /** These, with lengths in a unit. */
  Packing<3> packing(CellFaces placed, const double unit) const
  {
    placed.n_fixed = n_fixed;
    placed.tolerance = 1e-9 * unit;
    placed.joins_edges = true;
    return Packing<3>(std::move(placed));
  }
  SpaceCase here() const
  {
    SpaceCase of{packing(cells, 1.)};
    of.mu = mu;
    return of;
  }
};

/** A force on the first block, at a place. */
SpaceLoads
push(const Packing<3> &packing, const Vector3 &force, const Point<3> &place)
{
  SpaceLoads loads(packing.n_cells());
  loads.add(0, force, place - packing.centre(0));
  return loads;
}

SpaceLoads weight(const Packing<3> &packing)
{
  return body_force(packing, vector(0., 0., -1.));
}

/** The forces of least energy, which must be proven. */
FaceForces proven_forces(const SpaceScene &scene)
{
  const FaceForces forces = elastic_forces(scene);
  check_error("  balance", certify(scene, forces).error(), 1e-10);
  return forces;
}

/** Turned by an angle about the y axis. */
Point<3> rolled(const Point<3> &p, const double angle)
{
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p[0] - s * p[2], p[1], s * p[0] + c * p[2]};
}

/** A box, a wide and b high, on its edge along y, its side at an angle to the
 * floor. */
Stand box_on_edge(const double a, const double b, const double angle)
{
  CellFaces box;
  add_box(box, {0., 0., 0.}, {a, 1., b});
  box = mapped(box, [&](const Point<3> &p) { return rolled(p, angle); });
  add_box(box, {-2., -1., -1.}, {3., 2., 0.});
  return {box, 1, 0.9};
}

void cube()
{
  std::cout << "A cube on its edge" << std::endl;
  const Stand stand = box_on_edge(1., 1., 0.25 * dealii::numbers::PI);
  SpaceCase of = stand.here();
  check("  one support",
        of.packing.interfaces().size() == 1 && of.packing.n_supports() == 1);
  const SpaceScene scene(of.blocks(), weight(of.packing));
  const Vector3 force = proven_forces(scene).resultant(of.packing, 0).force;
  check_error("  its weight", (force - vector(0., 0., 1.)).norm(), 1e-10);
  const Point<3> centre = of.packing.centre(0);
  const auto verdict = [&](const SpaceCase &of_case, const double side) {
    return proven_verdict(
        SpaceScene(of_case.blocks(),
                   together(weight(of.packing), side,
                            push(of.packing, vector(1., 0., 0.), centre))));
  };
  std::cout << "  pushed by 1e-5: " << verdict(of, 1e-5) << std::endl;
  of.strength = of.tension = 1e-2;
  std::cout << "  with cohesion: " << verdict(of, 1e-5) << std::endl;
  CellFaces open = stand.cells;
  open.n_fixed = stand.n_fixed;
  check("  nothing unless it is asked for",
        Packing<3>(open).interfaces().empty());
}

/** Held by a push at the centroid: neither more nor less. */
void leaning_box()
{
  const double angle = 0.5;
  const Stand stand = box_on_edge(1., 2., angle);
  const SpaceCase of = stand.here();
  const Point<3> centre = of.packing.centre(0);
  const SpaceLoads side = push(of.packing, vector(1., 0., 0.), centre);
  const double expected = -centre[0] / centre[2] * of.packing.volume(0);
  for (const bool greatest : {true, false})
  {
    const auto found =
        proven_factor(greatest ? "A leaning box, pushed most" : "and least", of,
                      weight(of.packing), side, greatest);
    check_error("  factor", std::abs(found.carried - expected), of_width);
  }
}

/** Between a floor and a wall, without friction at the wall: the ladder. */
void ladder()
{
  std::cout << "A box against a wall" << std::endl;
  const double angle = 0.4;
  Stand stand = box_on_edge(0.2, 2., angle);
  const double touches = -2. * std::sin(angle), high = 2. * std::cos(angle);
  add_box(stand.cells, {touches - 1., -1., 0.}, {touches, 2., 3.});
  stand.n_fixed = 2;
  SpaceCase of = stand.here();
  check("  two joints", of.packing.interfaces().size() == 2);
  const double W = of.packing.volume(0), x = -of.packing.centre(0)[0];
  // The reaction of the wall is W x / high, and friction at the foot bears it.
  const SpaceLoads dead = weight(of.packing);
  of.mu = 1.;
  const auto blocks = of.blocks();
  Strengths limits = blocks->strengths;
  for (unsigned int e = 0; e < 2; ++e)
    if (std::abs(of.packing.interfaces()[e].normal[0]) > 0.5)
      limits.coefficient[e] = 0.;
  const auto smooth = std::make_shared<const SpaceBlocks>(
      of.packing, limits, rotations_in_space(), 1);
  const FaceForces forces = proven_forces(SpaceScene(smooth, dead));
  for (unsigned int e = 0; e < 2; ++e)
    if (limits.coefficient[e] == 0.)
      check_error(
          "  reaction of the wall",
          std::abs(forces.resultant(of.packing, e).force.norm() - W * x / high),
          of_width);
  const auto answer = find_strength_factor(SpaceScene(smooth, dead), {true},
                                           Terminal::silent());
  check("  a factor of friction", answer.factor.has_value());
  if (answer.factor)
    check_error("  is that of statics",
                std::abs(answer.factor->bound * x / high - 1.), 10. * of_width);
}

/** A wedge on its edge beside one wall, or between two. */
Stand wedge(const double half, const double height, const unsigned int n_walls)
{
  Stand stand;
  add_bar(stand.cells, {{0., 0.}, {half, height}, {-half, height}}, 0., 1.);
  add_box(stand.cells, {-2., -1., -1.}, {2., 2., 0.});
  add_box(stand.cells, {half, -1., 0.}, {2., 2., 2.});
  if (n_walls > 1)
    add_box(stand.cells, {-2., -1., 0.}, {-half, 2., 2.});
  stand.n_fixed = 1 + n_walls;
  stand.mu = 0.2;
  return stand;
}

/** Pushed at its centroid towards the wall, until its foot slides there and
 * the edge at the wall upwards. */
double wedge_factor(const Stand &stand,
                    const dealii::Tensor<2, 3> &R,
                    const double unit,
                    const Vector3 &shift)
{
  SpaceCase of = stand.here();
  of.packing = stand.packing(mapped(stand.cells,
                                    [&](const Point<3> &p) {
                                      return Point<3>(unit * (R * p + shift));
                                    }),
                             unit);
  const double density = 1. / unit;
  const SpaceScene dead(
      of.blocks(), body_force(of.packing, density * (R * vector(0., 0., -1.))));
  const SpaceScene live(
      of.blocks(), body_force(of.packing, density * (R * vector(1., 0., 0.))));
  const auto answer =
      find_load_factor(dead, live, {true, 1e-11}, Terminal::silent());
  return answer.factor ? 0.5 * (answer.factor->carried + answer.factor->bound)
                       : 0.;
}

void wedges()
{
  std::cout << "A wedge between two walls" << std::endl;
  const double half = 0.5, height = 1.;
  Stand between = wedge(half, height, 2);
  between.mu = 0.;
  const SpaceCase smooth = between.here();
  check("  three joints along edges", smooth.packing.interfaces().size() == 3);
  const double W = smooth.packing.volume(0), P = 3.;
  const FaceForces forces = proven_forces(SpaceScene(
      smooth.blocks(),
      together(weight(smooth.packing), P,
               push(smooth.packing, vector(1., 0., 0.), {0., 0.5, height}))));
  double error = 0.;
  for (unsigned int e = 0; e < 3; ++e)
  {
    const Vector3 &n = smooth.packing.interfaces()[e].normal;
    const double expected = n[2] < -0.5 ? W : n[0] > 0.5 ? P : 0.;
    error = std::max(
        error,
        (forces.resultant(smooth.packing, e).force + expected * n).norm());
  }
  check_error("  weight on the floor, push on one wall", error, of_width * P);
  const Stand stand = wedge(half, height, 1);
  const SpaceCase of = stand.here();
  const double mu = stand.mu;
  const double expected =
      mu / (1. - 2. / 3. * height * (1. + mu * mu) / (height - mu * half));
  const auto found = proven_factor("Beside one wall, pushed at its centroid",
                                   of, weight(of.packing),
                                   body_force(of.packing, vector(1., 0., 0.)));
  check_error("  factor", std::abs(found.bound - expected), 10. * of_width);
  dealii::Tensor<2, 3> identity = dealii::unit_symmetric_tensor<3>();
  const double here = wedge_factor(stand, identity, 1., {});
  Random random(1);
  const dealii::Tensor<2, 3> R = random_rotation(random);
  const auto compare = [&](const std::string &what, const double there) {
    check_error("  " + what, std::abs(there / here - 1.), 1e-8);
  };
  compare("turned", wedge_factor(stand, R, 1., {}));
  compare("1e-9 as large", wedge_factor(stand, R, 1e-9, {}));
  compare("1e9 as large", wedge_factor(stand, R, 1e9, {}));
  compare("moved by 1e4",
          wedge_factor(stand, R, 1., 1e4 * vector(1., -0.7, 0.3)));
}

void tetrahedron()
{
  std::cout << "A tetrahedron on its tip" << std::endl;
  CellFaces cells;
  add_pyramid(cells, {{1.2, 0.1}, {0.2, 1.2}, {-0.5, -0.6}}, 1., {0., 0., 0.});
  add_box(cells, {-2., -2., -1.}, {2., 2., 0.});
  const Stand stand = {cells, 1, 0.9};
  const SpaceCase of = stand.here();
  const Point<3> centre = of.packing.centre(0);
  const Vector3 lean = vector(-centre[0], -centre[1], 0.);
  const double expected = lean.norm() / centre[2] * of.packing.volume(0);
  for (const bool greatest : {true, false})
  {
    const auto found =
        proven_factor(greatest ? "  held by a force, most" : "  and least", of,
                      weight(of.packing),
                      push(of.packing, lean / lean.norm(), centre), greatest);
    check_error("  factor", std::abs(found.carried - expected), of_width);
  }
  const Vector3 beside = vector(-lean[1], lean[0], 0.);
  std::cout << "  held in another direction: "
            << proven_verdict(SpaceScene(
                   of.blocks(),
                   together(weight(of.packing), expected / lean.norm(),
                            push(of.packing, beside, centre))))
            << std::endl;
}

void table()
{
  std::cout << "A table on three tips" << std::endl;
  CellFaces cells;
  add_box(cells, {-1., -1., 1.}, {2., 2., 1.2});
  const std::vector<Point<2>> tips = {{0., 0.}, {1., 0.1}, {0.2, 1.}};
  for (const Point<2> &t : tips)
    add_pyramid(cells,
                {{t[0] - 0.2, t[1] - 0.2},
                 {t[0] + 0.2, t[1] - 0.2},
                 {t[0] + 0.2, t[1] + 0.2},
                 {t[0] - 0.2, t[1] + 0.2}},
                0., {t[0], t[1], 1.});
  Stand stand = {cells, 0, 0.5};
  const SpaceCase of = stand.here();
  check("  three joints and three feet", of.packing.interfaces().size() == 6);
  const Vector3 down = vector(0., 0., -1.);
  const double P = 10.;
  const Point<3> place(0.5, 0.3, 1.2);
  const SpaceScene scene(of.blocks(), push(of.packing, P * down, place));
  const FaceForces forces = proven_forces(scene);
  // Each tip bears the part that its barycentric coordinate is.
  const auto twice = [](const Point<2> &a, const Point<2> &b,
                        const Point<2> &c) { return cross(b - a, c - a); };
  const Point<2> foot(place[0], place[1]);
  double error = 0.;
  for (unsigned int e = 0; e < 3; ++e)
  {
    const double share = twice(foot, tips[(e + 1) % 3], tips[(e + 2) % 3]) /
                         twice(tips[0], tips[1], tips[2]);
    error = std::max(
        error, std::abs(forces.resultant(of.packing, e).force[2] - P * share));
  }
  check_error("  forces of the tips", error, 10. * of_width * P);
  // It tips about the first two tips, y = 0.1 x.
  const Point<3> beyond(0.5, -0.5, 1.2);
  const double arm = place[1] - 0.1 * place[0],
               lever = -(beyond[1] - 0.1 * beyond[0]);
  check_factor("  loaded beside them", P * arm / lever, of,
               push(of.packing, P * down, place),
               push(of.packing, down, beyond), 10. * of_width);
}

void bars()
{
  std::cout << "Two bars that cross" << std::endl;
  const std::vector<Point<2>> section = {
      {0., 0.}, {1., 1.}, {0., 2.}, {-1., 1.}};
  CellFaces cells, lower;
  add_bar(cells, section, -3., 3.);
  add_bar(lower, section, -3., 3.);
  const double c = std::cos(1.1), s = std::sin(1.1);
  add_cells(cells, mapped(lower, [&](const Point<3> &p) {
              return Point<3>(c * p[0] - s * p[1], s * p[0] + c * p[1],
                              p[2] - 2.);
            }));
  const Stand stand = {cells, 1, 0.3};
  const SpaceCase of = stand.here();
  check("  one joint", of.packing.interfaces().size() == 1);
  const SpaceLoads dead = weight(of.packing);
  const double W = of.packing.volume(0);
  const Vector3 force = proven_forces(SpaceScene(of.blocks(), dead))
                            .resultant(of.packing, 0)
                            .force;
  check_error("  its weight", (force - vector(0., 0., W)).norm() / W, 1e-10);
  check_factor("  slides", stand.mu * W, of, dead,
               push(of.packing, vector(0.6, 0.8, 0.), {0., 0., 0.}), of_width);
  std::cout << "  pushed at its centre: "
            << proven_verdict(SpaceScene(
                   of.blocks(), together(dead, 1e-4 * W,
                                         push(of.packing, vector(1., 0., 0.),
                                              of.packing.centre(0)))))
            << std::endl;
}

/** A wall on a beam: joints of all sizes, and forces of least energy. */
void wall_on(const std::string &feet, const CellFaces &below)
{
  std::cout << "A wall on a beam on " << feet << std::endl;
  CellFaces cells = mapped(brick_wall(4, 1, 6), [](const Point<3> &p) {
    return Point<3>(p[0], p[1], p[2] + 1.5);
  });
  add_box(cells, {0., 0., 1.}, {9., 1., 1.5});
  add_cells(cells, below);
  const Stand stand = {cells, below.n_cells(), 0.7};
  const SpaceCase of = stand.here();
  const SpaceScene scene(of.blocks(), weight(of.packing));
  const DiscreteProblem problem = discretise(scene);
  const Solution solution = find_space_state(
      problem, {}, LinearSolver::automatic, Terminal::silent());
  const FaceForces forces = dimensional_forces(problem, scene, solution);
  check_error("  balance", certify(scene, forces).error(), 1e-10);
  check("  of least energy, in a few steps",
        solution.selection.empty() && solution.n_iterations <= 12);
  // The feet are at x = 1 and x = 7.
  double moment = 0., right = 0.;
  for (unsigned int c = 0; c < of.packing.n_cells(); ++c)
    moment += of.packing.volume(c) * (of.packing.centre(c)[0] - 1.);
  for (unsigned int e = 0; e < of.packing.interfaces().size(); ++e)
  {
    const auto &i = of.packing.interfaces()[e];
    if (i.cell_plus == of.packing.ground() && i.centroid[0] > 4.)
      right += forces.resultant(of.packing, e).force[2];
  }
  check_error("  reactions",
              std::abs(right - moment / 6.) / of.packing.volume(),
              10. * of_width);
}

void walls()
{
  CellFaces edges, tips;
  for (const double x : {1., 7.})
    add_bar(edges, {{x - 0.5, 0.}, {x + 0.5, 0.}, {x, 1.}}, -0.5, 1.5);
  for (const Point<2> &p :
       {Point<2>(1., 0.2), Point<2>(1., 0.8), Point<2>(7., 0.5)})
    add_pyramid(tips,
                {{p[0] - 0.2, p[1] - 0.2},
                 {p[0] + 0.2, p[1] - 0.2},
                 {p[0] + 0.2, p[1] + 0.2},
                 {p[0] - 0.2, p[1] + 0.2}},
                0., {p[0], p[1], 1.});
  wall_on("two edges", edges);
  wall_on("three tips", tips);
}

void run()
{
  cube();
  leaning_box();
  ladder();
  wedges();
  tetrahedron();
  table();
  bars();
  walls();
}

const RoomTest test("space_edges", run);
} // namespace test_space_edges
