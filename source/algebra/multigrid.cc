// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/multigrid.h>

#include <deal.II/base/index_set.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/solver_cg.h>

#include <algorithm>
#include <array>

namespace Voussoir
{
using dealii::types::global_dof_index;
using Joint = Structure::Joint;
using Jump = Structure::Jump;

namespace
{
/** The residual of the conjugate gradients, relative to the right-hand side. */
constexpr double tolerance = 1e-12;
constexpr unsigned int n_max_iterations = 2000;
/**
 * ML's threshold below which a coupling counts as weak. For one component every
 * coupling counts (measured at 200,000 cells: 39 iterations, 52 with that for
 * two), for two some joints hold in one direction only.
 */
constexpr double aggregation_thresholds[] = {0., 1e-4};
constexpr unsigned int n_smoother_sweeps = 2;
} // namespace

Multigrid::Multigrid(const Structure &structure,
                     const unsigned int n_components)
    : structure(structure), n_components(n_components)
{
  const Team &team = structure.team();
  const unsigned int n_own = structure.n_own_bodies();
  const global_dof_index n_rows = n_components * team.sum(n_own);
  dealii::IndexSet own(n_rows);
  own.add_range(row(0, 0), row(0, 0) + n_components * n_own);

  dealii::DynamicSparsityPattern pattern(n_rows, n_rows, own);
  const auto couple = [&](const unsigned int c, const unsigned int d) {
    if (c < n_own)
      for (unsigned int i = 0; i < n_components; ++i)
        for (unsigned int j = 0; j < n_components; ++j)
          pattern.add(row(c, i), row(d, j));
  };
  for (unsigned int b = 0; b < n_own; ++b)
    couple(b, b);
  for (const Joint &joint : structure.joints())
  {
    couple(joint.cell_minus, joint.cell_plus);
    couple(joint.cell_plus, joint.cell_minus);
  }
  matrix.reinit(own, own, pattern, team.communicator());
  right.reinit(own, team.communicator());
  solution.reinit(own, team.communicator());
}

global_dof_index Multigrid::row(const unsigned int body,
                                const unsigned int i) const
{
  const unsigned int n_own = structure.n_own_bodies();
  return n_components * (body < n_own ? structure.first_body() + body
                                      : structure.ghosts()[body - n_own]) +
         i;
}

bool Multigrid::is_direct() const
{
  return false;
}

bool Multigrid::prepare(const std::vector<Jump> &coefficients,
                        const double shift)
{
  assemble(coefficients, shift);
  dealii::TrilinosWrappers::PreconditionAMG::AdditionalData data;
  data.elliptic = true;
  data.aggregation_threshold = aggregation_thresholds[n_components - 1];
  data.smoother_sweeps = n_smoother_sweeps;
  // The rigid motions of the packing: its translations.
  const unsigned int n_rows = n_components * structure.n_own_bodies();
  data.constant_modes.assign(n_components, std::vector<bool>(n_rows));
  for (unsigned int k = 0; k < n_rows; ++k)
    data.constant_modes[k % n_components][k] = true;
  preconditioner.initialize(matrix, data);
  return true;
}

std::vector<double> Multigrid::solve(const std::vector<double> &r)
{
  const std::vector<double> own(r.begin(), r.begin() + structure.n_own_dofs());
  std::vector<double> columns = to_columns(own, n_components);
  const std::size_t n_rows = n_components * structure.n_own_bodies();
  for (auto column = columns.begin(); column != columns.end(); column += n_rows)
  {
    std::copy_n(column, n_rows, right.begin());
    solution = 0.;
    dealii::SolverControl control(n_max_iterations,
                                  tolerance * right.l2_norm());
    dealii::SolverCG<dealii::TrilinosWrappers::MPI::Vector> gradients(control);
    try
    {
      gradients.solve(matrix, solution, right, preconditioner);
    }
    catch (const dealii::SolverControl::NoConvergence &)
    {
      // The iterate reached so far is a direction of descent all the same.
    }
    std::copy(solution.begin(), solution.end(), column);
  }
  std::vector<double> u = from_columns(columns, n_components);
  u.resize(structure.n_dofs());
  return u;
}

void Multigrid::assemble(const std::vector<Jump> &coefficients,
                         const double shift)
{
  const unsigned int n = n_components, n_own = structure.n_own_bodies();
  matrix = 0.;
  for (unsigned int b = 0; b < n_own; ++b)
    for (unsigned int i = 0; i < n; ++i)
      matrix.add(row(b, i), row(b, i), shift);
  for (unsigned int e = 0; e < coefficients.size(); ++e)
  {
    const Joint &joint = structure.joints()[e];
    for (const unsigned int c : {joint.cell_minus, joint.cell_plus})
      for (unsigned int i = 0; i < n && c < n_own; ++i)
      {
        std::array<global_dof_index, 4> columns;
        std::array<double, 4> values;
        unsigned int k = 0;
        for (const unsigned int d : {joint.cell_minus, joint.cell_plus})
          for (unsigned int j = 0; j < n; ++j, ++k)
          {
            columns[k] = row(d, j);
            values[k] = (c == d ? 1. : -1.) *
                        (n == 1 ? coefficients[e].normal
                                : block_of_joint(joint, coefficients[e], i, j));
          }
        matrix.add(row(c, i), k, columns.data(), values.data(), false);
      }
  }
  matrix.compress(dealii::VectorOperation::add);
}
} // namespace Voussoir
