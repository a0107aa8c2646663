// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_results_h
#define voussoir_output_results_h

#include <voussoir/statics/certificate.h>
#include <voussoir/statics/load_parts.h>
#include <voussoir/statics/reactions.h>
#include <voussoir/statics/scene.h>
#include <voussoir/stress/reconstruction.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
/** What is known of every run, whatever came out of it. */
struct RunRecord
{
  explicit RunRecord(const Scene &scene) : scene(scene)
  {
  }

  const Scene &scene;

  std::string title;
  /** How many were started, also if the root solved alone. */
  unsigned int n_processes = 1;
  std::string formulation;
  std::string selection;
  /** Why the solver stopped. */
  std::string outcome;
  /** Of forces that were read, why the solver that found them stopped. */
  std::string earlier_outcome;
  unsigned int n_iterations = 0;
  unsigned int n_evaluations = 0;
  /** See Solution. */
  std::map<std::string, double> solver_seconds;

  /** Wall clock time of each stage, in seconds. */
  std::map<std::string, double> timings;
};

/** All that a run found whose load is carried, in the user's units. */
struct Results : RunRecord
{
  explicit Results(RunRecord run) : RunRecord(std::move(run))
  {
  }

  InterfaceForces forces;
  /** See Solution. */
  std::optional<double> correction;
  /** Of each interface, or empty if the formulation does not tell. */
  std::vector<bool> never_pressed, always_sliding;
  std::vector<dealii::Tensor<1, 2>> displacement;
  Certificate certificate;
  std::vector<Reaction> reactions;
  std::vector<double> torques;
  std::vector<dealii::Tensor<2, 2>> mean_stresses;
  StressField stress;
};

/** All that a run found whose load is not carried, in the user's units. */
struct Collapse : RunRecord
{
  explicit Collapse(RunRecord run) : RunRecord(std::move(run))
  {
  }

  /** Of each cell along the mechanism; the largest component is one. */
  std::vector<dealii::Tensor<1, 2>> displacement;
  MechanismCertificate proof;
  /** What drives the mechanism, the most work first. */
  std::vector<LoadPart> parts;
};
} // namespace Voussoir

#endif
