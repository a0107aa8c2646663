// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_space_analysis_h
#define voussoir_analyses_space_analysis_h

#include <voussoir/algebra/linear/joint_system.h>
#include <voussoir/analyses/factors/factor_entries.h>
#include <voussoir/analyses/state/status.h>
#include <voussoir/scene/proofs/space_certificate.h>
#include <voussoir/scene/space/space_scene_parameters.h>
#include <voussoir/statics/problem/solver_controls.h>
#include <voussoir/terminal/terminal.h>

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json.hpp>

#include <memory>
#include <optional>
#include <string>

namespace Voussoir
{
/** What was found of blocks in space, in the user's units. */
struct SpaceAnswer
{
  /** The loads at which the forces balance; those of a factor with it. */
  SpaceScene scene;
  /** True if there are loads, and so anything to be found. */
  bool is_analysed = false;
  /** The answer on the loads. */
  Status status = {};
  /** The forces, none if the loads are not carried. */
  FaceForces forces = {};
  /** Their errors. */
  Certificate certificate = {};
  /**
   * The motion of the cells: of elastic joints with the modulus one, of the
   * mechanism beside a factor, or of the one in which the loads collapse.
   */
  SpaceMotion motion = {};
  /** True if that is a mechanism. */
  bool is_mechanism = false;
  /** The errors of a mechanism in which the loads collapse. */
  MechanismCertificate proof = {};
  /** What the analysis adds to summary.json. */
  nlohmann::ordered_json summary = {};
  /** If the loads are not carried by what, for the user. */
  std::string message = {};
};

/** What may be asked of blocks in space, and how it is answered. */
class SpaceAnalysis
{
public:
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
  /** The scene, and the one of live loads if they are asked for. */
  struct Scenes
  {
    SpaceScene dead;
    std::optional<SpaceScene> live;
  };
  Scenes scenes(const SpaceSceneParameters &parameters,
                const std::shared_ptr<const SpaceBlocks> &blocks,
                Terminal &terminal) const;
  SpaceAnswer state_of(SpaceScene scene, Terminal &terminal) const;
  SpaceAnswer
  factor_of(SpaceScene dead, SpaceScene live, Terminal &terminal) const;
  SpaceAnswer strength_factor_of(SpaceScene scene, Terminal &terminal) const;

  Question question = Question::state;
  FactorEntries factor;
  SolverControls controls;
  LinearSolver linear_solver = LinearSolver::automatic;
};
} // namespace Voussoir

#endif
