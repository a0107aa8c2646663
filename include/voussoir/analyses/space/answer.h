// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_space_answer_h
#define voussoir_analyses_space_answer_h

#include <voussoir/analyses/ranges/space_ranges.h>
#include <voussoir/analyses/space/clamping.h>
#include <voussoir/analyses/state/status.h>
#include <voussoir/scene/proofs/space_certificate.h>
#include <voussoir/scene/space/space_scene.h>

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

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
  /** The loads of which it bounds the factor; none of others. */
  std::optional<SpaceLoads> live = {};
  /** The errors of a mechanism in which the loads collapse. */
  MechanismCertificate proof = {};
  /** The ranges of forces over all states, if they are asked for. */
  std::optional<SpaceRanges> ranges = {};
  /** Whether the blocks are clamped, if it is asked for; with or without loads.
   */
  std::optional<Clamping> clamping = {};
  /** What is said beside the forces, for people: titles and lines. */
  std::vector<std::pair<std::string, std::string>> lines = {};
  /** What the analysis adds to summary.json. */
  nlohmann::ordered_json summary = {};
  /** If the loads are not carried by what, for the user. */
  std::string message = {};
  /** A factor as a sentence with few digits. */
  std::string sentence = {};

  /** Whether forces were found; without joints there are none, and it is. */
  bool is_carried() const
  {
    return is_analysed && status.kind != Status::Kind::collapse;
  }
};

/**
 * Judge the forces of an answer and fill in the status.
 *
 * @throws SolverError if their errors are too large.
 */
void judge_forces(SpaceAnswer &answer);

/**
 * Judge the motion of an answer as a mechanism, and fill in status and message.
 *
 * @param what collapses, as the beginning of a sentence.
 * @throws SolverError if it proves nothing.
 */
void judge_mechanism(SpaceAnswer &answer, const std::string &what);
} // namespace Voussoir

#endif
