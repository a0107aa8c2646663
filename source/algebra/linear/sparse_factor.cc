// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/linear/cholmod_failure.h>
#include <voussoir/algebra/linear/elimination_order.h>
#include <voussoir/algebra/linear/sparse_factor.h>
#include <voussoir/base/chunks.h>

#include <algorithm>
#include <cholmod.h>
#include <limits>
#include <numeric>
#include <utility>

namespace Voussoir
{
using Joint = Structure::Joint;

namespace
{
/** What holds an unknown that nothing holds, over what holds others most. */
constexpr double next_to_nothing = 1e-30;

/** The joints whose blocks are found before they are added. */
constexpr std::size_t joints_at_once = 2048;
} // namespace

SparseFactor::SparseFactor(const JointBlocks &blocks,
                           const unsigned int n_bodies,
                           const std::vector<unsigned int> &last,
                           const std::vector<bool> &held)
    : blocks(blocks), structure(blocks.of()), n_bodies(n_bodies), last(last),
      held(held), common(std::make_unique<cholmod_common>()),
      addition(last.size())
{
  cholmod_start(common.get());
  common->print = 0; // failures are reported by their status
  order = find_order();
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
  return blocks.n() * n_bodies;
}

unsigned int SparseFactor::n_last() const
{
  return blocks.n() * last.size();
}

struct SparseFactor::Below
{
  /** @param place of each body. */
  Below(const SparseFactor &factor, const std::vector<unsigned int> &place)
      : first(factor.n_bodies + 1, 0)
  {
    const std::vector<Joint> &joints = factor.structure.joints();
    const unsigned int n_bodies = factor.n_bodies;
    const auto for_all = [&](const auto &visit) {
      for (unsigned int e = 0; e < joints.size(); ++e)
      {
        const unsigned int minus = joints[e].cell_minus;
        const unsigned int plus = joints[e].cell_plus;
        if (minus >= n_bodies || plus >= n_bodies || factor.is_held(minus) ||
            factor.is_held(plus))
          continue;
        const auto [low, high] = std::minmax(place[minus], place[plus]);
        visit(low, high, e);
      }
    };
    for_all([&](const unsigned int low, unsigned int, unsigned int) {
      ++first[low + 1];
    });
    std::partial_sum(first.begin(), first.end(), first.begin());
    joint.resize(first.back());
    std::vector<unsigned int> next(first.begin(), first.end() - 1);
    for_all([&](const unsigned int low, const unsigned int high,
                const unsigned int e) {
      joint[next[low]++] = {high, e};
    });
    for (unsigned int c = 0; c < n_bodies; ++c)
      std::sort(joint.begin() + first[c], joint.begin() + first[c + 1]);
  }

  /** Where those of each place begin. */
  std::vector<unsigned int> first;
  /** The higher place, ascending, and the joint. */
  std::vector<std::pair<unsigned int, unsigned int>> joint;
};

std::vector<int> SparseFactor::find_order()
{
  std::vector<unsigned int> numbers(n_bodies);
  std::iota(numbers.begin(), numbers.end(), 0);
  const Below below(*this, numbers);
  cholmod_sparse *graph = check(
      cholmod_allocate_sparse(n_bodies, n_bodies, below.joint.size(), true,
                              true, -1, CHOLMOD_PATTERN, common.get()),
      *common);
  int *first = static_cast<int *>(graph->p);
  int *rows = static_cast<int *>(graph->i);
  int k = 0;
  for (unsigned int c = 0; c < n_bodies; ++c)
  {
    first[c] = k;
    for (unsigned int m = below.first[c]; m < below.first[c + 1]; ++m)
      if (k == first[c] ||
          rows[k - 1] != static_cast<int>(below.joint[m].first))
        rows[k++] = below.joint[m].first;
  }
  first[n_bodies] = k;
  std::vector<int> order = elimination_order(*graph, blocks.n(), last, *common);
  cholmod_free_sparse(&graph, common.get());
  return order;
}

/**
 * The columns of a body have its diagonal block and below it the blocks of its
 * joints to bodies that are eliminated later, in the order of these.
 */
void SparseFactor::make_pattern()
{
  std::vector<unsigned int> place(n_bodies);
  for (unsigned int k = 0; k < n_bodies; ++k)
    place[order[k]] = k;
  const Below below(*this, place);
  const unsigned int n = blocks.n();
  const std::size_t n_entries =
      std::size_t(n_bodies) * n * (n + 1) / 2 + below.joint.size() * n * n;
  matrix =
      check(cholmod_allocate_sparse(n * n_bodies, n * n_bodies, n_entries, true,
                                    true, -1, CHOLMOD_REAL, common.get()),
            *common);
  int *first = static_cast<int *>(matrix->p);
  int *rows = static_cast<int *>(matrix->i);
  of_body.resize(n_bodies * n);
  of_joint.resize(structure.joints().size() * n);
  int k = 0;
  for (unsigned int c = 0; c < n_bodies; ++c)
    for (unsigned int j = 0; j < n; ++j)
    {
      first[n * c + j] = k;
      of_body[n * order[c] + j] = k;
      for (unsigned int i = j; i < n; ++i)
        rows[k++] = n * c + i;
      unsigned int previous = dealii::numbers::invalid_unsigned_int;
      for (unsigned int m = below.first[c]; m < below.first[c + 1]; ++m)
      {
        const auto [high, e] = below.joint[m];
        // Two joints between the same bodies share their entries.
        if (high != previous)
          for (unsigned int i = 0; i < n; ++i)
            rows[k++] = n * high + i;
        of_joint[n * e + j] = k - n;
        previous = high;
      }
    }
  first[n * n_bodies] = k;
}

void SparseFactor::fill(const std::vector<double> &coefficients,
                        const double shift,
                        const double relative_shift,
                        const std::vector<FurtherRow> &further)
{
  const unsigned int n = blocks.n();
  double *values = static_cast<double *>(matrix->x);
  std::fill_n(values, static_cast<int *>(matrix->p)[matrix->ncol], 0.);
  for (unsigned int k = 0; k < n * structure.n_own_bodies(); ++k)
    values[of_body[k]] = shift;
  // All cores find the blocks of some joints, which are then added in order.
  std::vector<JointBlocks::Blocks> found(
      std::min<std::size_t>(joints_at_once, structure.joints().size()));
  for (unsigned int first = 0; first < structure.joints().size();
       first += found.size())
  {
    const unsigned int n_now =
        std::min<std::size_t>(found.size(), structure.joints().size() - first);
    for_chunks(
        n_now, items_of_a_chunk,
        [&](std::size_t, const std::size_t begin, const std::size_t end) {
          for (std::size_t k = begin; k < end; ++k)
            if (is_between_bodies(first + k))
              blocks.find(first + k, coefficients.data(), found[k]);
        });
    for (unsigned int k = 0; k < n_now; ++k)
      if (is_between_bodies(first + k))
        add(first + k, found[k]);
  }
  JointBlocks::Blocks of;
  for (const FurtherRow &one : further)
  {
    blocks.find(one.row, one.coefficient, of);
    add(one.joint, of);
  }
  if (!held.empty() || relative_shift > 0.)
    hold_bodies(relative_shift);
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

bool SparseFactor::is_between_bodies(const unsigned int joint) const
{
  return structure.joints()[joint].cell_minus < n_bodies &&
         structure.joints()[joint].cell_plus < n_bodies;
}

/** Add the blocks of a joint between bodies that count. */
void SparseFactor::add(const unsigned int joint, const JointBlocks::Blocks &of)
{
  double *values = static_cast<double *>(matrix->x);
  const unsigned int n = blocks.n();
  const unsigned int minus = structure.joints()[joint].cell_minus;
  const unsigned int plus = structure.joints()[joint].cell_plus;
  const bool couples = !is_held(minus) && !is_held(plus);
  // The block is stored in the columns of the body that is eliminated first.
  const bool transposed = of_body[n * plus] < of_body[n * minus];
  for (unsigned int j = 0; j < n; ++j)
    for (unsigned int i = 0; i < n; ++i)
    {
      if (couples)
        values[of_joint[n * joint + j] + i] +=
            of.mixed[transposed ? j * n + i : i * n + j];
      if (i < j)
        continue;
      if (!is_held(minus))
        values[of_body[n * minus + j] + i - j] += of.minus[i * n + j];
      if (!is_held(plus))
        values[of_body[n * plus + j] + i - j] += of.plus[i * n + j];
    }
}

/** Where nothing holds an unknown, next to nothing does. */
void SparseFactor::hold_bodies(const double relative_shift)
{
  double *values = static_cast<double *>(matrix->x);
  const unsigned int n = blocks.n();
  double largest = 0.;
  for (const int k : of_body)
    largest = std::max(largest, values[k]);
  for (unsigned int k = 0; k < of_body.size(); ++k)
  {
    double &diagonal = values[of_body[k]];
    diagonal = is_held(k / n) ? 1.
                              : diagonal * (1. + relative_shift) +
                                    next_to_nothing * largest;
  }
}

/** The rows and columns are in the order of their elimination. */
void SparseFactor::analyse()
{
  common->nmethods = 1;
  common->method[0].ordering = CHOLMOD_NATURAL;
  common->postorder = false;
  common->supernodal = !last.empty()  ? CHOLMOD_SUPERNODAL
                       : without_blas ? CHOLMOD_SIMPLICIAL
                                      : CHOLMOD_AUTO;
  factor = cholmod_analyze(matrix, common.get());
}

double SparseFactor::n_entries()
{
  if (factor == nullptr)
    analyse();
  return factor == nullptr ? std::numeric_limits<double>::infinity()
                           : common->lnz;
}

bool SparseFactor::factorise(const std::vector<double> &coefficients,
                             const double shift,
                             const double relative_shift,
                             const std::vector<FurtherRow> &further)
{
  fill(coefficients, shift, relative_shift, further);
  if (factor == nullptr)
    analyse();
  cholmod_factorize(matrix, check(factor, *common), common.get());
  if (common->status == CHOLMOD_NOT_POSDEF)
    return false;
  if (common->status != CHOLMOD_OK)
    throw_failure(*common);
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
} // namespace Voussoir
