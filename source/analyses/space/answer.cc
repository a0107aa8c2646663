// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/space/answer.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
namespace
{
/** The largest error of forces that is rounding; see largest_accepted_error.
 * Displacements add up over the cells across a packing. */
double rounding_of_forces(const unsigned int n_cells)
{
  return std::max(1e-11, 100. * std::numeric_limits<double>::epsilon() *
                             std::sqrt(double(n_cells)));
}

std::string words_of_error(const SpaceScene &scene, const LargestError &largest)
{
  const char *const what =
      largest.kind == LargestError::Kind::balance  ? "the balance of forces"
      : largest.kind == LargestError::Kind::moment ? "the balance of moments"
                                                   : "a limit of forces";
  return text(what, " at ", scene.packing().describe(largest.cell), " at ",
              text_of_point(scene.packing().centre(largest.cell)));
}
} // namespace

void judge_forces(SpaceAnswer &answer)
{
  answer.certificate = certify(answer.scene, answer.forces);
  const double error = answer.certificate.error();
  if (!(error <= largest_accepted_error))
    throw SolverError(
        text("The forces that were found are wrong by ", error,
             " of the largest load, in ",
             words_of_error(answer.scene, answer.certificate.largest),
             ". The load is close to what the packing can carry, or the sizes "
             "of blocks or strengths differ by too much; look whether other "
             "units or loads help."));
  if (error <= rounding_of_forces(answer.scene.packing().n_cells()))
    answer.status = {Status::Kind::solved, 0.};
  else
    answer.status = {Status::Kind::carried_within, error};
}

void judge_mechanism(SpaceAnswer &answer, const std::string &what)
{
  answer.proof = certify_mechanism(answer.scene, answer.motion);
  if (!proves_collapse(answer.proof))
    throw SolverError(
        text("A mechanism was found that proves nothing: joints close by ",
             answer.proof.closing_violation,
             " of the displacement, and the loads do ",
             answer.proof.work_over_dissipation,
             " times the work that friction dissipates. The load is close to "
             "what the packing can carry."));
  answer.is_mechanism = true;
  answer.status = {Status::Kind::collapse, 0.};
  answer.message = text(what, " in a mechanism in which joints close by ",
                        answer.proof.closing_violation,
                        " of the displacement, and the loads do ",
                        std::isfinite(answer.proof.work_over_dissipation)
                            ? text(answer.proof.work_over_dissipation,
                                   " times the work that strengths dissipate.")
                            : "work that no strength dissipates.");
}
} // namespace Voussoir
