// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/linear/multigrid.h>

#include <deal.II/base/index_set.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/solver_cg.h>

#include <Epetra_MultiVector.h>
#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <array>
#include <memory>
#include <tuple>
#include <utility>

namespace Voussoir
{
using dealii::types::global_dof_index;
using Joint = Structure::Joint;

namespace
{
/** The residual of the conjugate gradients, relative to the right-hand side. */
constexpr double tolerance_of_cycles = 1e-12;
constexpr unsigned int n_max_cycles = 2000;
/**
 * ML's threshold below which a coupling counts as weak. For one component every
 * coupling counts (measured at 200,000 cells: 39 iterations, 52 with that for
 * two), for two some joints hold in one direction only.
 */
constexpr double threshold_of_one = 0., threshold_of_all = 1e-4;
constexpr unsigned int n_smoother_sweeps = 2;
} // namespace

Multigrid::Multigrid(const JointBlocks &blocks)
    : blocks(blocks), structure(blocks.of())
{
  const ProcessGroup &processes = structure.processes();
  const unsigned int n = blocks.n(), n_own = structure.n_own_bodies();
  const global_dof_index n_rows = n * processes.sum(n_own);
  dealii::IndexSet own(n_rows);
  own.add_range(row(0, 0), row(0, 0) + n * n_own);

  dealii::DynamicSparsityPattern pattern(n_rows, n_rows, own);
  const auto couple = [&](const unsigned int c, const unsigned int d) {
    if (c < n_own)
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          pattern.add(row(c, i), row(d, j));
  };
  for (unsigned int b = 0; b < n_own; ++b)
    couple(b, b);
  for (const Joint &joint : structure.joints())
  {
    couple(joint.cell_minus, joint.cell_plus);
    couple(joint.cell_plus, joint.cell_minus);
  }
  matrix.reinit(own, own, pattern, processes.communicator());
  right.reinit(own, processes.communicator());
  solution.reinit(own, processes.communicator());
}

global_dof_index Multigrid::row(const unsigned int body,
                                const unsigned int i) const
{
  return blocks.n() * structure.number_of(body) + i;
}

bool Multigrid::is_direct() const
{
  return false;
}

bool Multigrid::prepare(const std::vector<double> &coefficients,
                        const double shift)
{
  assemble(coefficients, shift);
  dealii::TrilinosWrappers::PreconditionAMG::AdditionalData data;
  data.elliptic = true;
  data.aggregation_threshold =
      blocks.n() == 1 ? threshold_of_one : threshold_of_all;
  data.smoother_sweeps = n_smoother_sweeps;
  const unsigned int n = blocks.n(), n_own = structure.n_own_bodies();
  data.constant_modes.assign(n, std::vector<bool>(n * n_own));
  for (unsigned int k = 0; k < n * n_own; ++k)
    data.constant_modes[k % n][k] = true;
  Teuchos::ParameterList parameters;
  std::unique_ptr<Epetra_MultiVector> modes;
  data.set_parameters(parameters, modes, matrix.trilinos_matrix());
  // The rigid motions of the packing, where one component is not by itself.
  std::array<double, Kinematics::most_unknowns> unknowns;
  for (unsigned int k = 0; n > 1 && k < structure.n_unknowns(); ++k)
    for (unsigned int b = 0; b < n_own; ++b)
    {
      structure.kinematics().find_rigid_motion(k, structure.centre(b),
                                               unknowns.data());
      std::copy_n(unknowns.begin(), n, (*modes)[k] + n * b);
    }
  preconditioner.initialize(matrix, parameters);
  return true;
}

std::vector<double> Multigrid::solve(const std::vector<double> &r,
                                     const unsigned int n_columns)
{
  std::vector<double> u(r.size());
  const std::size_t n_rows = r.size() / n_columns;
  for (std::size_t first = 0; first < r.size(); first += n_rows)
  {
    std::copy_n(r.begin() + first, n_rows, right.begin());
    solution = 0.;
    dealii::SolverControl control(n_max_cycles,
                                  tolerance_of_cycles * right.l2_norm());
    dealii::SolverCG<dealii::TrilinosWrappers::MPI::Vector> gradients(control);
    try
    {
      gradients.solve(matrix, solution, right, preconditioner);
    }
    catch (const dealii::SolverControl::NoConvergence &)
    {
      // The iterate reached so far is a direction of descent all the same.
    }
    std::copy(solution.begin(), solution.end(), u.begin() + first);
  }
  return u;
}

void Multigrid::assemble(const std::vector<double> &coefficients,
                         const double shift)
{
  const unsigned int n = blocks.n(), n_own = structure.n_own_bodies();
  matrix = 0.;
  for (unsigned int b = 0; b < n_own; ++b)
    for (unsigned int i = 0; i < n; ++i)
      matrix.add(row(b, i), row(b, i), shift);

  JointBlocks::Blocks of_joint;
  for (unsigned int e = 0; e < structure.joints().size(); ++e)
  {
    const Joint &joint = structure.joints()[e];
    blocks.find(e, coefficients.data(), of_joint);
    const auto add = [&](const unsigned int c, const auto &entry) {
      for (unsigned int i = 0; i < n && c < n_own; ++i)
      {
        std::array<global_dof_index, 2 * Kinematics::most_unknowns> columns;
        std::array<double, 2 * Kinematics::most_unknowns> values;
        for (unsigned int j = 0; j < n; ++j)
        {
          columns[j] = row(joint.cell_minus, j);
          columns[n + j] = row(joint.cell_plus, j);
          std::tie(values[j], values[n + j]) = entry(i, j);
        }
        matrix.add(row(c, i), 2 * n, columns.data(), values.data(), false);
      }
    };
    add(joint.cell_minus, [&](const unsigned int i, const unsigned int j) {
      return std::pair(of_joint.minus[i * n + j], of_joint.mixed[j * n + i]);
    });
    add(joint.cell_plus, [&](const unsigned int i, const unsigned int j) {
      return std::pair(of_joint.mixed[i * n + j], of_joint.plus[i * n + j]);
    });
  }
  matrix.compress(dealii::VectorOperation::add);
}

} // namespace Voussoir
