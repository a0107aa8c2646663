// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_space_analysis_h
#define voussoir_analyses_space_analysis_h

#include <voussoir/algebra/linear/joint_system.h>
#include <voussoir/analyses/factors/factor_entries.h>
#include <voussoir/analyses/ranges/range_entries.h>
#include <voussoir/analyses/space/answer.h>
#include <voussoir/scene/space/space_scene_parameters.h>
#include <voussoir/statics/energy/coulomb_state.h>
#include <voussoir/statics/energy/space_state.h>
#include <voussoir/statics/paper/smoothed_faces.h>
#include <voussoir/statics/problem/solver_controls.h>
#include <voussoir/terminal/terminal.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <optional>

namespace Voussoir
{
/** What may be asked of blocks in space, and how it is answered. */
class SpaceAnalysis
{
public:
  /** @param processes those that help, beside this one, their root. */
  explicit SpaceAnalysis(const ProcessGroup &processes = ProcessGroup())
  {
    controls.processes = processes;
  }
  /** Keep what is found on the way in @p journal, or nothing if it is null. */
  void keep_in(Journal *journal) { controls.journal = journal; }

  /** @{ */
  /** Declare the entry `Analysis`, and the sections. */
  void add_entries(dealii::ParameterHandler &prm);
  void add_sections(dealii::ParameterHandler &prm);
  /** @} */

  /**
   * Answer the question of the parameters.
   *
   * @param parameters have the loads.
   * @param blocks what they act on.
   * @param terminal sees the stages.
   * @throws InputError as the scenes do; SolverError if there is neither an
   *   answer that its certificate accepts nor a proof.
   */
  SpaceAnswer answer(const SpaceSceneParameters &parameters,
                     const std::shared_ptr<const SpaceBlocks> &blocks,
                     Terminal &terminal) const;

  /**
   * Show the loads, and refuse what answer() would before it solves anything.
   *
   * @throws InputError as the scenes do.
   */
  void check(const SpaceSceneParameters &parameters,
             const std::shared_ptr<const SpaceBlocks> &blocks,
             Terminal &terminal) const
  {
    scenes(parameters, blocks, terminal);
  }

private:
  enum class Question
  {
    state,
    load_factor
  };
  /** How one of the states is selected. */
  enum class Selection
  {
    least_energy,
    smoothed_friction
  };
  /** The scene, and the one of live loads if they are asked for. */
  struct Scenes
  {
    SpaceScene dead;
    std::optional<SpaceScene> live;
  };
  Scenes scenes(const SpaceSceneParameters &parameters,
                const std::shared_ptr<const SpaceBlocks> &blocks,
                Terminal &terminal) const;
  /** @throws InputError if what is asked besides cannot be. */
  void check_further(const SpaceSceneParameters &parameters,
                     const Packing<3> &packing) const;
  /** What selects the state of a scene. */
  const Formulation &formulation_for(const SpaceScene &scene) const;
  /** The answer of answer() on these loads. */
  SpaceAnswer answer_on(Scenes scenes,
                        const SpaceSceneParameters &parameters,
                        Terminal &terminal) const;
  SpaceAnswer state_of(SpaceScene scene, Terminal &terminal) const;
  void look_further(SpaceAnswer &answer,
                    const SpaceSceneParameters &parameters,
                    Terminal &terminal) const;
  SpaceAnswer
  factor_of(SpaceScene dead, SpaceScene live, Terminal &terminal) const;
  SpaceAnswer strength_factor_of(SpaceScene scene, Terminal &terminal) const;

  Question question = Question::state;
  bool finds_clamping = false;
  FactorEntries factor;
  RangeEntries ranges;
  SolverControls controls;
  Selection selection = Selection::least_energy;
  LeastEnergyInSpace least_energy;
  SmoothedFaces smoothed_friction;
  CoulombState coulomb_state = CoulombState(least_energy);
};
} // namespace Voussoir

#endif
