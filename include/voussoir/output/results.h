// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_results_h
#define voussoir_output_results_h

#include <voussoir/analyses/factors/load_factor.h>
#include <voussoir/analyses/ranges/ranges.h>
#include <voussoir/analyses/ranges/settlement.h>
#include <voussoir/analyses/samples/state_samples.h>
#include <voussoir/analyses/state/analysis.h>
#include <voussoir/scene/proofs/reactions.h>
#include <voussoir/scene/scene.h>
#include <voussoir/stress/cell_pieces.h>
#include <voussoir/stress/reconstruction.h>

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
  explicit RunRecord(const Scene &scene) : scene(scene) {}

  /** The scene that was given. */
  const Scene &scene;
  /** The entry `Title`. */
  std::string title;
  /** The number of processes started, also if the root solved alone. */
  unsigned int n_processes = 1;
  /** Wall clock time of each stage, in seconds. */
  std::map<std::string, double> timings;
};

/**
 * All that a run found whose load is carried, in the user's units. Vectors have
 * an element for each interface or for each cell of the scene's packing.
 */
struct Results : RunRecord, Carried
{
  /** Without what follows from the forces. */
  Results(RunRecord run, Carried found)
      : RunRecord(std::move(run)), Carried(std::move(found))
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
  /** The factor at which the forces are, if one was looked for. */
  std::optional<LoadFactor> load_factor;
  /** What the blocks do if supports move. */
  std::optional<Settlement> settlement;
  /** How much all states may differ, if that is asked for. */
  std::optional<Ranges> ranges;
  /** How much they differ as a rule, if that is asked for. */
  std::optional<StateSamples> samples;

  /** The settlement, or the mechanism at the load factor; null without one. */
  const Motion *motion_beside() const
  {
    if (settlement)
      return &settlement->motion;
    return load_factor && load_factor->has_mechanism() ? &load_factor->mechanism
                                                       : nullptr;
  }
};

/** All that a run found whose load is not carried, in the user's units. */
struct Collapse : RunRecord, NotCarried
{
  /** All of it. */
  Collapse(RunRecord run, NotCarried found)
      : RunRecord(std::move(run)), NotCarried(std::move(found))
  {}

  /** True if the live loads are none of them: a factor was looked for. */
  bool of_dead_loads = false;
};
} // namespace Voussoir

#endif
