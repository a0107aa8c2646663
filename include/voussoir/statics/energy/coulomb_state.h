// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_energy_coulomb_state_h
#define voussoir_statics_energy_coulomb_state_h

#include <voussoir/statics/problem/formulation.h>

#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/**
 * The fixed point
 *
 *     s_e |e|  <-  c_e |e| + mu_e p_e
 *
 * of the strengths of Tresca's friction (in space of each pressure and disc,
 * see limits_of_coulomb()), with the compression p_e of the state that a
 * formulation selects with them, accelerated by Anderson: Coulomb's friction
 * without dilatancy, where blocks slide along their joints and do not lift.
 * There may be none, or several: the limits depend on the state itself, and no
 * theorem of limit analysis holds. It starts from joints that do not slide.
 */
class CoulombState : public Formulation
{
public:
  /** @param of_passes selects the states; it must outlive this object. */
  explicit CoulombState(const Formulation &of_passes) : of_passes(of_passes) {}
  std::string name() const override
  {
    return "fixed point, " + of_passes.name();
  }
  std::string meaning() const override
  {
    return "strengths that are those of Coulomb's friction in their own state.";
  }
  std::string selection() const override
  {
    return selection_with(of_passes.selection());
  }

  /**
   * Find the state.
   *
   * @param problem with coefficients of friction.
   * @param controls of each pass.
   * @param failure says why there is neither.
   * @param terminal sees the passes.
   * @return the state, if it has converged(); the mechanism, if no admissible
   *   forces balance the loads; or neither.
   */
  Solution find(const DiscreteProblem &problem,
                const SolverControls &controls,
                std::string &failure,
                Terminal &terminal) const;

private:
  static std::string selection_with(const std::string &of_passes)
  {
    return "with the strengths of Coulomb's friction, which are its own, " +
           of_passes;
  }
  /** The state, or the proof of collapse. */
  Solution select(const DiscreteProblem &problem,
                  const SolverControls &controls,
                  Terminal &terminal) const override;

  const Formulation &of_passes;
};
} // namespace Voussoir

#endif
