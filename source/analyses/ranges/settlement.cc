// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/ranges/feasible_set.h>
#include <voussoir/analyses/ranges/settlement.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/scene/proofs/displacement_jumps.h>

#include <algorithm>

namespace Voussoir
{
namespace
{
/**
 * By how much the balance of each body is loosened, nondimensional, to choose
 * among motions of the same energy. The loosened programme has the sum of the
 * sizes of the unknowns times it in its dual objective, and if it is small
 * enough its motion is still one of least energy; that is judged.
 */
constexpr double first_loosening = 1e-6, last_loosening = 1e-9,
                 factor_of_loosening = 0.1;

/** The work of the ground on the displacements @p jumps of the supports. */
ForceFunction work_of_ground(const InterfaceJumps &jumps,
                             const Packing<2> &packing)
{
  ForceFunction work;
  const unsigned int n = packing.interfaces().size();
  for (unsigned int e = n - packing.n_supports(); e < n; ++e)
    work.terms.push_back({e, jumps.openings[e], jumps.sliding[e]});
  return work;
}

/** The greatest work where the limits of joints are curved. */
template <typename SceneOf>
GreatestValueOf<SceneOf>
by_interior_point(const FeasibleSetOf<SceneOf> &states,
                  const typename SceneOf::Function &work)
{
  std::optional<GreatestValueOf<SceneOf>> found =
      states.greatest(work, Terminal::silent());
  if (!found)
    throw SolverError("The settlement was not found: no forces and no motion "
                      "prove its work. The load may be close to what the "
                      "packing can carry.");
  return std::move(*found);
}

/**
 * Of all motions that prove the value in @p found, those of least energy, the
 * one whose unknowns have the least sum of sizes.
 */
void choose_motion(const FeasibleSet &states,
                   StateProgram program,
                   const ForceFunction &work,
                   GreatestValue &found)
{
  for (double by = first_loosening; by >= last_loosening;
       by *= factor_of_loosening)
  {
    program.loosen_balance(by);
    GreatestValue chosen = found;
    const GreatestValue loose = states.found(program, work);
    if (!loose.is_bounded())
      continue;
    chosen.motion = loose.motion;
    chosen.bound = loose.bound;
    if (states.is_proven(chosen))
    {
      found = chosen;
      return;
    }
  }
}
/** @throws InputError if no motion of least energy belongs to the forces. */
void check_settlement(const bool dilates,
                      const bool turns,
                      const bool has_angle)
{
  if (!dilates)
    throw InputError("'Supports/Displacement' is given, and 'Friction/Law' is "
                     "'Coulomb', for which no motion of least energy belongs "
                     "to the forces; set the law to 'Tresca' or 'associated "
                     "Coulomb', or leave the displacement empty.");
  if (!turns && has_angle)
    throw InputError("'Supports/Displacement' has an angle, and blocks do not "
                     "turn in this run; set 'Rotations = true', or leave the "
                     "angle out.");
}

/** @throws InputError if forces of any size resist. */
template <typename Greatest>
void check_resistance(const Greatest &found)
{
  if (!found.is_bounded())
    throw InputError(
        "The blocks cannot follow 'Supports/Displacement' without pressing "
        "into each other: forces of any size, which balance by themselves, "
        "resist it. Change the displacement, or let fewer edges be supports.");
}

/** The settlement of the greatest work over the largest displacement. */
template <typename SceneOf, typename OfSupports>
SettlementOf<SceneOf> settlement_of(GreatestValueOf<SceneOf> found,
                                    const OfSupports &of_supports,
                                    const double size)
{
  SettlementOf<SceneOf> settlement;
  settlement.motion = times(std::move(found.motion), size);
  settlement.motion.of_supports = of_supports;
  settlement.forces = std::move(found.forces);
  settlement.work = size * found.value;
  settlement.width = size * found.width();
  settlement.closing_violation = found.bound.closing_violation;
  settlement.largest_displacement = size;
  return settlement;
}

/** The work of the ground on the displacements of the supports in space. */
FaceFunction work_of_ground(const Packing<3> &packing,
                            const std::vector<SpaceSupportMotion> &of_supports)
{
  FaceFunction work;
  const unsigned int first = packing.interfaces().size() - packing.n_supports();
  for (unsigned int k = 0; k < of_supports.size(); ++k)
    work.terms.push_back({first + k, of_supports[k].displacement,
                          of_supports[k].rotation,
                          packing.interfaces()[first + k].centroid});
  return work;
}

/** The largest displacement at a vertex of a support. */
double largest_displacement(const Packing<3> &packing, const FaceFunction &work)
{
  double largest = 0.;
  for (const FaceFunction::Term &term : work.terms)
    for (const dealii::Point<3> &x : packing.polygon(term.interface))
      largest = std::max(largest, term.at(x).norm());
  return largest;
}
} // namespace

Settlement find_settlement(const Scene &scene,
                           const std::vector<SupportMotion> &of_supports)
{
  check_settlement(
      scene.dilates, scene.turns(),
      std::any_of(of_supports.begin(), of_supports.end(),
                  [](const SupportMotion &of) { return of.rotation != 0.; }));
  Motion at_rest(scene.packing.n_cells(), *scene.kinematics);
  at_rest.of_supports = of_supports;
  const InterfaceJumps jumps = jumps_of(scene.packing, at_rest);
  const double size = jumps.largest_displacement;
  const ForceFunction work =
      work_of_ground(jumps, scene.packing).times(1. / size);

  const FeasibleSet states(scene);
  std::optional<StateProgram> program;
  if (states.are_polyhedral())
    program.emplace(states.program());
  GreatestValue found = program ? states.greatest(*program, work)
                                : by_interior_point(states, work);
  check_resistance(found);
  if (program)
    choose_motion(states, *program, work, found);
  Settlement settlement =
      settlement_of<Scene>(std::move(found), of_supports, size);
  settlement.n_iterations = program ? program->n_iterations() : 0;
  return settlement;
}

SettlementOf<SpaceScene>
find_settlement(const SpaceScene &scene,
                const std::vector<SpaceSupportMotion> &of_supports)
{
  const SpaceBlocks &blocks = *scene.blocks;
  check_settlement(blocks.strengths.dilate, blocks.turns(),
                   std::any_of(of_supports.begin(), of_supports.end(),
                               [](const SpaceSupportMotion &of) {
                                 return of.rotation.norm() != 0.;
                               }));
  const FaceFunction work = work_of_ground(blocks.packing, of_supports);
  const double size = largest_displacement(blocks.packing, work);
  GreatestValueOf<SpaceScene> found = by_interior_point(
      FeasibleSetOf<SpaceScene>(scene), work.times(1. / size));
  check_resistance(found);
  return settlement_of<SpaceScene>(std::move(found), of_supports, size);
}
} // namespace Voussoir
