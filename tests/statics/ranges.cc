// SPDX-License-Identifier: LGPL-2.1-or-later

// Ranges of forces over all admissible states: a value from elsewhere, closed
// forms of blocks, a scene in which statics determine all forces, and clamped
// packings, whose forces have no bound. States that all formulations select lie
// within the ranges, whose ends are attained and proven; where blocks turn and
// joints crush true ends are within what is said of them. A library that fails
// ends the program by a message.

#include <voussoir/analyses/range_analysis.h>
#include <voussoir/analyses/ranges/range_entries.h>
#include <voussoir/base/library_failure.h>
#include <voussoir/packing/cell_groups.h>
#include <voussoir/statics/energy/least_energy.h>
#include <voussoir/statics/problem/formulation.h>

#include "tests.h"
#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

namespace test_ranges
{
using namespace Voussoir;
using dealii::Tensor;

/** The ranges of all forces by one method. */
Ranges find_by(const RangeMethod method, const Scene &scene)
{
  return find_ranges(
      scene,
      {std::vector<bool>(scene.packing.interfaces().size(), true),
       scene.packing.n_supports() > 0, method},
      Terminal::silent());
}

/** How much two ranges differ; not at all if both have no bound. */
double difference(const Range &one, const Range &other)
{
  const auto of = [](const double x, const double y) {
    return x == y || (std::isnan(x) && std::isnan(y)) ? 0. : std::abs(x - y);
  };
  return std::max(of(one.least, other.least), of(one.greatest, other.greatest));
}

/** An interior point finds the same ranges, and as few without bound. */
void agree(const Scene &scene, const Ranges &by_simplex)
{
  const Ranges found = find_by(RangeMethod::interior_point, scene);
  double of_forces = 0., of_places = 0.;
  for (unsigned int e = 0; e < found.normal.size(); ++e)
  {
    of_forces =
        std::max({of_forces, difference(found.normal[e], by_simplex.normal[e]),
                  difference(found.tangential[e], by_simplex.tangential[e])});
    if (!found.eccentricity.empty())
      of_places = std::max(of_places, difference(found.eccentricity[e],
                                                 by_simplex.eccentricity[e]));
  }
  check_error("  interior point: difference", of_forces / found.reference,
              1e-8);
  check_error("  interior point: places", of_places, 1e-6);
}

/** The ranges of all forces, with checks of all proofs. */
Ranges find(const std::string &name, const Scene &scene)
{
  std::cout << name << std::endl;
  const Ranges ranges = find_by(RangeMethod::simplex, scene);
  agree(scene, ranges);
  check_error("  states", ranges.proofs.error_of_states, 1e-9);
  check_error("  proofs close joints", ranges.proofs.closing_violation, 1e-9);
  check_error("  width over the loads", ranges.proofs.width / ranges.reference,
              1e-9);
  return ranges;
}

bool contains(const Range &range, const double value, const double error)
{
  return range.least <= value + error && value <= range.greatest + error;
}

/** The states that formulations select are within the ranges. */
void contain_states(const Scene &scene, const Ranges &ranges)
{
  const DiscreteProblem problem = discretise(scene);
  const Solution solution =
      LeastEnergy().solve(problem, SolverControls(), Terminal::silent());
  const InterfaceForces forces = dimensional_forces(problem, solution);
  bool within = true;
  for (unsigned int e = 0; e < forces.normal.size(); ++e)
    within &=
        contains(ranges.normal[e], forces.normal[e], 1e-9 * ranges.reference) &&
        contains(ranges.tangential[e], forces.tangential[e],
                 1e-9 * ranges.reference) &&
        (ranges.eccentricity.empty() ||
         std::isnan(ranges.eccentricity[e].least) || forces.normal[e] == 0. ||
         contains(ranges.eccentricity[e],
                  forces.eccentricity(scene.packing.interfaces()[e], e),
                  -1e-9 * ranges.reference / forces.normal[e]));
  check("  least energy is within", within);
}

/** A wall on the ground. */
Packing<2> wall_on_ground(const std::string &bond,
                          const bool second_first,
                          const long int n_courses,
                          const long int n_bricks,
                          const double width,
                          const double height)
{
  WallGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.set("Bond", bond);
  prm.set("Begin with second course", second_first);
  prm.set("Courses", n_courses);
  prm.set("Bricks per course", n_bricks);
  prm.set("Width", width);
  prm.set("Height", height);
  return on_ground(Packing<2>(generator.generate("", Terminal::silent())));
}

/**
 * Wall 1 of Ferris and Tin-Loi: 33 bricks, weight 10 a unit of area. Another
 * programme found 0.35 to 15.05 in the middle of the base.
 */
void wall_of_33()
{
  const Scene scene =
      under_weight(wall_on_ground("running", true, 6, 5, 2., 1.05), 1., 0.,
                   translations(), Tensor<1, 2>({0., -10.}));
  const Ranges ranges = find("33 bricks", scene);
  contain_states(scene, ranges);
  const auto &interfaces = scene.packing.interfaces();
  for (unsigned int e = 0; e < interfaces.size(); ++e)
    if (interfaces[e].cell_plus == scene.packing.ground())
      std::cout << "  base at " << interfaces[e].midpoint()[0] << ": "
                << -ranges.normal[e].greatest << " to "
                << -ranges.normal[e].least << std::endl;
}

/** Blocks on each other: all is determined. */
void column(const Kinematics &kinematics)
{
  const Scene scene = under_weight(wall_on_ground("stack", false, 4, 1, 1., 4.),
                                   10., 0., kinematics);
  const Ranges ranges = find("a column, " + kinematics.name(), scene);
  double error = 0.;
  bool determined = true;
  for (unsigned int e = 0; e < ranges.normal.size(); ++e)
  {
    const double above = 4. - scene.packing.interfaces()[e].midpoint()[1];
    for (const double force :
         {ranges.normal[e].least, ranges.normal[e].greatest})
      error = std::max(error, std::abs(force + above));
    determined &= ranges.is_determined(e);
  }
  check_error("  weight above", error, 1e-12);
  check("  all is determined", determined);
  check_error("  reaction",
              std::abs(ranges.reactions[0][1].least - 4.) +
                  std::abs(ranges.reactions[0][1].greatest - 4.),
              1e-12);
}

/**
 * A block of weight one between walls that it does not press by itself: with
 * strength s the walls take up to s of its weight each, and without limit they
 * press it. A block on the ground alone is determined.
 */
void clamped()
{
  const double strength = 0.2;
  Packing<2> packing = wall(1, 1);
  std::vector<bool> rests;
  for (const auto &edge : packing.boundary_edges())
    rests.push_back(edge.normal[1] < 0.5);
  packing.support(rests);
  const Scene scene = under_weight(packing, strength, 0., translations());
  const Ranges ranges = find("a block between walls", scene);
  const auto &interfaces = scene.packing.interfaces();
  double error = 0.;
  bool unbounded = true, bounded = true;
  for (unsigned int e = 0; e < interfaces.size(); ++e)
    if (interfaces[e].normal[1] < -0.5)
    {
      error = std::abs(ranges.normal[e].least + 1. + 2. * strength) +
              std::abs(ranges.normal[e].greatest + 1. - 2. * strength);
      bounded &= ranges.normal[e].is_bounded();
    }
    else
    {
      unbounded &=
          !ranges.normal[e].is_bounded() && ranges.normal[e].greatest == 0.;
      bounded &= ranges.tangential[e].is_bounded();
    }
  check_error("  the foot", error, 1e-12);
  check("  the walls press without bound", unbounded);
  check("  all else is bounded", bounded);
}

/**
 * A block of weight one beside a smooth wall, which pushes it as hard as the
 * ground holds it: that moves the resultant on the ground.
 */
void beside_wall()
{
  const double strength = 0.2;
  Packing<2> packing = wall(1, 1);
  std::vector<bool> rests;
  for (const auto &edge : packing.boundary_edges())
    rests.push_back(edge.normal[1] < -0.5 || edge.normal[0] > 0.5);
  packing.support(rests);
  Scene scene = under_weight(packing, strength, 0., rotations());
  const auto &interfaces = scene.packing.interfaces();
  for (unsigned int e = 0; e < interfaces.size(); ++e)
    scene.strength[e] *= interfaces[e].normal[1] < -0.5;
  const Ranges ranges = find("a block beside a wall", scene);
  contain_states(scene, ranges);
  for (unsigned int e = 0; e < interfaces.size(); ++e)
  {
    const Range &place = ranges.eccentricity[e];
    if (interfaces[e].normal[1] < -0.5)
      check_error("  the foot",
                  std::abs(place.least + strength) + std::abs(place.greatest),
                  1e-9);
    else
      check_error("  the wall",
                  std::abs(place.least + 0.5) + std::abs(place.greatest - 0.5),
                  1e-9);
  }
}

/**
 * A block of weight W = 1 on ground that holds it, beside a smooth wall, all
 * joints crushing at f_c = 4. The resultant on the ground is at most 1/2 - W /
 * 2 f_c from the middle, and the lowest force P of the wall at P / 2 f_c: so
 * P^2 is at most W (f_c - W).
 */
void crushing_beside_wall()
{
  std::cout << "a block that crushes beside a wall" << std::endl;
  const Scene scene = crushing_beside_smooth_wall();
  const auto &interfaces = scene.packing.interfaces();
  const Ranges ranges = find_by(RangeMethod::automatic, scene);
  for (unsigned int e = 0; e < interfaces.size(); ++e)
  {
    const Range &normal = ranges.normal[e], &place = ranges.eccentricity[e];
    if (interfaces[e].normal[1] < -0.5)
    {
      check("  the foot", normal.greatest - normal.least < 1e-7 &&
                              std::abs(place.least + 0.5 - 1. / 8.) < 1e-6);
      continue;
    }
    check("  the root of three", std::abs(normal.least + std::sqrt(3.)) < 1e-7);
    // Next to no force passes through the very end.
    check("  small forces", place.greatest > 0.5 - 1e-3);
  }
  std::cout << "  " << description_of(ranges, scene) << std::endl;
}

/** The end of a process that fails in a library: its last words and status. */
void show_failure(const int signal, const bool is_watched)
{
  int ends[2];
  if (pipe(ends) != 0)
    throw std::runtime_error("There is no pipe.");
  const pid_t child = fork();
  if (child == 0)
  {
    dup2(ends[1], STDERR_FILENO);
    {
      const LibraryFailure failure("The library has failed.");
      if (is_watched)
        std::raise(signal);
    }
    std::raise(signal);
    _exit(0);
  }
  close(ends[1]);
  int status = 0;
  waitpid(child, &status, 0);
  std::string words(100, ' ');
  const ssize_t n = read(ends[0], &words[0], words.size());
  close(ends[0]);
  if (WIFEXITED(status))
    std::cout << words.substr(0, n) << "status " << WEXITSTATUS(status)
              << std::endl;
  else
    check("by the signal", WIFSIGNALED(status) && WTERMSIG(status) == signal);
}

void random_packings()
{
  for (const unsigned int seed : {1, 2, 3})
    for (const Kinematics *kinematics : {&translations(), &rotations()})
      for (const double mu : {0., 0.4})
      {
        Scene scene =
            scene_under_stress(random_packing(40, seed), 0.3,
                               tensor(-1.1, 0., 0., -0.9), *kinematics);
        if (mu > 0.)
          scene.coefficient.assign(scene.strength.size(), mu);
        const Ranges ranges = find("40 cells, " + kinematics->name() +
                                       (mu > 0. ? ", Coulomb" : ", Tresca"),
                                   scene);
        if (!(mu > 0.))
          contain_states(scene, ranges);
      }
}

void refusals()
{
  const auto wanted = [](const std::string &where, const bool reactions,
                         const std::string &joints = "") {
    RangeEntries parameters;
    dealii::ParameterHandler prm;
    parameters.add_parameters<2>(prm);
    prm.enter_subsection("Ranges");
    prm.set("Where", where);
    prm.set("Reactions", reactions);
    prm.set("Joints", joints);
    prm.leave_subsection();
    Packing<2> packing = on_ground(wall(2, 2));
    assign_groups(packing, "base: y < 0.5");
    return parameters.wanted(packing);
  };
  check("none", !wanted("0", false));
  check("some", wanted("ny > 0.5", false).has_value());
  const auto number = [&](const std::string &where, const std::string &joints) {
    const auto of = wanted(where, false, joints)->interfaces;
    return std::count(of.begin(), of.end(), true);
  };
  // Two bricks on the ground and three above.
  check("joints by names", number("0", "base, ground") == 2 &&
                               number("0", "base") == 2 + 1 + 4 &&
                               number("0", "cell 0, cell 1") == 1 &&
                               number("0", "brick, base | base, ground") == 6 &&
                               number("ny < -0.5", "cell 0, cell 1") == 3);
  show_refusal([&] { wanted("0", false, "brick, ground"); });
  show_refusal([&] { wanted("0", false, "lintel"); });
  show_refusal([&] { wanted("0", false, "base, base, base"); });
  show_refusal([&] { wanted("x > 5", false); });
  show_refusal([&] {
    RangeEntries parameters;
    dealii::ParameterHandler prm;
    parameters.add_parameters<2>(prm);
    prm.enter_subsection("Ranges");
    prm.set("Reactions", true);
    prm.leave_subsection();
    parameters.wanted(wall(2, 2));
  });
}

void run()
{
  wall_of_33();
  column(translations());
  column(rotations());
  clamped();
  beside_wall();
  crushing_beside_wall();
  for (const int signal : {SIGABRT, SIGSEGV})
    for (const bool is_watched : {true, false})
      show_failure(signal, is_watched);
  random_packings();
  refusals();
}

const RoomTest test("ranges", run);
} // namespace test_ranges
