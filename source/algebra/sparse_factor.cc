// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/linear_method.h>
#include <voussoir/algebra/sparse_factor.h>

#include <algorithm>
#include <cholmod.h>
#include <new>
#include <utility>

namespace Voussoir
{
using Joint = Structure::Joint;
using Jump = Structure::Jump;

namespace
{
/** The result of CHOLMOD; throws std::bad_alloc if it is null. */
template <typename T>
T *check(T *result)
{
  if (result == nullptr)
    throw std::bad_alloc();
  return result;
}
} // namespace

SparseFactor::SparseFactor(const Structure &structure,
                           const unsigned int n_components,
                           const unsigned int n_bodies,
                           const std::vector<unsigned int> &last)
    : structure(structure), n_components(n_components), n_bodies(n_bodies),
      last(last), common(std::make_unique<cholmod_common>()),
      addition(last.size())
{
  cholmod_start(common.get());
  common->print = 0; // failures are reported by their status
  make_pattern();
}

SparseFactor::~SparseFactor()
{
  cholmod_free_factor(&factor, common.get());
  cholmod_free_sparse(&matrix, common.get());
  cholmod_finish(common.get());
}

unsigned int SparseFactor::n() const
{
  return n_components * n_bodies;
}

unsigned int SparseFactor::n_last() const
{
  return n_components * last.size();
}

/**
 * The columns of a body have its diagonal block and below it the blocks of its
 * joints to higher bodies, in the order of these, which is that of the joints
 * of a packing only by chance.
 */
void SparseFactor::make_pattern()
{
  const std::vector<Joint> &joints = structure.joints();
  const auto counts = [&](const Joint &joint) {
    return joint.cell_minus < n_bodies && joint.cell_plus < n_bodies;
  };
  std::vector<unsigned int> first_below(n_bodies + 1, 0);
  for (const Joint &joint : joints)
    if (counts(joint))
      ++first_below[std::min(joint.cell_minus, joint.cell_plus) + 1];
  for (unsigned int b = 0; b < n_bodies; ++b)
    first_below[b + 1] += first_below[b];
  // Body and joint, for each body those below it.
  std::vector<std::pair<unsigned int, unsigned int>> below(first_below.back());
  std::vector<unsigned int> next(first_below.begin(), first_below.end() - 1);
  for (unsigned int e = 0; e < joints.size(); ++e)
    if (counts(joints[e]))
    {
      const auto [low, high] =
          std::minmax(joints[e].cell_minus, joints[e].cell_plus);
      below[next[low]++] = {high, e};
    }

  const unsigned int n = n_components;
  const std::size_t n_entries =
      std::size_t(n_bodies) * n * (n + 1) / 2 + below.size() * n * n;
  matrix =
      check(cholmod_allocate_sparse(n * n_bodies, n * n_bodies, n_entries, true,
                                    true, -1, CHOLMOD_REAL, common.get()));
  int *first = static_cast<int *>(matrix->p);
  int *rows = static_cast<int *>(matrix->i);
  of_body.resize(n_bodies * n);
  of_joint.resize(joints.size() * n);
  int k = 0;
  for (unsigned int c = 0; c < n_bodies; ++c)
  {
    const auto begin = below.begin() + first_below[c];
    const auto end = below.begin() + first_below[c + 1];
    std::sort(begin, end);
    for (unsigned int j = 0; j < n; ++j)
    {
      first[n * c + j] = k;
      of_body[n * c + j] = k;
      for (unsigned int i = j; i < n; ++i)
        rows[k++] = n * c + i;
      unsigned int previous = dealii::numbers::invalid_unsigned_int;
      for (auto it = begin; it != end; ++it)
      {
        // Two joints between the same bodies share their entries.
        if (it->first != previous)
          for (unsigned int i = 0; i < n; ++i)
            rows[k++] = n * it->first + i;
        of_joint[n * it->second + j] = k - n;
        previous = it->first;
      }
    }
  }
  first[n * n_bodies] = k;
}

void SparseFactor::fill(const std::vector<Jump> &coefficients,
                        const double shift)
{
  const unsigned int n = n_components;
  double *values = static_cast<double *>(matrix->x);
  std::fill_n(values, static_cast<int *>(matrix->p)[matrix->ncol], 0.);
  for (unsigned int c = 0; c < structure.n_own_bodies(); ++c)
    for (unsigned int j = 0; j < n; ++j)
      values[of_body[n * c + j]] = shift;
  for (unsigned int e = 0; e < coefficients.size(); ++e)
  {
    const Joint &joint = structure.joints()[e];
    if (joint.cell_minus >= n_bodies || joint.cell_plus >= n_bodies)
      continue;
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
      {
        const double entry = n == 1
                                 ? coefficients[e].normal
                                 : block_of_joint(joint, coefficients[e], i, j);
        values[of_joint[n * e + j] + i] -= entry;
        if (i >= j)
          for (const unsigned int c : {joint.cell_minus, joint.cell_plus})
            values[of_body[n * c + j] + i - j] += entry;
      }
  }

  for (unsigned int k = 0; k < last.size(); ++k)
  {
    addition[k] = 0.;
    for (unsigned int j = 0; j < n; ++j)
      addition[k] = std::max(addition[k], values[of_body[n * last[k] + j]]);
    if (!(addition[k] > 0.))
      addition[k] = 1.;
    for (unsigned int j = 0; j < n; ++j)
      values[of_body[n * last[k] + j]] += addition[k];
  }
}

void SparseFactor::analyse()
{
  if (last.empty())
  {
    factor = check(cholmod_analyze(matrix, common.get()));
    return;
  }
  std::vector<int> set(n(), 0), order(n());
  for (const unsigned int b : last)
    for (unsigned int i = 0; i < n_components; ++i)
      set[n_components * b + i] = 1;
  if (!cholmod_camd(matrix, nullptr, 0, set.data(), order.data(), common.get()))
    throw std::bad_alloc();
  common->nmethods = 1;
  common->method[0].ordering = CHOLMOD_GIVEN;
  common->postorder = false; // it would mix the sets
  common->supernodal = CHOLMOD_SUPERNODAL;
  factor =
      check(cholmod_analyze_p(matrix, order.data(), nullptr, 0, common.get()));
}

bool SparseFactor::factorise(const std::vector<Jump> &coefficients,
                             const double shift)
{
  fill(coefficients, shift);
  if (factor == nullptr)
    analyse();
  cholmod_factorize(matrix, factor, common.get());
  if (common->status == CHOLMOD_NOT_POSDEF)
    return false;
  if (common->status != CHOLMOD_OK)
    throw std::bad_alloc();
  if (!last.empty())
    extract_last_block();
  return true;
}

void SparseFactor::extract_last_block()
{
  const unsigned int first = n() - n_last();
  block.reinit(n_last(), n_last());
  // A supernode is a dense block of columns with the same rows.
  const int *first_column = static_cast<const int *>(factor->super);
  const int *first_row = static_cast<const int *>(factor->pi);
  const int *first_value = static_cast<const int *>(factor->px);
  const int *rows = static_cast<const int *>(factor->s);
  const double *values = static_cast<const double *>(factor->x);
  for (unsigned int s = 0; s < factor->nsuper; ++s)
  {
    const unsigned int n_rows = first_row[s + 1] - first_row[s];
    for (int column = first_column[s]; column < first_column[s + 1]; ++column)
    {
      if (column < static_cast<int>(first))
        continue;
      const unsigned int k = column - first_column[s];
      for (unsigned int i = k; i < n_rows; ++i)
        block(rows[first_row[s] + i] - first, column - first) =
            values[first_value[s] + std::size_t(k) * n_rows + i];
    }
  }
}

std::vector<double> SparseFactor::solve(std::initializer_list<int> systems,
                                        const std::vector<double> &r,
                                        const unsigned int n_columns)
{
  AssertDimension(r.size(), std::size_t(n()) * n_columns);
  cholmod_dense *values = check(
      cholmod_allocate_dense(n(), n_columns, n(), CHOLMOD_REAL, common.get()));
  std::copy(r.begin(), r.end(), static_cast<double *>(values->x));
  for (const int system : systems)
  {
    cholmod_dense *next = cholmod_solve(system, factor, values, common.get());
    cholmod_free_dense(&values, common.get());
    values = check(next);
  }
  const double *x = static_cast<const double *>(values->x);
  std::vector<double> result(x, x + r.size());
  cholmod_free_dense(&values, common.get());
  return result;
}

std::vector<double> SparseFactor::solve(const std::vector<double> &r,
                                        const unsigned int n_columns)
{
  return solve({CHOLMOD_A}, r, n_columns);
}

std::vector<double> SparseFactor::forward(const std::vector<double> &r,
                                          const unsigned int n_columns)
{
  return solve({CHOLMOD_P, CHOLMOD_L}, r, n_columns);
}

std::vector<double> SparseFactor::backward(const std::vector<double> &y,
                                           const unsigned int n_columns)
{
  return solve({CHOLMOD_Lt, CHOLMOD_Pt}, y, n_columns);
}

std::vector<unsigned int> SparseFactor::last_unknowns() const
{
  const int *order = static_cast<const int *>(factor->Perm);
  return {order + n() - n_last(), order + n()};
}

const dealii::FullMatrix<double> &SparseFactor::last_block() const
{
  return block;
}

std::vector<double> SparseFactor::added() const
{
  std::vector<double> result;
  for (const unsigned int unknown : last_unknowns())
    result.push_back(addition[std::lower_bound(last.begin(), last.end(),
                                               unknown / n_components) -
                              last.begin()]);
  return result;
}
} // namespace Voussoir
