// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_state_assess_h
#define voussoir_analyses_state_assess_h

#include <voussoir/analyses/state/status.h>
#include <voussoir/scene/proofs/certificate.h>
#include <voussoir/terminal/terminal.h>

#include <optional>
#include <vector>

namespace Voussoir
{
/** The answer on the load, once there are forces that almost carry it. */
struct Assessment
{
  /** The status of the load. */
  Status status;
  /** The proof that it is not; empty if there is none. */
  Motion mechanism;
};

/**
 * Find out whether forces that the certificate accepts mean that the load is
 * carried. They do if they balance it to rounding, and each part to its own
 * forces. If not, they do if equilibrate() can make them so, or a step towards
 * any state within all limits, since what is admitted is convex. Otherwise a
 * proof of collapse is looked for: of the whole, and of each part that is not
 * balanced, with all heavier cells held, in a problem of its own scale.
 *
 * @param certificate of @p forces.
 */
Assessment assess(const Scene &scene,
                  const InterfaceForces &forces,
                  const Certificate &certificate,
                  Terminal &terminal);

/**
 * For a solver that ended without an answer: whether the analytic centre
 * carries the load.
 *
 * @return its largest force over the largest load on a cell; none if it was not
 *   found, which proves nothing.
 */
std::optional<double> carried_by_centre(const Scene &scene, Terminal &terminal);
} // namespace Voussoir

#endif
