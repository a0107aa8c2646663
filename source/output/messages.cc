// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/messages.h>
#include <voussoir/statics/formulation.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Voussoir
{
namespace
{
std::string faults(const Certificate &certificate)
{
  return text("a residual of ", certificate.equilibrium_residual,
              " and a violation of ", certificate.admissibility_violation,
              " of the largest load on a cell");
}

/** The message on a load that is carried to a small error only. */
std::string inexact(const Results &results)
{
  const Scene &scene = results.scene;
  std::string where;
  const std::vector<UnbalancedCell> &cells = results.certificate.unbalanced;
  if (!cells.empty())
  {
    const UnbalancedCell &worst = *std::max_element(
        cells.begin(), cells.end(),
        [](const UnbalancedCell &a, const UnbalancedCell &b) {
          return a.imbalance * b.own_force < b.imbalance * a.own_force;
        });
    where =
        text(" Measured by their own loads, ", counted(cells.size(), "cell"),
             cells.size() == 1 ? " is" : " are",
             " not balanced: ", scene.packing.describe(worst.cell), " at ",
             text_of_point(scene.packing.centre(worst.cell)), " lacks ",
             worst.imbalance / worst.own_force,
             " of the load on it or beside it, and may slide.");
  }
  return text("The load is carried to within ", results.status.within,
              " of the largest load on a cell: neither forces that balance it "
              "exactly nor a mechanism of collapse were found. It may be that "
              "far above or below what the packing can carry, or "
              "'Solver/Tolerance' is loose.",
              where);
}

bool is_loaded(const Scene &scene)
{
  return scene.has_body_force || !scene.on_cells.empty() ||
         std::any_of(scene.traction.begin(), scene.traction.end(),
                     [](const auto &g) { return g.norm() > 0.; });
}
} // namespace

std::vector<std::string> cells_not_convex(const Packing &packing)
{
  if (packing.not_convex().empty())
    return {};
  const unsigned int c = packing.not_convex().front();
  return {text("Not convex: ", counted(packing.not_convex().size(), "cell"),
               ", the first of which is ", packing.describe(c), " at ",
               text_of_point(packing.centre(c)),
               ". Each can be seen whole from its centre, so the forces on its "
               "sides are those of the model; whether it would interlock with "
               "its neighbours is not looked at.")};
}

std::string forces_rejected(const Results &results,
                            const std::optional<double> force_of_centre)
{
  const std::string advice =
      force_of_centre
          ? text("The load is carried all the same: the analytic centre "
                 "balances it, with forces up to ",
                 *force_of_centre,
                 " times the largest load on a cell. If that is large, the "
                 "blocks wedge, and this formulation has not the digits for "
                 "it: set 'Formulation = analytic centre'. Otherwise take a "
                 "larger 'Solver/Maximum iterations'.")
          : "The load may be close to what the packing can carry, or beyond "
            "without a proof: try 'Formulation = least energy', a larger "
            "'Solver/Maximum iterations', or a smaller load.";
  return text("The solver ", results.outcome, " after ",
              counted(results.n_iterations, "iteration"),
              ", without forces that balance the load: the certificate finds ",
              faults(results.certificate), ". ", advice);
}

std::string earlier_forces_rejected(const Results &results)
{
  return text("The forces ", results.outcome,
              " do not carry the load of this run: the certificate finds ",
              faults(results.certificate),
              ". The loads must be those of the run that the forces are from, "
              "and 'Solver/Tolerance' must not be less; or leave 'Forces from' "
              "empty to solve.");
}

std::vector<std::string> doubts_about(const Results &results)
{
  if (!is_loaded(results.scene))
    return {"No load acts on the packing, so that all forces are zero. The "
            "section 'Loads' gives loads."};
  std::vector<std::string> doubts;
  if (results.status.kind == Status::Kind::carried_within)
    doubts.push_back(inexact(results));
  const std::string &outcome = results.earlier_outcome.empty()
                                   ? results.outcome
                                   : results.earlier_outcome;
  if (outcome != "converged" && outcome != nothing_to_balance)
    doubts.push_back(
        "The solver " + outcome +
        ". The forces are balanced and admissible to what is said below, but "
        "may differ from those of the named selection.");
  return doubts;
}

std::string message_of(const Collapse &collapse, const std::string &files)
{
  std::ostringstream message;
  message.precision(10); // close to the limit the ratio is hardly above one
  message << "The load is not carried: along a mechanism of the blocks that "
             "closes no joint it does ";
  if (std::isfinite(collapse.proof.work_over_dissipation))
    message << collapse.proof.work_over_dissipation
            << " times the work that friction can dissipate";
  else
    message << "work that friction does not resist";
  message << ", so that no forces within the strengths of the interfaces "
             "balance it";
  if (std::isfinite(collapse.proof.work_over_dissipation))
    message
        << "; these would have to be at least that many times as large, and "
           "perhaps more";
  message << '.';
  if (!collapse.parts.empty())
    message << " Most is done by " << collapse.parts.front().name << ", "
            << std::lround(100. * share_of_first(collapse.parts))
            << "% of the work that is put in. "
            << (files.empty() ? "Change" : "See " + files + "; change")
            << " 'Loads' or raise 'Friction/Strength'.";
  return message.str();
}
} // namespace Voussoir
