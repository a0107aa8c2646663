// SPDX-License-Identifier: LGPL-2.1-or-later

// Arches and domes of blocks in space: the least thickness with Coulomb's
// friction, as the root of the crown load that is carried, between two proofs;
// and the least strength with Tresca's, of blocks that do not turn. Beside the
// known figures are computations of the same blocks by other means.

#include <voussoir/packing/polyhedra/generators/vault.h>

#include "space_thickness.h"

namespace test_space_shells
{
using namespace Voussoir;
using dealii::Point;

constexpr double pi = 3.14159265358979323846;

/** A semicircle of the mean radius one, half as wide. */
SpaceCase arch(const unsigned int n, const double thickness)
{
  VaultGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.set("Mean radius", 1.);
  prm.set("Thickness", thickness);
  prm.set("Embrace", 180.);
  prm.set("Voussoirs", static_cast<long int>(n));
  prm.set("Bond", "stack");
  prm.set("Length", 0.5);
  prm.set("Blocks per row", 1L);
  return SpaceCase(Packing<3>(generator.generate("", Terminal::silent())));
}

/** The distance of the centroid of an arc from its centre, at radius one. */
double centroid_of_arc(const double angle)
{
  return std::sin(0.5 * angle) / (0.5 * angle);
}

/** The weight of the middle line. */
CrownLoad arch_under_crown_load(const unsigned int n, const double thickness)
{
  SpaceCase of = arch(n, thickness);
  of.mu = 1.;
  SpaceLoads weight(n), crown(n);
  const double angle = pi / n, r = centroid_of_arc(angle);
  for (unsigned int c = 0; c < n; ++c)
  {
    const Point<3> &x = of.packing.centre(c);
    const double scale = r / std::hypot(x[0], x[2]);
    weight.add(c, vector(0., 0., -angle),
               Point<3>(scale * x[0], x[1], scale * x[2]) - x);
  }
  for (const unsigned int c : {n / 2 - 1, n / 2})
    crown.add(c, vector(0., 0., -1.),
              Point<3>(0., 0.25, 1.) - of.packing.centre(c));
  return {of, weight, crown};
}

/**
 * The same least thickness by lines of thrust: that through the extrados at the
 * crown and at the springings touches the intrados in one of the joints. With n
 * voussoirs, an even number.
 */
double least_thickness_by_thrust(const unsigned int n)
{
  const double angle = pi / n, r = centroid_of_arc(angle);
  // How far the line is from the intrados at least, as a moment.
  const auto clearance = [&](const double thickness) {
    const double outer = 1. + 0.5 * thickness, inner = 1. - 0.5 * thickness;
    const double at_foot = 1.; // int_0^(pi/2) sin
    const double thrust = (0.5 * pi * outer - at_foot) / outer;
    double weight = 0., moment = 0., least = thrust;
    for (unsigned int k = 1; k <= n / 2; ++k)
    {
      weight += angle;
      moment += angle * r * std::sin(angle * (k - 0.5));
      const double s = inner * std::sin(angle * k),
                   c = inner * std::cos(angle * k);
      least = std::min(least, thrust * (outer - c) - (weight * s - moment));
    }
    return least;
  };
  double low = 0.05, high = 0.2;
  while (high - low > 1e-14)
  {
    const double middle = 0.5 * (low + high);
    (clearance(middle) < 0. ? low : high) = middle;
  }
  return low;
}

void thickness_of_arches()
{
  check_error("Lines of thrust in 320 voussoirs",
              std::abs(least_thickness_by_thrust(320) - 0.107426117), 5e-10);
  for (const unsigned int n : {10, 320})
    check_least_thickness(text("Arch of ", n), least_thickness_by_thrust(n),
                          1e-11, [n](const double thickness) {
                            return arch_under_crown_load(n, thickness);
                          });
}

void thickness_of_domes()
{
  for (const double mu : {0.25, 1.})
    check_thickness_of_dome(10, 12, mu, 0.04228854);
}

/** s_T / (gamma R) of arches whose voussoirs do not turn. */
void strength_of_arches()
{
  struct Limit
  {
    unsigned int n;
    double strength;
  };
  for (const Limit &of :
       {Limit{10, 0.314904}, Limit{20, 0.323986}, Limit{40, 0.325531}})
    for (const double thickness : {0.05, 0.3})
    {
      SpaceCase blocks = arch(of.n, thickness);
      blocks.turns = false;
      blocks.strength = 1.;
      const auto found = proven_strength_factor(
          text("Arch of ", of.n, " that does not turn, thickness ", thickness),
          blocks, body_force(blocks.packing, vector(0., 0., -1.)));
      // The figures have six digits.
      check_error("  carried", std::abs(1. / found.carried - of.strength),
                  6e-7);
      check_error("  and bound", std::abs(1. / found.bound - of.strength),
                  6e-7);
    }
}

/**
 * s_T / (gamma R) of a dome whose blocks do not turn. By symmetry, what acts in
 * a bed joint of one sector is a pressure and a friction F in its middle plane,
 * below the weight V of all above; of the head joints the pressure alone
 * presses outwards, so that the thrust H = (V cos - F) / sin of the joints,
 * which are at the angle phi to the axis, does not decrease downwards. That can
 * be kept with |F| <= s A if and only if the least thrust of each joint is at
 * most the greatest one of each below it.
 */
double least_strength_of_dome(const unsigned int n_courses,
                              const unsigned int n_sectors,
                              const double thickness)
{
  const double outer = 1. + 0.5 * thickness, inner = 1. - 0.5 * thickness;
  const double cubes = std::pow(outer, 3) - std::pow(inner, 3),
               squares = outer * outer - inner * inner;
  const double first = 0.25 * pi / (n_courses + 0.5);
  // The sum of the volumes of pyramids from the centre, of the radius one.
  double pyramids = 0., q_above = 0., z_above = 0., w_above = 0.;
  double least = 0.;
  // V cos / sin and A / sin of the joints so far.
  std::vector<std::array<double, 2>> above;
  for (unsigned int k = 0; k <= n_courses; ++k)
  {
    const double phi = first + (0.5 * pi - first) * k / n_courses;
    // The middle of the joint's edge on the unit sphere, and half of its
    // length.
    const double q = std::sin(phi) * std::cos(pi / n_sectors),
                 z = std::cos(phi),
                 w = std::sin(phi) * std::sin(pi / n_sectors);
    pyramids += k == 0
                    ? q * w * z / 3.
                    : (w_above + w) * std::abs(q_above * z - q * z_above) / 3.;
    const double rho = std::hypot(q, z);
    const double thrust = cubes * pyramids * z / q,
                 strength = squares * w * rho * rho / q;
    for (const auto &[thrust_above, strength_above] : above)
      least = std::max(least,
                       (thrust_above - thrust) / (strength_above + strength));
    above.push_back({{thrust, strength}});
    q_above = q;
    z_above = z;
    w_above = w;
  }
  return least;
}

void strength_of_domes()
{
  for (const auto &[n_courses, n_sectors] :
       std::vector<std::pair<unsigned int, unsigned int>>{{10, 12}, {20, 16}})
  {
    SpaceCase blocks = dome(n_courses, n_sectors, 0.05);
    blocks.turns = false;
    blocks.strength = 1.;
    check_strength_factor(
        text("Dome of ", n_courses, " by ", n_sectors, " that does not turn"),
        1. / least_strength_of_dome(n_courses, n_sectors, 0.05), blocks,
        body_force(blocks.packing, vector(0., 0., -1.)));
  }
  // That of a membrane, where phi is the golden ratio.
  const double limit = 0.5 * std::pow(0.5 * (1. + std::sqrt(5.)), -2.5);
  check_error("Limit of domes of fine blocks",
              std::abs(least_strength_of_dome(1000, 1000, 1e-3) / limit - 1.),
              5e-6);
}

void run()
{
  thickness_of_arches();
  thickness_of_domes();
  strength_of_arches();
  strength_of_domes();
}

const RoomTest test("space_shells", run);
} // namespace test_space_shells
