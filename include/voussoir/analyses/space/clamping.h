// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_space_clamping_h
#define voussoir_analyses_space_clamping_h

#include <voussoir/scene/proofs/certificate_measures.h>
#include <voussoir/scene/space/face_forces.h>
#include <voussoir/scene/space/space_motion.h>
#include <voussoir/scene/space/space_scene.h>
#include <voussoir/terminal/terminal.h>

#include <nlohmann/json.hpp>

#include <string>

namespace Voussoir
{
/**
 * Whether a motion opens every interface of blocks in space at all of its
 * vertices, or the blocks are clamped, since pressures balance by themselves.
 * Geometry, supports and the motions of blocks decide it, and neither loads nor
 * strengths. Each has a proof that is added up again from the blocks alone.
 */
struct Clamping
{
  /** The motion; empty if there is none. The largest component of a
   * displacement is one. */
  SpaceMotion opening = {};
  /** The least opening of an interface at a vertex in it; L. */
  double least_opening = 0.;
  /** Normal forces that balance without loads; empty if there are none. The
   * largest one of an interface is one. */
  FaceForces self_stress = {};
  /** Their errors. */
  Certificate certificate = {};
  /** The number of interfaces that they press; no motion in which none closes
   * opens one of these. */
  unsigned int n_pressed = 0;
  /** What was found, for people. */
  std::string words = {};

  /** True if a motion opens all. */
  bool opens() const { return !opening.displacement.empty(); }
  /** True if pressures balance by themselves. */
  bool is_clamped() const { return !self_stress.empty(); }
};

/** Find out. Neither is true where rounding does not tell which is. */
Clamping find_clamping(const SpaceBlocks &blocks, Terminal &terminal);

/** The part of summary.json. */
nlohmann::ordered_json json_of(const Clamping &clamping);
} // namespace Voussoir

#endif
