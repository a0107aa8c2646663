// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/analyses/space/clamping.h>
#include <voussoir/base/text.h>
#include <voussoir/scene/proofs/space_certificate.h>
#include <voussoir/statics/conic/opening_program.h>
#include <voussoir/statics/problem/discretise_space.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace Voussoir
{
namespace
{
/** The pressure of an interface, over the largest, that is not rounding. */
constexpr double least_pressure = 1e-9;

/** The blocks without loads, on joints that bear any pressure and nothing else:
 * those touch at all vertices. */
SpaceScene without_friction(const SpaceBlocks &blocks,
                            const Kinematics &kinematics)
{
  Strengths strengths;
  strengths.of_interface.resize(blocks.packing.interfaces().size(), 0.);
  return {std::make_shared<const SpaceBlocks>(blocks.packing,
                                              std::move(strengths), kinematics),
          SpaceLoads(blocks.packing.n_cells())};
}

/** The motion @p u, if it opens all interfaces. */
void keep_opening(const DiscreteProblem &problem,
                  const SpaceScene &scene,
                  std::vector<double> u,
                  Clamping &clamping)
{
  problem.remove_rigid_motions(u); // the ground is at rest
  const double size = largest_component(u);
  SpaceMotion motion = dimensional_motion(problem, scene, u, 1. / size);
  double least = std::numeric_limits<double>::infinity();
  for (const FaceJump &jump : jumps_of_faces(*scene.blocks, motion))
    least = std::min(least, jump.least_opening);
  if (!(least > 0.))
    return;
  clamping.least_opening = least;
  clamping.opening = std::move(motion);
  clamping.words = text("a motion opens all contacts, by at least ", least,
                        " of the largest displacement");
}

/** The pressures that were found, if they balance. */
void keep_self_stress(const DiscreteProblem &problem,
                      const SpaceScene &scene,
                      const Opening &found,
                      Clamping &clamping)
{
  Solution solution;
  for (const double pressure : found.self_stress)
    solution.forces.push_back(-pressure);
  FaceForces forces = dimensional_forces(problem, scene, solution);
  std::vector<double> of_interface;
  for (unsigned int e = 0; e < scene.packing().interfaces().size(); ++e)
    of_interface.push_back(forces.resultant(scene.packing(), e).force.norm());
  const double largest = largest_component(of_interface);
  for (PointForce &of : forces.list)
    of.force /= largest;
  const Certificate certificate = certify(scene, forces);
  if (!(certificate.error() <= largest_accepted_error))
    return;
  clamping.certificate = certificate;
  clamping.self_stress = std::move(forces);
  clamping.n_pressed = std::count_if(
      of_interface.begin(), of_interface.end(),
      [&](const double force) { return force > least_pressure * largest; });
  clamping.words = text(
      reason_of_no_opening(found, problem.has_ground()), " They press ",
      clamping.n_pressed, " of ", counted(of_interface.size(), "interface"),
      " and balance to ", certificate.error(), " of the largest.");
}

Clamping clamping_of(const SpaceScene &scene, Terminal &terminal)
{
  const DiscreteProblem problem = discretise(scene);
  const Opening found = find_opening_in_space(problem, terminal);
  Clamping clamping;
  // Unless a proof holds.
  clamping.words = reason_of_no_opening({}, problem.has_ground());
  if (!found.displacement.empty())
    keep_opening(problem, scene, found.displacement, clamping);
  else if (!found.self_stress.empty())
    keep_self_stress(problem, scene, found, clamping);
  return clamping;
}
} // namespace

Clamping find_clamping(const SpaceBlocks &blocks, Terminal &terminal)
{
  terminal.begin("Clamping");
  Clamping clamping;
  if (blocks.packing.interfaces().empty())
    clamping.words = "there are no contacts";
  else
  {
    // What opens without turning does so with it, at all vertices, and that is
    // a smaller problem.
    clamping = clamping_of(without_friction(blocks, translations_in_space()),
                           terminal);
    if (blocks.turns() && !clamping.opens())
      clamping =
          clamping_of(without_friction(blocks, *blocks.kinematics), terminal);
  }
  terminal.stage("Clamping", clamping.words);
  return clamping;
}

nlohmann::ordered_json json_of(const Clamping &clamping)
{
  nlohmann::ordered_json json = {{"clamped", nullptr},
                                 {"meaning", clamping.words}};
  if (clamping.opens() || clamping.is_clamped())
    json["clamped"] = clamping.is_clamped();
  if (clamping.opens())
    json["least_opening"] = clamping.least_opening;
  if (clamping.is_clamped())
    json["self_stress"] = {
        {"interfaces", clamping.n_pressed},
        {"equilibrium_residual", clamping.certificate.equilibrium_residual},
        {"moment_residual", clamping.certificate.moment_residual},
        {"admissibility_violation",
         clamping.certificate.admissibility_violation}};
  return json;
}
} // namespace Voussoir
