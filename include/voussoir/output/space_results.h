// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_space_results_h
#define voussoir_output_space_results_h

#include <voussoir/analyses/space/answer.h>
#include <voussoir/scene/proofs/space_reactions.h>
#include <voussoir/stress/linear_stress.h>
#include <voussoir/stress/tetrahedral_stress.h>

#include <nlohmann/json.hpp>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
/** The least and the greatest principal stress; S. */
struct PrincipalStresses
{
  /** @{ */
  /** One of them. */
  double least = 0.;
  double greatest = 0.;
  /** @} */
};

/** All that is written of blocks in space. */
struct SpaceResults : SpaceAnswer
{
  /** Without what follows from the forces. */
  explicit SpaceResults(SpaceAnswer answer) : SpaceAnswer(std::move(answer)) {}

  /** Of each support; none without forces. */
  std::vector<SpaceReaction> reactions;
  /** cell_mean_stresses() of each cell that moves; empty without forces. */
  std::vector<dealii::Tensor<2, 3>> mean_stresses;
  /** linear_stresses() of each; empty if not asked for. */
  std::vector<LinearStress> stresses;
  /** tetrahedral_stress(), if it is asked for. */
  std::optional<TetrahedralStress> tetrahedra;
  /**
   * The extremes of each cell: anywhere in it of a linear stress, of its
   * tetrahedra, or else of its mean stress.
   */
  std::vector<PrincipalStresses> principal;
  /** The wall clock time of each stage; s. */
  std::map<std::string, double> timings;
  /** See provenance_of(); null unless they are written. */
  nlohmann::ordered_json provenance;

  /** Find them, from whichever stress there is. */
  void find_principal_stresses();
};

/** Those of the symmetric part of a tensor. */
PrincipalStresses principal_stresses(const dealii::Tensor<2, 3> &sigma);
} // namespace Voussoir

#endif
