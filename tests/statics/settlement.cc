// SPDX-License-Identifier: LGPL-2.1-or-later

// Supports that move: arches whose supports spread or close, by the thrust that
// each joint allows and the kinematics of three hinges; blocks on a floor that
// tilts and beside a wall that rises, or crushes; the thrust is an end of its
// range; and what is refused.

#include <voussoir/analyses/ranges/ranges.h>
#include <voussoir/analyses/settlement_analysis.h>
#include <voussoir/packing/cell_groups.h>
#include <voussoir/scene/proofs/displacement_jumps.h>
#include <voussoir/scene/proofs/reactions.h>
#include <voussoir/scene/supports.h>

#include "tests.h"

namespace test_settlement
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

/** Supports with the settings of the section, of @p packing. */
std::vector<SupportMotion> motion_of(const Packing<2> &packing,
                                     const std::string &displacement,
                                     const std::string &of_groups = "")
{
  SupportParameters parameters;
  dealii::ParameterHandler prm;
  parameters.add_parameters(prm);
  prm.enter_subsection("Supports");
  prm.set("Displacement", displacement);
  prm.set("Group displacements", of_groups);
  prm.leave_subsection();
  return parameters.motion(packing);
}

/** The settlement, with checks of both proofs and that they fit each other. */
Settlement find_and_check(const std::string &name,
                          const Scene &scene,
                          const std::string &displacement)
{
  std::cout << name << std::endl;
  const Settlement found =
      find_settlement(scene, motion_of(scene.packing, displacement));
  check_error("  state", certify(scene, found.forces).error(), 1e-9);
  check_error("  joints close", found.closing_violation, 1e-9);
  const InterfaceJumps jumps = jumps_of(scene.packing, found.motion);
  // What the forces lack of the resistance to the jumps they go with.
  double gap = 0., force = 1e-2;
  for (unsigned int e = 0; e < jumps.sliding.size(); ++e)
  {
    const std::array<double, 2> ends = found.forces.ends(e);
    gap = std::max(gap,
                   std::abs(scene.limits(e)
                                .resistance(jumps.openings[e], jumps.sliding[e])
                                .dissipation -
                            ends[0] * jumps.openings[e][0] -
                            ends[1] * jumps.openings[e][1] -
                            found.forces.tangential[e] * jumps.sliding[e]));
    force = std::max(force, -found.forces.normal[e]);
  }
  check_error("  forces and jumps", gap / (force * found.largest_displacement),
              1e-9);
  return found;
}

/** The thrust of the right support of an arch, inwards. */
double thrust_of(const Scene &scene, const InterfaceForces &forces)
{
  for (const Reaction &reaction : reactions(scene, forces))
    if (reaction.start[0] > 0.)
      return -reaction.force[0];
  return 0.;
}

/**
 * Lines of thrust of half an arch by statics alone: with the thrust H through
 * (0, m / H) at the crown, the resultant of a joint passes beyond its inner end
 * if m >= H y + M there, M being the moment of the weights from the crown to
 * it, and within its outer end if m <= H y + M.
 */
class LinesOfThrust
{
public:
  explicit LinesOfThrust(const Scene &scene)
  {
    const Packing<2> &packing = scene.packing;
    for (const Packing<2>::Interface &i : packing.interfaces())
    {
      const Point<2> middle = i.midpoint();
      if (middle[0] < -1e-9)
        continue;
      const bool starts_inside = i.start.norm() < i.end.norm();
      const auto add = [&](const Point<2> &end, std::vector<End> &ends) {
        double moment = 0.;
        for (unsigned int c = 0; c < packing.n_cells(); ++c)
        {
          const Point<2> &x = packing.centre(c);
          if (x[0] > 0. && x[0] * middle[1] < x[1] * middle[0])
            moment -= scene.load[c][1] * (end[0] - x[0]);
        }
        ends.push_back({end, moment});
      };
      add(starts_inside ? i.start : i.end, inner);
      add(starts_inside ? i.end : i.start, outer);
    }
  }

  /** The least or, with the sign -1, the greatest thrust within all joints. */
  double farthest(const double sign) const
  {
    // room() is concave.
    double low = 0., high = 10.;
    for (unsigned int k = 0; k < 300; ++k)
    {
      const double third = (high - low) / 3.;
      (room(low + third) < room(high - third) ? low : high) =
          room(low + third) < room(high - third) ? low + third : high - third;
    }
    double inside = low, outside = sign > 0. ? 0. : 10.;
    for (unsigned int k = 0; k < 200; ++k)
    {
      const double middle = 0.5 * (inside + outside);
      (room(middle) >= 0. ? inside : outside) = middle;
    }
    return inside;
  }

  /** The inner end that the line with the thrust @p H passes through. */
  Point<2> touched(const double H) const { return lowest(H)->at; }

private:
  struct End
  {
    Point<2> at;
    double moment;
  };

  std::vector<End>::const_iterator lowest(const double H) const
  {
    return std::max_element(
        inner.begin(), inner.end(), [&](const End &a, const End &b) {
          return H * a.at[1] + a.moment < H * b.at[1] + b.moment;
        });
  }
  double room(const double H) const
  {
    double highest = 1e300;
    for (const End &end : outer)
      highest = std::min(highest, H * end.at[1] + end.moment);
    return highest - (H * lowest(H)->at[1] + lowest(H)->moment);
  }

  std::vector<End> inner, outer;
};

void spreading_arch(const double thickness)
{
  const Scene scene = under_weight(on_ground(semicircle(400, thickness)), 100.,
                                   0., rotations());
  const double spread = 0.01;
  const Settlement found =
      find_and_check("a spreading arch, t = " + std::to_string(thickness),
                     scene, "x > 0 ? 0.01 : 0; 0");
  const LinesOfThrust lines(scene);
  const double least = lines.farthest(1.);
  const Point<2> haunch = lines.touched(least);
  double top = 0.;
  for (const Packing<2>::Interface &i : scene.packing.interfaces())
    top = std::max({top, i.start[1], i.end[1]});
  check_error("  least thrust",
              std::abs(thrust_of(scene, found.forces) / least - 1.), 1e-8);
  std::cout << "  " << least << ", hinges at "
            << std::atan2(haunch[0], haunch[1]) * 180. / dealii::numbers::PI
            << " degrees" << std::endl;

  // Three hinges, and the motion about them.
  const InterfaceJumps jumps = jumps_of(scene.packing, found.motion);
  unsigned int n_hinges = 0;
  double distance = 0.;
  for (unsigned int e = 0; e < jumps.sliding.size(); ++e)
  {
    const std::array<double, 2> &opening = jumps.openings[e];
    if (std::max(opening[0], opening[1]) < 1e-6 * spread)
      continue;
    ++n_hinges;
    const Packing<2>::Interface &i = scene.packing.interfaces()[e];
    const Point<2> hinge = opening[0] < opening[1] ? i.start : i.end;
    const Point<2> classical =
        std::abs(hinge[0]) < 1e-9
            ? Point<2>(0., top)
            : Point<2>(std::copysign(haunch[0], hinge[0]), haunch[1]);
    distance = std::max(distance, (hinge - classical).norm());
  }
  check("  three hinges", n_hinges == 3);
  check_error("  at the classical places", distance, 1e-9);
  const double turn = 0.5 * spread / (top - haunch[1]);
  double drop = 0.;
  for (unsigned int c = 0; c < scene.packing.n_cells(); ++c)
    drop = std::max(drop, -found.motion.at(c, Point<2>(0., top) -
                                                  scene.packing.centre(c))[1] *
                              (std::abs(scene.packing.centre(c)[0]) < 0.01));
  check_error("  the crown comes down",
              std::abs(drop / (turn * haunch[0]) - 1.), 1e-8);

  // The same thrust is the end of its range.
  const Ranges ranges = find_ranges(
      scene,
      {std::vector<bool>(scene.packing.interfaces().size(), false), true},
      Terminal::silent());
  const std::vector<Reaction> supports = reactions(scene, found.forces);
  for (unsigned int s = 0; s < supports.size(); ++s)
    if (supports[s].start[0] > 0.)
      check_error("  the end of its range",
                  std::abs(-ranges.reactions[s][0].greatest / least - 1.),
                  1e-8);
}

void closing_arch(const double thickness)
{
  const Scene scene = under_weight(on_ground(semicircle(400, thickness)), 100.,
                                   0., rotations());
  const Settlement found =
      find_and_check("a closing arch, t = " + std::to_string(thickness), scene,
                     "if(x > 0, -0.01, 0); 0");
  const double greatest = LinesOfThrust(scene).farthest(-1.);
  check_error("  greatest thrust",
              std::abs(thrust_of(scene, found.forces) / greatest - 1.), 1e-8);
  std::cout << "  " << greatest << std::endl;
}

void floor_that_tilts()
{
  const Scene scene =
      under_weight(on_ground(wall(2, 1, 1., 1.)), 10., 0., rotations());
  const Settlement found =
      find_and_check("a floor that tilts and sinks", scene,
                     "0.02 - 1e-3 * y; -0.1 + 1e-3 * (x - 0.5); 1e-3");
  double error = 0.;
  for (unsigned int c = 0; c < scene.packing.n_cells(); ++c)
  {
    const Point<2> &x = scene.packing.centre(c);
    const Tensor<1, 2> u({0.02 - 1e-3 * x[1], -0.1 + 1e-3 * (x[0] - 0.5)});
    error = std::max({error, (found.motion.displacement[c] - u).norm(),
                      std::abs(found.motion.rotation[c] - 1e-3)});
  }
  check_error("  the blocks go with it", error, 1e-10);
}

/** A block of weight one on the ground, and a wall beside it that rises. */
void wall_that_rises(const double strength)
{
  Packing<2> packing = wall(1, 1, 1., 1.);
  std::vector<bool> rests;
  for (const auto &edge : packing.boundary_edges())
    rests.push_back(edge.normal[1] < -0.5 || edge.normal[0] > 0.5);
  packing.support(rests);
  const Scene scene = under_weight(packing, strength, 0., translations());
  const Settlement found =
      find_and_check("a wall that rises, s = " + std::to_string(strength),
                     scene, "0; nx > 0.5 ? 0.25 : 0");
  // The wall carries the block up, or slides past it.
  const double up = strength > 1. ? 0.25 : 0.;
  check_error("  the block",
              (found.motion.displacement[0] - Tensor<1, 2>({0., up})).norm(),
              1e-10);
  check_error("  its work",
              std::abs(found.work - 0.25 * std::min(strength, 1.)), 1e-10);
}

/**
 * A block that crushes at four times its weight, which a smooth wall pushes as
 * far as it yields: with the root of three times its weight, see
 * statics/ranges.
 */
void wall_that_crushes()
{
  std::cout << "a wall that crushes" << std::endl;
  const Scene scene = crushing_beside_smooth_wall();
  const Settlement found = find_settlement(
      scene, motion_of(scene.packing, "nx > 0.5 ? -0.1 : 0; 0"));
  const double exact = 0.1 * std::sqrt(3.);
  check_error("  its work", std::abs(found.work - exact), 1e-8);
  std::cout << "  " << description_of(scene, found) << std::endl;
}

/** Dry friction: what is carried along needs no force. */
void floor_that_slides()
{
  const Scene scene =
      under_weight(on_ground(wall(3, 2, 2., 1.)), 0., 0.5, translations());
  const Settlement found =
      find_and_check("a floor that slides", scene, "0.3; 0");
  double error = 0.;
  for (const Tensor<1, 2> &u : found.motion.displacement)
    error = std::max(error, (u - Tensor<1, 2>({0.3, 0.})).norm());
  check_error("  the blocks go with it", error, 1e-10);
  check_error("  without work", std::abs(found.work), 1e-10);
}

void random_walls()
{
  for (const unsigned int seed : {1, 2, 3})
    for (const Kinematics *kinematics : {&translations(), &rotations()})
      for (const double mu : {0., 0.5})
      {
        const Scene scene = under_weight(on_ground(random_packing(40, seed)),
                                         0.5, mu, *kinematics);
        find_and_check("40 cells, " + kinematics->name() +
                           (mu > 0. ? ", Coulomb" : ", Tresca"),
                       scene, "0; x > 0.5 ? -1e-3 : 0");
      }
}

/** Supports by the names of their cells. */
void groups()
{
  Packing<2> packing = on_ground(wall(2, 3, 3., 1.));
  assign_groups(packing, "left: x < 1 | right: x > 2");
  const auto by_place =
      motion_of(packing, "0; x < 1 ? -2 : x > 2 ? 3 : 1; x > 2 ? 0.1 : 0");
  const auto by_name =
      motion_of(packing, "0; 1", "left: 0; -2 | right: 0; 3; 0.1");
  double difference = 0.;
  for (unsigned int k = 0; k < by_name.size(); ++k)
    difference += (by_name[k].displacement - by_place[k].displacement).norm() +
                  std::abs(by_name[k].rotation - by_place[k].rotation);
  check("supports by groups", by_name.size() == 3 && difference == 0.);
  check("others stay",
        motion_of(packing, "", "left: 0; -2")[1].displacement.norm() == 0.);
  show_refusal([&] { motion_of(packing, "", "middle: 0; 1"); });
  show_refusal([&] { motion_of(packing, "", "cell 5: 0; 1"); });
  show_refusal([&] { motion_of(packing, "", "left: 0; 1 | cell 0: 0; 2"); });
  show_refusal([&] { motion_of(packing, "", "left: 1"); });
  show_refusal([&] { motion_of(packing, "", "left: 0; 0"); });
}

void refusals()
{
  Packing<2> packing = wall(1, 1, 1., 1.);
  const Packing<2> on_nothing = packing;
  std::vector<bool> rests;
  for (const auto &edge : packing.boundary_edges())
    rests.push_back(std::abs(edge.normal[0]) > 0.5 || edge.normal[1] < -0.5);
  packing.support(rests);
  Scene scene = under_weight(packing, 1., 0., translations());
  show_refusal([&] {
    find_settlement(scene, motion_of(packing, "nx > 0.5 ? -1 : 0; 0"));
  });
  show_refusal([&] { motion_of(on_nothing, "1; 0"); });
  show_refusal([&] { motion_of(packing, "1"); });
  show_refusal([&] { motion_of(packing, "1; 0; 0; 0"); });
  show_refusal([&] { motion_of(packing, "0; 0"); });
  show_refusal([&] { motion_of(packing, "1 / (x - x); 0"); });
  show_refusal([&] { find_settlement(scene, motion_of(packing, "0; 0; 1")); });
  scene.coefficient.assign(scene.strength.size(), 0.5);
  scene.dilates = false;
  show_refusal([&] { find_settlement(scene, motion_of(packing, "0; 1")); });
}

void run()
{
  spreading_arch(0.15);
  spreading_arch(0.3);
  closing_arch(0.15);
  closing_arch(0.3);
  floor_that_tilts();
  wall_that_rises(0.3);
  wall_that_rises(3.);
  wall_that_crushes();
  floor_that_slides();
  random_walls();
  groups();
  refusals();
}

const RoomTest test("settlement", run);
} // namespace test_settlement
