// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_results_h
#define voussoir_output_results_h

#include <voussoir/scene/certificate.h>
#include <voussoir/scene/load_parts.h>
#include <voussoir/scene/reactions.h>
#include <voussoir/scene/scene.h>
#include <voussoir/statics/status.h>
#include <voussoir/stress/reconstruction.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
/** The record of every run, whatever came out of it. */
struct RunRecord
{
  /** @param scene must outlive this object. */
  explicit RunRecord(const Scene &scene) : scene(scene)
  {
  }

  /** The scene that was given. */
  const Scene &scene;
  /** The entry `Title`. */
  std::string title;
  /** The number of processes started, also if the root solved alone. */
  unsigned int n_processes = 1;
  /** Formulation::name(). */
  std::string formulation;
  /** Formulation::selection(). */
  std::string selection;
  /** The reason for which the solver stopped. */
  std::string outcome;
  /** The same of the solver that found the forces, if they were read. */
  std::string earlier_outcome;
  /** Solution::n_iterations. */
  unsigned int n_iterations = 0;
  /** Solution::n_evaluations. */
  unsigned int n_evaluations = 0;
  /** Solution::seconds. */
  std::map<std::string, double> solver_seconds;

  /** Wall clock time of each stage, in seconds. */
  std::map<std::string, double> timings;
};

/**
 * All that a run found whose load is carried, in the user's units. Vectors have
 * an element for each interface or for each cell of the scene's packing.
 */
struct Results : RunRecord
{
  /** With nothing found yet. */
  explicit Results(RunRecord run) : RunRecord(std::move(run))
  {
  }

  /** f_e^n <= 0 and f_e^t of each interface; S L. */
  InterfaceForces forces;
  /** Solution::correction. */
  std::optional<double> correction;
  /** @{ */
  /** Of each interface, or empty if the formulation does not tell. */
  std::vector<bool> never_pressed, always_sliding;
  /** @} */
  /** u_c of each cell, see Solution::displacement; L. */
  std::vector<dealii::Tensor<1, 2>> displacement;
  /** The errors of the forces. */
  Certificate certificate;
  /** The status of the load that follows from them. */
  Status status;
  /** Of each straight support. */
  std::vector<Reaction> reactions;
  /** residual_torques() of each cell, S L^2; empty if not asked for. */
  std::vector<double> torques;
  /** cell_mean_stresses() of each cell, S; empty if not asked for. */
  std::vector<dealii::Tensor<2, 2>> mean_stresses;
  /** In the sub-cells of each cell; empty if not asked for. */
  StressField stress;
};

/** All that a run found whose load is not carried, in the user's units. */
struct Collapse : RunRecord
{
  /** With nothing found yet. */
  explicit Collapse(RunRecord run) : RunRecord(std::move(run))
  {
  }

  /** Of each cell along the mechanism; the largest component is one. */
  std::vector<dealii::Tensor<1, 2>> displacement;
  /** The errors of the mechanism as a proof. */
  MechanismCertificate proof;
  /** The loads that drive the mechanism, the most work first. */
  std::vector<LoadPart> parts;
};
} // namespace Voussoir

#endif
