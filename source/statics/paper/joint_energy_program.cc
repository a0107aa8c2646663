// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/paper/joint_energy_program.h>
#include <voussoir/statics/problem/solver_controls.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
void BestBalance::see(const double *x, const std::vector<double> &gradient)
{
  double imbalance = 0.;
  for (const double g : gradient)
    imbalance = std::max(imbalance, std::abs(g));
  if (imbalance < least)
  {
    least = imbalance;
    best.assign(x, x + gradient.size());
  }
}

Stop BestBalance::verdict(const unsigned int iteration, const double tolerance)
{
  if (least < before)
    iteration_of_best = iteration;
  before = least;
  if (least <= tolerance)
    return Stop::Reason::converged;
  if (least <= imbalance_near_rounding &&
      iteration > iteration_of_best + n_stalled_iterations)
    return Stop::Reason::rounding;
  return {};
}

JointEnergyProgram::JointEnergyProgram(const DiscreteProblem &problem,
                                       const EnergyLaw &law)
    : of_loads(problem), of_energy(law), blocks_of_joints(problem, false)
{
  unsigned int n_most = 0;
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    n_most = std::max(n_most, problem.n_rows(e));
  jumps.resize(n_most);
  forces.resize(n_most);
}

double JointEnergyProgram::value(const double *x)
{
  // Close to the minimum the line search compares energies that differ by
  // rounding alone; a longer sum keeps it from cutting good steps.
  long double sum = -of_loads.work(x);
  for (unsigned int e = 0; e < of_loads.joints().size(); ++e)
  {
    of_loads.find_jumps(e, x, jumps.data());
    sum += of_energy.energy(e, jumps.data());
  }
  return sum;
}

std::vector<double> JointEnergyProgram::gradient(const double *x)
{
  std::vector<double> g(of_loads.n_dofs());
  for (unsigned int k = 0; k < g.size(); ++k)
    g[k] = -of_loads.loads()[k];
  for (unsigned int e = 0; e < of_loads.joints().size(); ++e)
  {
    of_loads.find_jumps(e, x, jumps.data());
    of_energy.find_forces(e, jumps.data(), forces.data());
    of_loads.add_jump_gradient(e, forces.data(), g.data());
  }
  return g;
}

// First the lower triangle of each body's diagonal block, then the block of
// each joint with the rows of the higher body; c- < c+.
std::vector<ConvexProgram::Entry>
JointEnergyProgram::hessian(const double *x) const
{
  const unsigned int n = of_loads.n_unknowns(), n_entries = n * (n + 1) / 2;
  std::vector<Entry> entries;
  entries.reserve(n_entries * of_loads.n_bodies() +
                  n * n * of_loads.joints().size());
  for (unsigned int b = 0; b < of_loads.n_bodies(); ++b)
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        entries.push_back({of_loads.dof(b, i), of_loads.dof(b, j), 0.});
  std::vector<double> second(of_loads.n_all_coefficients());
  JointBlocks::Blocks blocks;
  for (unsigned int e = 0; e < of_loads.joints().size(); ++e)
  {
    of_loads.find_jumps(e, x, jumps.data());
    of_energy.find_second_derivatives(e, jumps.data(),
                                      &second[of_loads.first_coefficient(e)]);
    blocks_of_joints.find(e, second.data(), blocks);
    const DiscreteProblem::Joint &joint = of_loads.joints()[e];
    unsigned int k = 0;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
      {
        entries.push_back({of_loads.dof(joint.cell_plus, i),
                           of_loads.dof(joint.cell_minus, j),
                           blocks.mixed[i * n + j]});
        if (j > i)
          continue;
        entries[n_entries * joint.cell_minus + k].value +=
            blocks.minus[i * n + j];
        entries[n_entries * joint.cell_plus + k].value +=
            blocks.plus[i * n + j];
        ++k;
      }
  }
  return entries;
}

std::vector<double>
JointEnergyProgram::forces_at(const std::vector<double> &x) const
{
  std::vector<double> all(of_loads.n_all_rows());
  for (unsigned int e = 0; e < of_loads.joints().size(); ++e)
  {
    of_loads.find_jumps(e, x.data(), jumps.data());
    of_energy.find_forces(e, jumps.data(), &all[of_loads.first_row(e)]);
  }
  return all;
}
} // namespace Voussoir
