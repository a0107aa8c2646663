// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_state_solver_parameters_h
#define voussoir_analyses_state_solver_parameters_h

#include <voussoir/scene/scene.h>
#include <voussoir/statics/conic/feasible_state.h>
#include <voussoir/statics/energy/coulomb_state.h>

#include <memory>
#include <vector>

namespace Voussoir
{
/** The entry `Formulation` and the section `Solver`. */
class SolverParameters
{
public:
  /** With all formulations, and the processes that can help them. */
  explicit SolverParameters(const ProcessGroup &processes = ProcessGroup());

  /** Keep what is found on the way in @p journal, or nothing if it is null. */
  void keep_in(Journal *journal) { common.journal = journal; }
  /** Declare the entry and the section, and bind them. */
  void add_parameters(dealii::ParameterHandler &prm);

  /** The one that was chosen, with its parameters. */
  const Formulation &formulation() const { return *formulations[chosen]; }
  /** The chosen one, or FeasibleState or CoulombState if joints of @p scene
   * need it.
   */
  const Formulation &formulation_for(const Scene &scene) const;
  /** The one of Coulomb's friction without dilatancy. */
  const CoulombState &coulomb() const { return coulomb_state; }

  /** The controls that all formulations share. */
  const SolverControls &controls() const { return common; }

private:
  std::vector<std::unique_ptr<Formulation>> formulations;
  unsigned int chosen = 0;
  FeasibleState any_state;
  CoulombState coulomb_state;
  SolverControls common;
};
} // namespace Voussoir

#endif
