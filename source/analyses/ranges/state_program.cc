// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/ranges/state_program.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/base/library_failure.h>

#include <ClpSimplex.hpp>
#include <CoinPackedMatrix.hpp>
#include <algorithm>
#include <cmath>
#include <new>

namespace Voussoir
{
namespace
{
/** Of the balance and of the signs of the multipliers; forces are of order one.
 */
constexpr double tolerance = 1e-12;
/** The largest number of forces in all vertices that are kept to start from. */
constexpr std::size_t n_kept = 10000000;

/** The values of ClpSimplex::status(). */
constexpr int optimal = 0, dual_infeasible = 2, failed = 4;

constexpr const char *failure_of_clp =
    "Clp, which solves the linear programmes of all states, has failed. Set "
    "'Ranges/Where = 0' and 'Analysis = state' to have the state alone.";

/**
 * Run the dual or the primal simplex method from where @p clp is; what it
 * throws is that it has no answer.
 *
 * @return the number of its steps.
 */
unsigned int run(ClpSimplex &clp, int (ClpSimplex::*const method)(int, int))
{
  const LibraryFailure failure(failure_of_clp);
  try
  {
    (clp.*method)(0, 0);
    return clp.numberIterations();
  }
  catch (const std::bad_alloc &)
  {
    throw;
  }
  catch (...) // a CoinError, which is no std::exception, or another
  {
    clp.setProblemStatus(failed);
    return 0;
  }
}

/** The bounds of Clp, for which 1e30 is no bound. */
double bound(const double value)
{
  return std::clamp(value, -COIN_DBL_MAX, COIN_DBL_MAX);
}
} // namespace

/** The matrix A by its columns, one for each row of a joint, and the bounds. */
struct StateProgram::Columns
{
  /** Add the entry of a body's unknown, unless it is zero. */
  void add(const unsigned int row, const double value)
  {
    if (row == dealii::numbers::invalid_unsigned_int || value == 0.)
      return;
    rows.push_back(row);
    entries.push_back(value);
  }
  /** End the column of a force within @p limits. */
  void close(const ForceRows::Bounds &limits)
  {
    begins.push_back(entries.size());
    lower.push_back(bound(limits.least));
    upper.push_back(bound(limits.greatest));
  }

  std::vector<CoinBigIndex> begins = {0};
  std::vector<int> rows;
  std::vector<double> entries, lower, upper;
};

StateProgram::Columns StateProgram::columns() const
{
  const ForceRows &rows = problem.rows();
  const unsigned int T = rows.n_translations();
  Columns columns;
  // They are minus the derivatives of the jumps.
  for (unsigned int e = 0; e < rows.joints().size(); ++e)
    for (unsigned int r = 0; r < rows.n_rows(e); ++r)
    {
      const ForceRows::Joint &joint = rows.joints()[e];
      const ContactRow row = rows.row(e, r);
      const ForceRows::Bounds &limits = rows.bounds()[rows.first_row(e) + r];
      const auto add = [&](const unsigned int i, const double of_minus,
                           const double of_plus) {
        columns.add(row_of[rows.dof(joint.cell_minus, i)], of_minus);
        columns.add(row_of[rows.dof(joint.cell_plus, i)], of_plus);
      };
      if (limits.least != 0. || limits.greatest != 0.)
      {
        for (unsigned int i = 0; i < T; ++i)
          add(i, row.direction[i], -row.direction[i]);
        for (unsigned int i = T; i < rows.n_unknowns(); ++i)
          add(i, row.turn_minus[i - T], -row.turn_plus[i - T]);
      }
      columns.close(limits);
    }
  return columns;
}

StateProgram::StateProgram(const RowProblem &problem)
    : problem(problem), clp(std::make_unique<ClpSimplex>())
{
  const InvalidOperationsAllowed allowed;
  const ForceRows &rows = problem.rows();
  // A body between the two halves of a joint is none of the problem's.
  const auto is_held = [&](const unsigned int b) {
    return b < problem.of().n_bodies() && problem.of().is_held(b);
  };
  unsigned int n_rows = 0;
  for (unsigned int b = 0; b < rows.n_bodies(); ++b)
    for (unsigned int i = 0; i < rows.n_unknowns(); ++i)
      row_of.push_back(is_held(b) ? dealii::numbers::invalid_unsigned_int
                                  : n_rows++);

  load(columns(), n_rows);
}

void StateProgram::load(const Columns &columns, const unsigned int n_rows)
{
  std::vector<double> balance(n_rows);
  const std::vector<double> loads = problem.loads();
  for (unsigned int k = 0; k < row_of.size(); ++k)
    if (row_of[k] != dealii::numbers::invalid_unsigned_int)
      balance[row_of[k]] = -loads[k];
  // Bases are factorised by Clp's default. Measured, processor time of all
  // ranges in the scenes of prm/, with rotations and without:
  // CoinOslFactorization takes 0.98 of its time (0.85 to 1.67), and ends by an
  // assertion or an invalid address in buttress, retaining_wall and
  // wall_with_openings where blocks turn; CoinSimpFactorization takes 1.00 of
  // it (0.79 to 1.62) and CoinDenseFactorization 4.4 (0.72 to 30), and both end
  // so in million_cells.
  clp->setLogLevel(0);
  clp->setPrimalTolerance(tolerance);
  clp->setDualTolerance(tolerance);
  clp->scaling(0); // all entries are of order one
  const CoinPackedMatrix matrix(true, n_rows, columns.lower.size(),
                                columns.entries.size(), columns.entries.data(),
                                columns.rows.data(), columns.begins.data(),
                                nullptr);
  clp->loadProblem(matrix, columns.lower.data(), columns.upper.data(), nullptr,
                   balance.data(), balance.data());
}

StateProgram::StateProgram(const StateProgram &other)
    : problem(other.problem), row_of(other.row_of),
      clp(std::make_unique<ClpSimplex>(*other.clp))
{}

StateProgram::~StateProgram() = default;

bool StateProgram::find_state()
{
  const InvalidOperationsAllowed allowed;
  // Without an objective every basis is one of the dual simplex method.
  iterations += run(*clp, &ClpSimplex::dual);
  if (clp->status() != optimal)
    iterations += run(*clp, &ClpSimplex::primal);
  return clp->status() == optimal;
}

void StateProgram::forget()
{
  const InvalidOperationsAllowed allowed;
  kept.clear();
  clp->allSlackBasis(true);
  iterations += run(*clp, &ClpSimplex::dual);
}

void StateProgram::loosen_balance(const double by)
{
  const std::vector<double> loads = problem.loads();
  for (unsigned int k = 0; k < row_of.size(); ++k)
    if (row_of[k] != dealii::numbers::invalid_unsigned_int)
      clp->setRowBounds(row_of[k], -loads[k] - by, -loads[k] + by);
  kept.clear();
}

void StateProgram::renew(const StateProgram &first)
{
  clp = std::make_unique<ClpSimplex>(*first.clp);
  if (!kept.empty())
    start_from(kept.back());
}

Journal::Json StateProgram::where_it_is() const
{
  Journal::Json vertices = Journal::Json::array();
  for (const Vertex &vertex : kept)
    vertices.push_back(
        {packed(vertex.x), Journal::Json::binary(vertex.status)});
  return {{"vertices", vertices}, {"iterations", iterations}};
}

void StateProgram::go_on(const Journal::Json &from, const StateProgram &first)
{
  kept.clear();
  for (const Journal::Json &vertex : from.at("vertices"))
    kept.push_back({unpacked(vertex.at(0)), vertex.at(1).get_binary()});
  iterations = from.at("iterations");
  renew(first);
}

void StateProgram::start_from(const Vertex &vertex)
{
  clp->copyinStatus(vertex.status.data());
  std::copy(vertex.x.begin(), vertex.x.end(), clp->primalColumnSolution());
}

void StateProgram::keep()
{
  const double *x = clp->primalColumnSolution();
  const unsigned char *status = clp->statusArray();
  kept.push_back({{x, x + clp->numberColumns()},
                  {status, status + clp->numberColumns() + clp->numberRows()}});
  while (kept.size() > 1 && kept.size() * kept.back().x.size() > n_kept)
    kept.pop_front();
}

void StateProgram::start_from_best(const std::vector<double> &c)
{
  std::vector<std::size_t> of_objective;
  for (std::size_t k = 0; k < c.size(); ++k)
    if (c[k] != 0.)
      of_objective.push_back(k);
  const Vertex *best = nullptr;
  double greatest = -COIN_DBL_MAX;
  for (const Vertex &vertex : kept)
  {
    double value = 0.;
    for (const std::size_t k : of_objective)
      value += c[k] * vertex.x[k];
    // Among equals the latest.
    if (value >= greatest)
    {
      greatest = value;
      best = &vertex;
    }
  }
  if (best == nullptr || best == &kept.back())
    return;
  start_from(*best);
}

StateProgram::Optimum StateProgram::maximise(const std::vector<double> &c)
{
  const InvalidOperationsAllowed allowed;
  double *objective = clp->objective();
  for (std::size_t k = 0; k < c.size(); ++k)
    objective[k] = -c[k];
  start_from_best(c);
  iterations += run(*clp, &ClpSimplex::primal);
  if (clp->status() != optimal && clp->status() != dual_infeasible)
  {
    forget();
    iterations += run(*clp, &ClpSimplex::primal);
  }
  Optimum found;
  found.is_unbounded = clp->status() == dual_infeasible;
  found.is_found = found.is_unbounded || clp->status() == optimal;
  if (!found.is_found)
    return found;
  if (found.is_unbounded)
  {
    const std::unique_ptr<double[]> ray(clp->unboundedRay());
    found.is_found = ray != nullptr;
    if (found.is_found)
      found.x.assign(ray.get(), ray.get() + c.size());
    return found;
  }
  keep();
  const double *x = clp->primalColumnSolution();
  found.x.assign(x, x + c.size());
  const auto &limits = problem.rows().bounds();
  for (std::size_t k = 0; k < c.size(); ++k)
    found.x[k] = std::clamp(found.x[k], limits[k].least, limits[k].greatest);
  const double *multiplier = clp->dualRowSolution();
  for (const unsigned int row : row_of)
    found.u.push_back(
        row == dealii::numbers::invalid_unsigned_int ? 0. : -multiplier[row]);
  return found;
}
} // namespace Voussoir
