// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_state_answer_h
#define voussoir_analyses_state_answer_h

#include <voussoir/analyses/state/status.h>
#include <voussoir/scene/loads/load_parts.h>
#include <voussoir/scene/proofs/certificate.h>
#include <voussoir/scene/proofs/overturning.h>
#include <voussoir/statics/problem/formulation.h>
#include <voussoir/terminal/terminal.h>

#include <deal.II/base/timer.h>

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace Voussoir
{
/** The way in which an answer was found. */
struct SolverRecord
{
  /** Formulation::name(). */
  std::string formulation;
  /** Formulation::selection(). */
  std::string selection;
  /** The reason for which the solver stopped; see Stop::words(). */
  std::string outcome;
  /** Why the solver that found the forces stopped, if they were read. */
  std::string earlier_outcome;
  /** Solution::n_iterations. */
  unsigned int n_iterations = 0;
  /** Solution::n_evaluations. */
  unsigned int n_evaluations = 0;
  /** Solution::passes. */
  Passes passes = {};
  /** Solution::seconds. */
  std::map<std::string, double> solver_seconds;
};

/** Forces that carry a load, in the user's units. */
struct Carried
{
  /** f_e^n <= 0 and f_e^t of each interface; S L. */
  InterfaceForces forces;
  /** Solution::correction. */
  std::optional<double> correction;
  /** @{ */
  /** Of each interface, or empty if the formulation does not tell. */
  std::vector<bool> never_pressed, always_sliding;
  /** @} */
  /** Solution::motion; L. */
  Motion motion;
  /** The errors of the forces. */
  Certificate certificate;
  /** The status of the load that follows from them. */
  Status status;
  /** find_overturning(), of blocks that do not turn. */
  std::optional<Overturning> overturning;
};

/** The proof that a load is not carried, in the user's units. */
struct NotCarried
{
  /** Mechanism::motion. */
  Motion motion;
  /** The errors of the mechanism as a proof. */
  MechanismCertificate proof;
  /** The loads that drive the mechanism, the most work first. */
  std::vector<LoadPart> parts;
  /** The loads that are not carried. */
  enum class Loads
  {
    all,            /**< of the scene */
    dead,           /**< those that stay where a factor is looked for */
    dead_beside_any /**< the same with any factor: live loads do no work */
  };
  /** These. */
  Loads loads = Loads::all;
};

/** One of the two answers. */
using Answer = std::variant<Carried, NotCarried>;

/**
 * Solve a scene, and judge what was found.
 *
 * @param scene in the user's units.
 * @param formulation selects the forces.
 * @param controls of the solver.
 * @param record is filled.
 * @param timer counts "statics" and "certificate".
 * @param terminal sees the stages.
 * @throws InputError as Formulation::solve() does.
 * @throws SolverError if there is neither an answer that the certificate
 *   accepts nor a proof.
 */
Answer analyse(const Scene &scene,
               const Formulation &formulation,
               const SolverControls &controls,
               SolverRecord &record,
               dealii::TimerOutput &timer,
               Terminal &terminal);

/**
 * Judge a motion that is to prove that the load is not carried.
 *
 * @throws SolverError if it proves nothing.
 */
NotCarried prove(const Scene &scene, Motion motion);

/**
 * Judge forces, whoever found them: fill in the certificate and the status, or
 * prove the opposite.
 *
 * @param found without certificate and status.
 * @param record of how they were found.
 * @param tolerance of the solver; the certificate allows ten times as much if
 *   that is more than it would.
 * @throws InputError if the certificate does not accept forces that were read.
 * @throws SolverError if it does not accept those of a solver, or the mechanism
 *   that takes their place.
 */
Answer judge(const Scene &scene,
             Carried found,
             const SolverRecord &record,
             double tolerance,
             dealii::TimerOutput &timer,
             Terminal &terminal);
} // namespace Voussoir

#endif
