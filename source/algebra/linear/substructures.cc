// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/linear/substructures.h>

#include <deal.II/lac/vector.h>

#include <algorithm>

namespace Voussoir
{
namespace
{
/** The number of ghosts that belong to earlier processes; they come first. */
unsigned int n_earlier_ghosts(const Structure &structure)
{
  const auto &ghosts = structure.ghosts();
  return std::lower_bound(ghosts.begin(), ghosts.end(),
                          structure.first_body()) -
         ghosts.begin();
}

/** The own bodies that couple, ascending. */
std::vector<unsigned int> coupling_bodies(const Structure &structure)
{
  const unsigned int n_own = structure.n_own_bodies();
  const unsigned int first_later = n_own + n_earlier_ghosts(structure);
  std::vector<bool> couples(n_own, false);
  for (const Structure::Joint &joint : structure.joints())
    if (joint.cell_minus >= first_later)
      couples[joint.cell_plus] = true;
    else if (joint.cell_plus >= first_later)
      couples[joint.cell_minus] = true;
  std::vector<unsigned int> bodies;
  for (unsigned int b = 0; b < n_own; ++b)
    if (couples[b])
      bodies.push_back(b);
  return bodies;
}

/** The coupling bodies, and the ghosts of earlier processes. */
std::vector<unsigned int> coupled_bodies(const Structure &structure)
{
  std::vector<unsigned int> bodies = coupling_bodies(structure);
  for (unsigned int k = 0; k < n_earlier_ghosts(structure); ++k)
    bodies.push_back(structure.n_own_bodies() + k);
  return bodies;
}
} // namespace

unsigned int Substructures::n_coupling_bodies(const Structure &structure)
{
  return coupling_bodies(structure).size();
}

Substructures::Substructures(const JointBlocks &blocks)
    : blocks(blocks), structure(blocks.of()),
      n_bodies(structure.n_own_bodies() + n_earlier_ghosts(structure)),
      factor(blocks, n_bodies, coupled_bodies(structure))
{}

bool Substructures::is_direct() const
{
  return true;
}

bool Substructures::prepare(const std::vector<double> &coefficients,
                            const double shift)
{
  const ProcessGroup &processes = structure.processes();
  if (!processes.all(factor.factorise(coefficients, shift)))
    return false;
  if (!is_numbered) // where there is nothing to number, too: it is collective
    number_couplings();
  is_numbered = true;
  const auto parts = processes.gather(schur_complement());
  return processes.broadcast(!processes.is_root() ||
                             factorise_couplings(parts));
}

void Substructures::number_couplings()
{
  coupled = factor.last_unknowns();
  const unsigned int n = blocks.n();
  std::vector<unsigned int> numbers;
  for (const unsigned int unknown : coupled)
    numbers.push_back(n * structure.number_of(unknown / n) + unknown % n);
  rows = structure.processes().gather(numbers);
  std::vector<unsigned int> all;
  for (const auto &of_process : rows)
    all.insert(all.end(), of_process.begin(), of_process.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  for (auto &of_process : rows)
    for (unsigned int &row : of_process)
      row = std::lower_bound(all.begin(), all.end(), row) - all.begin();
  n_rows = all.size();
}

/**
 * The Schur complement of this part for its coupled unknowns, row by row: the
 * product of the last block of L with its transpose, less what SparseFactor has
 * added.
 */
std::vector<double> Substructures::schur_complement() const
{
  const unsigned int n = coupled.size();
  if (n == 0)
    return {};
  const dealii::FullMatrix<double> &block = factor.last_block();
  dealii::LAPACKFullMatrix<double> lower(n, n), product(n, n);
  lower = block;
  lower.mTmult(product, lower);
  std::vector<double> values(std::size_t(n) * n);
  const std::vector<double> added = factor.added();
  for (unsigned int i = 0; i < n; ++i)
  {
    for (unsigned int j = 0; j < n; ++j)
      values[std::size_t(i) * n + j] = product(i, j);
    values[std::size_t(i) * n + i] -= added[i];
  }
  return values;
}

bool Substructures::factorise_couplings(
    const std::vector<std::vector<double>> &parts)
{
  if (n_rows == 0)
    return true;
  couplings.reinit(n_rows);
  couplings.set_property(dealii::LAPACKSupport::symmetric);
  for (unsigned int r = 0; r < parts.size(); ++r)
  {
    const std::vector<unsigned int> &row = rows[r];
    for (unsigned int i = 0; i < row.size(); ++i)
      for (unsigned int j = 0; j < row.size(); ++j)
        couplings(row[i], row[j]) += parts[r][i * row.size() + j];
  }
  try
  {
    couplings.compute_cholesky_factorization();
  }
  catch (const dealii::LACExceptions::ExcSingular &)
  {
    return false;
  }
  return true;
}

std::vector<double> Substructures::solve(const std::vector<double> &r,
                                         const unsigned int n_columns)
{
  // Own bodies come first in each column.
  const std::size_t n_own = r.size() / n_columns;
  std::vector<double> columns(factor.n() * n_columns, 0.);
  for (unsigned int c = 0; c < n_columns; ++c)
    std::copy_n(r.begin() + c * n_own, n_own, columns.begin() + c * factor.n());

  // The forces of the others on the coupled bodies, once they are eliminated.
  const unsigned int n = coupled.size(), first = factor.n() - n;
  std::vector<double> right(n * n_columns);
  for (unsigned int c = 0; c < n_columns; ++c)
    for (unsigned int k = 0; k < n; ++k)
      std::swap(right[c * n + k], columns[c * factor.n() + coupled[k]]);
  std::vector<double> y;
  if (n > 0)
    y = factor.forward(columns, n_columns);
  const dealii::FullMatrix<double> &block = factor.last_block();
  for (unsigned int c = 0; c < n_columns; ++c)
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        right[c * n + i] += block(i, j) * y[c * factor.n() + first + j];

  const std::vector<double> u = solve_couplings(right, n_columns);
  for (unsigned int c = 0; c < n_columns; ++c)
    for (unsigned int j = 0; j < n; ++j)
    {
      double sum = 0.;
      for (unsigned int i = j; i < n; ++i)
        sum += block(i, j) * u[c * n + i];
      y[c * factor.n() + first + j] = sum;
    }
  const std::vector<double> all =
      n > 0 ? factor.backward(y, n_columns) : factor.solve(columns, n_columns);
  std::vector<double> result(r.size());
  for (unsigned int c = 0; c < n_columns; ++c)
    std::copy_n(all.begin() + c * factor.n(), n_own,
                result.begin() + c * n_own);
  return result;
}

/** The displacement of the coupled bodies under the sum of all @p right. */
std::vector<double>
Substructures::solve_couplings(const std::vector<double> &right,
                               const unsigned int n_columns) const
{
  const ProcessGroup &processes = structure.processes();
  std::vector<std::vector<double>> parts = processes.gather(right);
  if (processes.is_root())
    for (unsigned int c = 0; c < n_columns; ++c)
    {
      dealii::Vector<double> u(n_rows);
      for (unsigned int r = 0; r < parts.size(); ++r)
        for (unsigned int k = 0; k < rows[r].size(); ++k)
          u[rows[r][k]] += parts[r][c * rows[r].size() + k];
      if (n_rows > 0)
        couplings.solve(u);
      for (unsigned int r = 0; r < parts.size(); ++r)
        for (unsigned int k = 0; k < rows[r].size(); ++k)
          parts[r][c * rows[r].size() + k] = u[rows[r][k]];
    }
  return processes.scatter(parts);
}
} // namespace Voussoir
