// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/state/answer.h>
#include <voussoir/analyses/state/assess.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/conic/feasible_state.h>
#include <voussoir/statics/problem/discretise.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace Voussoir
{
namespace
{
/**
 * The factor on 'Solver/Tolerance' for the certificate, whose norm and
 * reference force are others than the solver's.
 */
constexpr double tolerance_allowance = 10.;

/** A ratio of work to dissipation above which the dissipation is rounding. */
constexpr double frictionless_ratio = 1e6;

std::string faults(const Certificate &certificate)
{
  return text(
      "a residual of ",
      std::max(certificate.equilibrium_residual, certificate.moment_residual),
      " and a violation of ", certificate.admissibility_violation,
      " of the largest load on a cell");
}

std::string forces_rejected(const SolverRecord &record,
                            const Certificate &certificate,
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
  return text("The solver ", record.outcome, " after ",
              counted(record.n_iterations, "iteration"),
              ", without forces that balance the load: the certificate finds ",
              faults(certificate), ". ", advice);
}

std::string earlier_forces_rejected(const SolverRecord &record,
                                    const Certificate &certificate)
{
  return text("The forces ", record.outcome,
              " do not carry the load of this run: the certificate finds ",
              faults(certificate),
              ". The loads must be those of the run that the forces are from, "
              "and 'Solver/Tolerance' must not be less; or leave 'Forces from' "
              "empty to solve.");
}

void check_loads(const double residual)
{
  if (residual > largest_load_residual)
    throw SolverError(
        text("The loads on edges and cells differ from those that were asked "
             "for by ",
             residual,
             " of the sum of their sizes, or by a moment of that. This is a "
             "fault of the program: please report it, with the .prm file."));
}

void check_certificate(const Scene &scene,
                       const SolverRecord &record,
                       const Certificate &certificate,
                       const double tolerance,
                       Terminal &terminal)
{
  check_loads(certificate.load_residual);
  const double limit =
      std::max(largest_accepted_error, tolerance_allowance * tolerance);
  if (certificate.error() <= limit)
    return;
  if (!record.earlier_outcome.empty())
    throw InputError(earlier_forces_rejected(record, certificate));
  throw SolverError(
      forces_rejected(record, certificate, carried_by_centre(scene, terminal)));
}

/** Take another mechanism if that is a proof, as it may be near the limit. */
void look_for_another(const Scene &scene, NotCarried &found)
{
  const DiscreteProblem problem = discretise(scene);
  const auto mechanism = find_collapse(problem, Terminal::silent());
  if (!mechanism)
    return;
  Motion motion = dimensional_motion(problem, *mechanism);
  const MechanismCertificate proof = certify_mechanism(scene, motion);
  if (!proves_collapse(proof))
    return;
  found.motion = std::move(motion);
  found.proof = proof;
}
} // namespace

NotCarried prove(const Scene &scene, Motion motion)
{
  NotCarried found;
  found.motion = std::move(motion);
  found.proof = certify_mechanism(scene, found.motion);
  check_loads(found.proof.load_residual);
  if (!proves_collapse(found.proof))
    look_for_another(scene, found);
  if (!proves_collapse(found.proof))
    throw SolverError(text("The solver proposes a collapse mechanism, but it "
                           "closes joints by ",
                           found.proof.closing_violation,
                           " of its size, with which forces of the size of the "
                           "load could do ",
                           found.proof.share_of_closing,
                           " of the difference between work and dissipation, "
                           "and the ratio of these is ",
                           found.proof.work_over_dissipation,
                           ", which proves nothing. Try 'Formulation = least "
                           "energy', or a load farther from what the packing "
                           "can carry."));

  if (found.proof.work_over_dissipation > frictionless_ratio)
    found.proof.work_over_dissipation = std::numeric_limits<double>::infinity();
  found.parts = load_parts(scene, found.motion);
  return found;
}

Answer judge(const Scene &scene,
             Carried found,
             const SolverRecord &record,
             const double tolerance,
             dealii::TimerOutput &timer,
             Terminal &terminal)
{
  const dealii::TimerOutput::Scope section(timer, "certificate");
  found.certificate = certify(scene, found.forces);
  check_certificate(scene, record, found.certificate, tolerance, terminal);
  Assessment assessment =
      assess(scene, found.forces, found.certificate, terminal);
  if (!assessment.mechanism.displacement.empty())
    return prove(scene, std::move(assessment.mechanism));
  found.status = assessment.status;
  if (!scene.turns() && found.certificate.max_torque > largest_accepted_error)
    found.overturning = find_overturning(scene, found.forces);
  return found;
}

Answer analyse(const Scene &scene,
               const Formulation &formulation,
               const SolverControls &controls,
               SolverRecord &record,
               dealii::TimerOutput &timer,
               Terminal &terminal)
{
  timer.enter_subsection("statics");
  terminal.begin("Statics");
  const DiscreteProblem problem = discretise(scene);
  Solution solution = formulation.solve(problem, controls, terminal);
  record.formulation = formulation.name();
  record.selection =
      solution.selection.empty() ? formulation.selection() : solution.selection;
  record.outcome = solution.stop.words();
  record.n_iterations = solution.n_iterations;
  record.n_evaluations = solution.n_evaluations;
  record.passes = solution.passes;
  record.solver_seconds = solution.seconds;
  terminal.stage("Statics",
                 text(record.formulation, ": ", record.outcome, " after ",
                      counted(record.n_iterations, "iteration"), ", ",
                      counted(record.n_evaluations, "evaluation")));
  timer.leave_subsection();

  if (solution.mechanism)
    return prove(scene, dimensional_motion(problem, *solution.mechanism));
  Carried found;
  found.forces = dimensional_forces(problem, solution);
  found.correction = solution.correction;
  found.never_pressed = std::move(solution.never_pressed);
  found.always_sliding = std::move(solution.always_sliding);
  found.motion = dimensional_motion(problem, solution);
  return judge(scene, std::move(found), record, controls.tolerance, timer,
               terminal);
}
} // namespace Voussoir
