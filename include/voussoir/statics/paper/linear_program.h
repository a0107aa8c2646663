// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_paper_linear_program_h
#define voussoir_statics_paper_linear_program_h

#include <voussoir/statics/problem/formulation.h>

namespace Voussoir
{
/**
 * The linear program of Marazzato and Venkataramani (paper, eq. 16).
 *
 * It is
 *
 *     minimise sum_e s_e |e| v_e - sum_c F_c . u_c
 *     subject to [u]_e . n_e >= 0 and v_e >= |[u]_e . t_e|,
 *
 * solved by Ipopt, without any smoothing. Its multipliers are admissible and
 * balanced forces. There are many, and which of them come out depends on where
 * the solver stops on its way to the analytic centre with equal weights: on the
 * tolerance, the start, the version of Ipopt.
 */
class LinearProgram : public Formulation
{
public:
  std::string name() const override { return "linear program"; }
  std::string meaning() const override
  {
    return "the paper's linear program, solved by Ipopt; its forces depend on "
           "where the solver stops.";
  }
  std::string selection() const override
  {
    return "linear program: none; the forces depend on where Ipopt stops";
  }

private:
  Solution select(const DiscreteProblem &problem,
                  const SolverControls &controls,
                  Terminal &terminal) const override;
};
} // namespace Voussoir

#endif
