// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/statics/problem/stop.h>

namespace Voussoir
{
std::string Stop::words() const
{
  switch (reason)
  {
  case Reason::not_stopped: return "";
  case Reason::converged: return "converged";
  case Reason::nothing_to_balance: return "nothing to balance";
  case Reason::collapse: return "stopped by a proof of collapse";
  case Reason::most_iterations: return "reached 'Solver/Maximum iterations'";
  case Reason::rounding: return "stopped at the limit of rounding";
  case Reason::no_centre: return "found no centre";
  case Reason::looser_tolerance: return "stopped at a looser tolerance";
  case Reason::diverged: return "diverged";
  case Reason::infeasible: return "failed to restore feasibility";
  case Reason::no_step: return "failed to compute a step";
  case Reason::other: break;
  }
  return text("ended with the status ", status);
}

bool has_settled(const std::string &words)
{
  return words == Stop(Stop::Reason::converged).words() ||
         words == Stop(Stop::Reason::nothing_to_balance).words();
}
} // namespace Voussoir
