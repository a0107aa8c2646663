// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_problem_stop_h
#define voussoir_statics_problem_stop_h

#include <string>

namespace Voussoir
{
/** The reason for which a solver stopped; its words are here alone. */
struct Stop
{
  /** The reasons. */
  enum class Reason
  {
    /** It has not. */
    not_stopped,
    /** The tolerance is met. */
    converged,
    /** There is no interface or no load. */
    nothing_to_balance,
    /** A mechanism proves that the load is not carried. */
    collapse,
    /** The user's number of iterations is reached. */
    most_iterations,
    /** Rounding prevents a better balance. */
    rounding,
    /** Of the analytic centre: none was found. */
    no_centre,
    /** @{ */
    /** Outcomes of Ipopt. */
    looser_tolerance,
    diverged,
    infeasible,
    no_step,
    other
    /** @} */
  };

  /** The reason itself. */
  Reason reason = Reason::not_stopped;
  /** Ipopt's number of it, of `other` only. */
  int status = 0;

  /** Implicitly from a reason, so that it can stand for a Stop. */
  Stop(const Reason reason = Reason::not_stopped, const int status = 0)
      : reason(reason), status(status)
  {}

  /** True for one of these reasons, whatever the status. */
  bool operator==(const Reason other) const { return reason == other; }
  /** The opposite. */
  bool operator!=(const Reason other) const { return reason != other; }

  /** In a few words, to follow "The solver". */
  std::string words() const;
};

/** True if @p words are those of a solver that has left nothing to doubt. */
bool has_settled(const std::string &words);
} // namespace Voussoir

#endif
