// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/statics/displacement_program.h>
#include <voussoir/statics/find_opening.h>
#include <voussoir/statics/linear_program.h>
#include <voussoir/statics/sufficient_strengths.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
using Joint = DiscreteProblem::Joint;

/**
 * The unknowns are u, then v_e of the joints that have a strength. The rows of
 * the constraints are [u]_e . n_e of all joints, then v_e - [u]_e . t_e and
 * v_e + [u]_e . t_e of each with a strength.
 */
class Program : public DisplacementProgram
{
public:
  explicit Program(const DiscreteProblem &problem) : problem(problem)
  {
    for (unsigned int e = 0; e < problem.joints().size(); ++e)
      if (problem.joints()[e].strength > 0.)
        rough.push_back(e);
  }

  /** The problem's opening, and v_e = d_e above its least. */
  std::vector<double> start() const override
  {
    std::vector<double> x = opening_of(problem).displacement;
    x.resize(n_unknowns());
    for (unsigned int k = 0; k < rough.size(); ++k)
    {
      const Joint &joint = problem.joints()[rough[k]];
      x[problem.n_dofs() + k] =
          joint.distance + std::abs(problem.jump(joint, x.data()).tangential);
    }
    return x;
  }

  double value(const double *x) override
  {
    long double sum = -problem.work(x);
    for (unsigned int k = 0; k < rough.size(); ++k)
      sum += problem.joints()[rough[k]].strength * x[problem.n_dofs() + k];
    return sum;
  }

  std::vector<double> gradient(const double * /*x*/) override
  {
    std::vector<double> g(n_unknowns());
    for (unsigned int b = 0; b < problem.n_bodies(); ++b)
      for (unsigned int i = 0; i < 2; ++i)
        g[problem.dof(b, i)] = -problem.loads()[b][i];
    for (unsigned int k = 0; k < rough.size(); ++k)
      g[problem.n_dofs() + k] = problem.joints()[rough[k]].strength;
    return g;
  }

  std::vector<Entry> hessian(const double * /*x*/) const override
  {
    return {};
  }

  unsigned int n_constraints() const override
  {
    return problem.joints().size() + 2 * rough.size();
  }

  std::vector<Entry> constraints() const override
  {
    std::vector<Entry> entries;
    const auto add_jump = [&](const unsigned int row, const Joint &joint,
                              const dealii::Tensor<1, 2> &direction) {
      for (unsigned int i = 0; i < 2; ++i)
      {
        entries.push_back(
            {row, problem.dof(joint.cell_minus, i), -direction[i]});
        entries.push_back({row, problem.dof(joint.cell_plus, i), direction[i]});
      }
    };
    for (unsigned int e = 0; e < problem.joints().size(); ++e)
      add_jump(e, problem.joints()[e], problem.joints()[e].normal);
    for (unsigned int k = 0; k < rough.size(); ++k)
    {
      const Joint &joint = problem.joints()[rough[k]];
      add_jump(forward_row(k), joint, -joint.tangent);
      add_jump(forward_row(k) + 1, joint, joint.tangent);
      for (const unsigned int row : {forward_row(k), forward_row(k) + 1})
        entries.push_back({row, problem.n_dofs() + k, 1.});
    }
    return entries;
  }

  /** f_e^n and f_e^t from the multipliers, which are not positive. */
  InterfaceForces forces(const std::vector<double> &multipliers) const
  {
    InterfaceForces forces;
    const unsigned int n_joints = problem.joints().size();
    forces.normal.assign(multipliers.begin(), multipliers.begin() + n_joints);
    forces.tangential.resize(n_joints);
    for (unsigned int k = 0; k < rough.size(); ++k)
    {
      // The two multipliers add up to minus the strength, but for rounding.
      const double strength = problem.joints()[rough[k]].strength;
      forces.tangential[rough[k]] = std::clamp(multipliers[forward_row(k) + 1] -
                                                   multipliers[forward_row(k)],
                                               -strength, strength);
    }
    return forces;
  }

private:
  unsigned int n_unknowns() const
  {
    return problem.n_dofs() + rough.size();
  }

  /** The row of v_e >= [u]_e . t_e; that of v_e >= -[u]_e . t_e is next. */
  unsigned int forward_row(const unsigned int k) const
  {
    return problem.joints().size() + 2 * k;
  }

  const DiscreteProblem &problem;
  /** The joints with a strength. */
  std::vector<unsigned int> rough;
};

Solution solve_linear_program(const DiscreteProblem &problem,
                              const SolverControls &controls,
                              Terminal &terminal)
{
  Program program(problem);
  ProgramResult result =
      solve_program(problem, program,
                    {controls.tolerance, controls.n_max_iterations}, terminal);
  if (!result.solution.mechanism)
    result.solution.forces = program.forces(result.multipliers);
  return result.solution;
}
} // namespace

std::string LinearProgram::name() const
{
  return "linear program";
}

std::string LinearProgram::meaning() const
{
  return "the paper's linear program, solved by Ipopt; its forces depend on "
         "where the solver stops.";
}

std::string LinearProgram::selection() const
{
  return "linear program: none; the forces depend on where Ipopt stops";
}

void LinearProgram::add_parameters(dealii::ParameterHandler & /*prm*/)
{
}

Solution LinearProgram::select(const DiscreteProblem &problem,
                               const SolverControls &controls,
                               Terminal &terminal) const
{
  require_interior(problem, name());
  return solve_with_sufficient_strengths(
      problem, controls,
      [&](const DiscreteProblem &at_most, const SolverControls &rest) {
        return solve_linear_program(at_most, rest, terminal);
      });
}
} // namespace Voussoir
