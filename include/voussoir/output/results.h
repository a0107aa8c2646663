// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_results_h
#define voussoir_output_results_h

#include <voussoir/analyses/analysis.h>
#include <voussoir/scene/proofs/reactions.h>
#include <voussoir/scene/scene.h>
#include <voussoir/stress/cell_pieces.h>
#include <voussoir/stress/reconstruction.h>

#include <nlohmann/json.hpp>

#include <any>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
/** The record of every run, whatever came out of it. */
struct RunRecord : SolverRecord
{
  /** @param scene must outlive this object. */
  RunRecord(const Scene &scene, SolverRecord solver)
      : SolverRecord(std::move(solver)), scene(scene)
  {}

  /** The scene that was given. */
  const Scene &scene;
  /** The entry `Title`. */
  std::string title;
  /** The number of processes started, also if the root solved alone. */
  unsigned int n_processes = 1;
  /** Wall clock time of each stage, in seconds. */
  std::map<std::string, double> timings;
  /** See provenance_of(); null unless they are written. */
  nlohmann::ordered_json provenance;
};

/**
 * All that a run found whose load is carried, in the user's units. Vectors have
 * an element for each interface or for each cell of the scene's packing.
 */
struct Results : RunRecord, Carried
{
  /** Without what follows from the forces. */
  Results(RunRecord run, Carried found, std::vector<AnalysisResult> analyses)
      : RunRecord(std::move(run)), Carried(std::move(found)),
        analyses(std::move(analyses))
  {}

  /** Of each straight support. */
  std::vector<Reaction> reactions;
  /** residual_torques() of each cell, S L^2; empty if not asked for. */
  std::vector<double> torques;
  /** cell_mean_stresses() of each cell, S; empty if not asked for. */
  std::vector<dealii::Tensor<2, 2>> mean_stresses;
  /** Where some are cut into pieces for the stress. */
  std::optional<CellPieces> pieces;
  /** In the sub-cells of each cell, or piece; empty if not asked for. */
  StressField stress;
  /** What is said beside forces. */
  std::vector<AnalysisResult> analyses;

  /** The object that is AnalysisResult::data, as Ranges; null without one. */
  template <typename Data>
  const Data *data() const
  {
    for (const AnalysisResult &analysis : analyses)
      if (const auto *const found = std::any_cast<Data>(&analysis.data))
        return found;
    return nullptr;
  }

  /** The first motion that an analysis has found; null without one. */
  const MotionBeside *motion_beside() const
  {
    for (const AnalysisResult &analysis : analyses)
      if (analysis.motion)
        return &*analysis.motion;
    return nullptr;
  }
};

/** All that a run found whose load is not carried, in the user's units. */
struct Collapse : RunRecord, NotCarried
{
  /** All of it. */
  Collapse(RunRecord run, NotCarried found)
      : RunRecord(std::move(run)), NotCarried(std::move(found))
  {}
};
} // namespace Voussoir

#endif
