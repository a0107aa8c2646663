// SPDX-License-Identifier: LGPL-2.1-or-later

// The certificate of the exact forces of a uniform stress is clean, and sees
// one force, one sign, one strength and one NaN that are wrong; so does that of
// a motion. Loads that are not those asked for are seen by their sum and by
// their moment. Forces that are rounding use nothing of their strength.

#include "tests.h"

namespace test_certificate_planted_errors
{
using namespace Voussoir;

void show(const std::string &what, const Certificate &c)
{
  std::cout << what << ": equilibrium "
            << (c.equilibrium_residual <= 1e-12 ? "holds" : "fails")
            << ", admissibility "
            << (c.admissibility_violation <= 1e-12 ? "holds" : "fails")
            << ", utilisation "
            << (c.max_utilisation <= 1. + 1e-12 ? "at most 1" : "above 1")
            << ", torque " << (c.max_torque <= 1e-12 ? "none" : "left")
            << std::endl;
}

/**
 * Certificate::load_residual of a force on a cell of a packing that is held all
 * around, where another force, or at another place, was asked for.
 */
double residual_of_loads(const dealii::Tensor<1, 2> &excess,
                         const dealii::Tensor<1, 2> &shift,
                         const Kinematics &kinematics)
{
  Packing<2> held = random_packing(50, 3);
  held.support(std::vector<bool>(held.boundary_edges().size(), true));
  const dealii::Point<2> place =
      held.centre(7) + 0.1 * (held.vertex(7, 0) - held.centre(7));
  const dealii::Tensor<1, 2> force({3., -4.});
  Loads loads;
  loads.on_cells = {{"one", {7}, force, place}};
  loads.requested.emplace(reference_point(held));
  loads.requested->add(place + shift, force + excess);
  const std::vector<double> strength(held.interfaces().size(), 1.);
  return certify(Scene(held, strength, loads, kinematics),
                 {std::vector<double>(strength.size(), 0.),
                  {},
                  std::vector<double>(strength.size(), 0.)})
      .load_residual;
}

/** A light block at the foot of a column of heavy ones. */
void light_below_heavy()
{
  const unsigned int n = 200;
  const Packing<2> column = on_ground(stack_of_squares(n));
  Loads loads;
  loads.traction.resize(column.boundary_edges().size());
  for (unsigned int c = 0; c < n; ++c)
    loads.body.add(column, c, dealii::Tensor<1, 2>({0., c == 0 ? -1e-8 : -1.}));
  const Scene scene(column, std::vector<double>(n, 1.), loads);
  InterfaceForces exact;
  unsigned int foot = 0;
  for (unsigned int e = 0; e < n; ++e)
  {
    const auto &i = column.interfaces()[e];
    const bool is_foot = i.cell_plus == column.ground();
    exact.normal.push_back(
        is_foot ? -1e-8 - (n - 1.)
                : -double(n - std::max(i.cell_minus, i.cell_plus)));
    exact.tangential.push_back(0.);
    if (is_foot)
      foot = e;
  }
  const auto with = [&](const double error) {
    InterfaceForces forces = exact;
    forces.normal[foot] += error;
    return certify(scene, forces);
  };
  check("light below heavy: balanced", with(0.).unbalanced.empty());
  check("  but for the rounding of what presses on it",
        with(1e-13).unbalanced.empty());
  const Certificate planted = with(1e-11);
  check("  and no more",
        planted.unbalanced.size() == 1 && planted.unbalanced[0].cell == 0 &&
            planted.largest.cell == 0 &&
            planted.largest.kind == LargestError::Kind::balance);
}

/** Of blocks that are pushed sideways, and slide without end: no proof. */
void motion_without_numbers()
{
  const unsigned int n = 3;
  const Packing<2> column = on_ground(stack_of_squares(n));
  Loads loads;
  loads.traction.resize(column.boundary_edges().size());
  for (unsigned int c = 0; c < n; ++c)
    loads.body.add(column, c, dealii::Tensor<1, 2>({1., 0.}));
  const Scene scene(column, std::vector<double>(n, 0.1), loads);
  const auto proves = [&](const double distance) {
    Motion motion(n, translations());
    for (dealii::Tensor<1, 2> &u : motion.displacement)
      u[0] = distance;
    return proves_collapse(certify_mechanism(scene, motion));
  };
  check("a motion with numbers proves collapse", proves(1.));
  const InvalidOperationsAllowed on_purpose;
  for (const double distance : {std::numeric_limits<double>::infinity(),
                                std::numeric_limits<double>::quiet_NaN()})
    check("one without proves nothing", !proves(distance));
}

void run()
{
  light_below_heavy();
  motion_without_numbers();
  for (const Kinematics *kinematics : {&translations(), &rotations()})
  {
    const dealii::Tensor<1, 2> nothing, small({0.003, -0.004}),
        along({0.03, -0.04}), across({0.04, 0.03});
    check_error("loads as they were asked for",
                residual_of_loads(nothing, nothing, *kinematics), 1e-15);
    check_error("a force that is a thousandth less",
                std::abs(residual_of_loads(small, nothing, *kinematics) /
                             (0.001 / 1.001) -
                         1.),
                1e-11);
    check_error("a force that is moved along its line",
                residual_of_loads(nothing, along, *kinematics), 1e-15);
    check_error("a force that is moved across, by 0.05 in a unit square",
                std::abs(residual_of_loads(nothing, across, *kinematics) /
                             (0.05 / std::sqrt(2.)) -
                         1.),
                1e-11);
  }

  const auto S = tensor(-2, 0.3, 0.3, -1);
  Scene scene = scene_under_stress(random_packing(50, 3), 0.7, S);
  InterfaceForces exact;
  for (const auto &i : scene.packing.interfaces())
  {
    exact.normal.push_back(i.length * (S * i.normal * i.normal));
    exact.tangential.push_back(i.length * (S * i.normal * i.tangent()));
  }
  show("exact", certify(scene, exact));

  // The largest force, so that every change can be seen.
  unsigned int e = 0;
  for (unsigned int k = 0; k < exact.normal.size(); ++k)
    if (std::abs(exact.tangential[k]) > std::abs(exact.tangential[e]))
      e = k;

  InterfaceForces forces = exact;
  forces.normal[e] *= 1. + 1e-6;
  show("one normal force", certify(scene, forces));

  forces = exact;
  forces.tangential[e] *= -1.;
  show("one sign", certify(scene, forces));

  forces = exact;
  forces.normal[e] *= -1.;
  show("one tension", certify(scene, forces));

  forces = exact;
  forces.normal[e] = 0.;
  forces.tangential[e] = 1e-13 * scene.strength[e];
  scene.strength[e] = 1e-20;
  show("one force of rounding, on no strength", certify(scene, forces));
  scene.strength[e] = 0.7;

  forces = exact;
  forces.tangential[e] = std::numeric_limits<double>::quiet_NaN();
  show("one NaN", certify(scene, forces));

  scene.strength[e] = 0.9 * std::abs(exact.tangential[e]) /
                      scene.packing.interfaces()[e].length;
  show("one strength", certify(scene, exact));

  std::swap(scene.load[0], scene.load[1]);
  show("one load", certify(scene, exact));

  // The measures are relative: units change nothing.
  Scene kilo = scene_under_stress(random_packing(50, 3, {{0, 0}, {1000, 1000}}),
                                  0.7e3, 1e3 * S);
  InterfaceForces kilo_forces = exact;
  for (unsigned int k = 0; k < exact.normal.size(); ++k)
  {
    kilo_forces.normal[k] *= 1e6;
    kilo_forces.tangential[k] *= 1e6 * (k == e ? 1.001 : 1.);
  }
  forces = exact;
  forces.tangential[e] *= 1.001;
  const Scene same = scene_under_stress(random_packing(50, 3), 0.7, S);
  check_error("units do not matter",
              std::abs(certify(kilo, kilo_forces).equilibrium_residual /
                           certify(same, forces).equilibrium_residual -
                       1.),
              1e-9);
}

const RoomTest test("certificate_planted_errors", run);
} // namespace test_certificate_planted_errors
