// SPDX-License-Identifier: LGPL-2.1-or-later

// Load factors between two proofs: closed forms and values of the literature,
// with both laws of friction, blocks that turn and that do not; the limits that
// bisection over states finds; loads that are carried at any factor, at none,
// and in both directions. Both proofs are added up by certify() and
// bound_of_factor().

#include <voussoir/analyses/factors/load_factor.h>

#include "tests.h"

namespace test_load_factor
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

/** A scene with a body force and tractions S n, dry if mu is positive. */
struct Case
{
  explicit Case(Packing<2> packing) : packing(std::move(packing)) {}

  Packing<2> packing;
  double strength = 0., mu = 0.;
  Tensor<1, 2> force;
  Tensor<2, 2> S;
  const Kinematics *kinematics = &translations();

  Scene scene() const
  {
    Loads loads;
    for (const auto &edge : packing.boundary_edges())
      loads.traction.push_back(S * edge.normal);
    for (unsigned int c = 0; c < packing.n_cells(); ++c)
      loads.body.add(packing, c, packing.area(c) * force);
    Scene scene(packing,
                std::vector<double>(packing.interfaces().size(), strength),
                loads, *kinematics);
    if (mu > 0.)
      scene.coefficient.assign(packing.interfaces().size(), mu);
    return scene;
  }
};

/** The loads of a case and @p factor times those of another. */
Scene sum(const Case &dead, const double factor, const Case &live)
{
  Case both = dead;
  both.force += factor * live.force;
  both.S += factor * live.S;
  return both.scene();
}

/** Check both proofs, and say the factor. */
LoadFactor find(const std::string &name,
                const Case &dead,
                const Case &live,
                const bool greatest = true)
{
  std::cout << name << std::endl;
  const LoadFactorAnswer answer = find_load_factor(
      dead.scene(), live.scene(), {greatest}, Terminal::silent());
  check("  dead loads are carried", answer.factor.has_value());
  if (!answer.factor)
    return {};
  const LoadFactor &found = *answer.factor;
  const Scene at = sum(dead, found.carried, live);
  const Certificate state = certify(at, found.forces);
  check_error("  balance", state.error(), 1e-10);
  if (found.is_unbounded)
    return found;
  const FactorBound bound =
      bound_of_factor(dead.scene(), live.scene(), found.mechanism);
  check("  bound", bound.factor == found.bound &&
                       bound.closing_violation <= 1e-12 &&
                       (bound.live_work > 0.) == greatest);
  check_error("  width", found.width(), 1e-8);
  check("  order", greatest ? found.carried <= found.bound * (1. + 1e-12)
                            : found.carried >= found.bound);
  return found;
}

void compare(const LoadFactor &found, const double exact, const double error)
{
  check_error("  factor", std::abs(found.carried / exact - 1.), error);
}

Tensor<1, 2> vector(const double x, const double y)
{
  return Tensor<1, 2>({x, y});
}

/** Wall @p k of Ferris and Tin-Loi. */
Packing<2> ferris_tin_loi(const unsigned int k)
{
  WallGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  const long int n_courses = k == 1 ? 6 : 10;
  prm.set("Begin with second course", true);
  prm.set("Courses", n_courses);
  prm.set("Bricks per course", 5L);
  prm.set("Width", 2.);
  prm.set("Height", 0.175 * n_courses);
  return on_ground(Packing<2>(generator.generate("", Terminal::silent())));
}

void dry_walls()
{
  for (const unsigned int k : {1, 2})
  {
    Case dead(ferris_tin_loi(k));
    dead.force = vector(0., -10.);
    Case live = dead;
    live.force = vector(10., 0.);
    const std::string name = "Ferris and Tin-Loi " + std::to_string(k);
    check(name + ": blocks and contacts",
          dead.packing.n_cells() == (k == 1 ? 33 : 55) &&
              dead.packing.interfaces().size() == (k == 1 ? 83 : 141));
    for (const double strength : {1., 3.})
    {
      dead.strength = live.strength = strength;
      compare(find(name + ", Tresca", dead, live),
              2. * strength / (k == 1 ? 21. : 35.), 1e-9);
    }
    dead.strength = live.strength = 0.;
    dead.mu = live.mu = 0.65;
    dead.kinematics = live.kinematics = &rotations();
    compare(find(name + ", Coulomb", dead, live), k == 1 ? 0.642859 : 0.579999,
            1e-6);
  }
}

void block()
{
  Case dead(on_ground(wall(1, 1, 1., 0.5)));
  dead.force = vector(0., -10.);
  dead.kinematics = &rotations();
  Case live = dead;
  live.force = vector(10., 0.);
  for (const double mu : {0.1, 0.6, 1.9})
  {
    dead.mu = live.mu = mu;
    compare(find("a block slides at mu", dead, live), mu, 1e-9);
    compare(find("and the other way", dead, live, false), -mu, 1e-9);
  }
  dead.mu = live.mu = 2.1;
  compare(find("it overturns", dead, live), 2., 1e-9);
  dead.mu = live.mu = 0.2;
  dead.strength = live.strength = 1.5;
  compare(find("with cohesion", dead, live), 0.2 + 1.5 / 5., 1e-9);
  dead.strength = live.strength = 1.5;
  dead.mu = live.mu = 0.;
  compare(find("Tresca", dead, live), 1.5 / 5., 1e-9);
}

void extremes()
{
  Case dead(on_ground(wall(3, 2)));
  dead.force = vector(1., -10.);
  dead.mu = 0.6;
  Case live = dead;
  live.force = vector(0., -1.);
  check("more weight is always carried",
        find("weight", dead, live).is_unbounded);
  compare(find("less weight", dead, live, false), -10. + 1. / 0.6, 1e-9);

  dead.force = vector(8., -10.);
  const LoadFactor pressed = find("dead loads that need weight", dead, live);
  check("  they collapse alone",
        pressed.is_unbounded && pressed.collapses_without);
  compare(find("the least weight", dead, live, false), 8. / 0.6 - 10., 1e-9);
  // A pull with the weight between nothing and what lifts the wall.
  live.force = vector(-1., 0.);
  compare(find("the least pull", dead, live, false), 2., 1e-9);
  compare(find("the greatest pull", dead, live), 14., 1e-9);

  // Loads that none of the live ones helps to carry.
  dead.force = vector(0., 1.);
  const LoadFactorAnswer answer =
      find_load_factor(dead.scene(), live.scene(), {}, Terminal::silent());
  check("dead loads that collapse with any",
        !answer.factor &&
            proves_collapse(certify_mechanism(dead.scene(), answer.collapse)));
}

/**
 * Searches that end early have both proofs on both sides of @p factor, farther
 * apart, or say that they have none.
 */
void early_ends(const std::string &name,
                const Case &dead,
                const Case &live,
                const double factor,
                const bool greatest = true)
{
  unsigned int n_wide = 0;
  bool are_proofs = true, are_in_order = true, is_first = true, is_sound = true;
  double width = std::numeric_limits<double>::infinity();
  for (unsigned int n = 1; width > 1e-8 && n < 100; ++n)
  {
    LoadFactorControls controls;
    controls.greatest = greatest;
    controls.n_max_iterations = n;
    try
    {
      const LoadFactor found = *find_load_factor(dead.scene(), live.scene(),
                                                 controls, Terminal::silent())
                                    .factor;
      is_first = false;
      width = found.width();
      are_proofs =
          are_proofs &&
          certify(sum(dead, found.carried, live), found.forces).error() <=
              1e-10;
      if (!found.has_mechanism())
        continue;
      const FactorBound bound =
          bound_of_factor(dead.scene(), live.scene(), found.mechanism);
      are_proofs = are_proofs && bound.factor == found.bound &&
                   bound.closing_violation <= 1e-12;
      const double sign = greatest ? 1. : -1., rounding = 1e-9;
      are_in_order = are_in_order &&
                     sign * (found.carried - factor) <= rounding &&
                     sign * (found.bound - factor) >= -rounding;
      n_wide += width > 1e-6;
    }
    catch (const SolverError &)
    {
      // Only as long as there is no proof at all.
      is_sound = is_sound && is_first;
    }
  }
  check(name + ", ended early: proofs", are_proofs && is_sound);
  check("  about the factor", are_in_order);
  check("  some of them wide, the last narrow", n_wide > 0 && width <= 1e-8);
}

void early_ends()
{
  Case dead(ferris_tin_loi(1));
  dead.force = vector(0., -10.);
  dead.mu = 0.65;
  dead.kinematics = &rotations();
  Case live = dead;
  live.force = vector(10., 0.);
  early_ends("Ferris and Tin-Loi 1", dead, live, 0.6428590034);
  early_ends("the other way", dead, live, -0.6428590034, false);

  Case none(on_ground(wall(4, 6)));
  none.strength = 1.;
  live = none;
  live.force = vector(1., -1.);
  const LoadFactor whole =
      *find_load_factor(none.scene(), live.scene(), {}, Terminal::silent())
           .factor;
  early_ends("without dead loads", none, live, whole.carried);
}

/** The factor of a deviator that bisection over states finds. */
void compare_with_bisection(const std::string &name,
                            const Packing<2> &packing,
                            const Kinematics &kinematics)
{
  Case pressed(packing);
  pressed.strength = 0.3;
  pressed.S = tensor(-1., 0., 0., -1.);
  pressed.kinematics = &kinematics;
  Case deviator = pressed;
  deviator.S = tensor(1., 0., 0., -1.);
  const LoadFactor found = find(name, pressed, deviator);
  double low = 0., high = 2.;
  while (high - low > 1e-9)
  {
    const double middle = 0.5 * (low + high);
    const DiscreteProblem problem = discretise(sum(pressed, middle, deviator));
    (Solver(least_energy).solve(problem).mechanism ? high : low) = middle;
  }
  check_error("  bisection", std::abs(found.carried - low) / low, 1e-8);
}

/** The shear wall carries its strength, and any packing what bisection finds.*/
void no_dead_loads()
{
  Case none(wall(12, 6));
  none.strength = 10.;
  Case live = none;
  const Scene sheared = shear_wall(10.);
  const LoadFactorAnswer answer =
      find_load_factor(none.scene(), sheared, {}, Terminal::silent());
  check("shear wall", answer.factor.has_value());
  compare(*answer.factor, 10., 1e-9);

  compare_with_bisection("turned squares", turned_squares(8), translations());
  for (const auto *kinematics : {&translations(), &rotations()})
    for (const unsigned int seed : {1, 2})
      compare_with_bisection("random cells", random_packing(60, seed),
                             *kinematics);
}

void run()
{
  dry_walls();
  block();
  extremes();
  early_ends();
  no_dead_loads();
}

const RoomTest test("load_factor", run);
} // namespace test_load_factor
