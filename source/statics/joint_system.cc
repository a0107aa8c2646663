// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/statics/joint_system.h>

#include <deal.II/base/index_set.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <algorithm>
#include <array>
#include <cholmod.h>
#include <new>

namespace Voussoir
{
using Joint = DiscreteProblem::Joint;
using Jump = DiscreteProblem::Jump;

namespace
{
/**
 * From how many cells on multigrid solves the system of both components. Below,
 * Cholesky's factorisation is faster (measured: 4.9 s against 8.7 s at 200,000
 * cells, 14 s against 22 s at 500,000); its time and memory grow faster.
 */
constexpr unsigned int n_cells_for_multigrid = 1000000;

/** The residual of the conjugate gradients, relative to the right-hand side. */
constexpr double multigrid_tolerance = 1e-12;
constexpr unsigned int n_max_multigrid_iterations = 2000;
/** ML's threshold below which a coupling counts as weak. */
constexpr double aggregation_threshold = 1e-4;
constexpr unsigned int n_smoother_sweeps = 2;

/** Entry (i, j) of the two-by-two block of a joint. */
double block(const Joint &joint, const Jump &a, unsigned int i, unsigned int j)
{
  return a.normal * joint.normal[i] * joint.normal[j] +
         a.tangential * joint.tangent[i] * joint.tangent[j];
}
} // namespace

class JointSystem::Method
{
public:
  virtual ~Method() = default;
  virtual bool prepare(const std::vector<Jump> &coefficients, double shift) = 0;
  virtual std::vector<double> solve(const std::vector<double> &r) = 0;
};

/**
 * CHOLMOD on the system of one component, a_e in place of the blocks, or of
 * two. The lower triangle is stored by columns; where the entries of each joint
 * go is found once.
 */
class JointSystem::Cholesky : public JointSystem::Method
{
public:
  Cholesky(const DiscreteProblem &problem, const unsigned int n_components)
      : problem(problem), n_components(n_components)
  {
    cholmod_start(&common);
    common.print = 0; // failures are reported by their status
  }

  ~Cholesky() override
  {
    cholmod_free_factor(&factor, &common);
    cholmod_free_sparse(&matrix, &common);
    cholmod_finish(&common);
  }

  Cholesky(const Cholesky &) = delete;
  Cholesky &operator=(const Cholesky &) = delete;

  bool prepare(const std::vector<Jump> &coefficients,
               const double shift) override
  {
    if (matrix == nullptr)
      make_pattern();
    fill(coefficients, shift);
    if (factor == nullptr)
      factor = check(cholmod_analyze(matrix, &common));
    cholmod_factorize(matrix, factor, &common);
    if (common.status == CHOLMOD_OUT_OF_MEMORY)
      throw std::bad_alloc();
    return common.status == CHOLMOD_OK;
  }

  std::vector<double> solve(const std::vector<double> &r) override
  {
    // Component by component where the components have come apart.
    const unsigned int n_columns = 2 / n_components;
    const std::size_t n_rows = r.size() / n_columns;
    cholmod_dense *right = check(cholmod_allocate_dense(
        n_rows, n_columns, n_rows, CHOLMOD_REAL, &common));
    double *to = static_cast<double *>(right->x);
    for (std::size_t k = 0; k < r.size(); ++k)
      to[k % n_columns * n_rows + k / n_columns] = r[k];

    cholmod_dense *solution = cholmod_solve(CHOLMOD_A, factor, right, &common);
    cholmod_free_dense(&right, &common);
    const double *from = static_cast<double *>(check(solution)->x);
    std::vector<double> u(r.size());
    for (std::size_t k = 0; k < r.size(); ++k)
      u[k] = from[k % n_columns * n_rows + k / n_columns];
    cholmod_free_dense(&solution, &common);
    return u;
  }

private:
  template <typename T>
  T *check(T *result) const
  {
    if (result == nullptr)
      throw std::bad_alloc();
    return result;
  }

  /**
   * The columns of a body have its diagonal block and below it the blocks of
   * its joints to higher bodies, in the order of these, which is that of the
   * joints of a packing only by chance.
   */
  void make_pattern()
  {
    const unsigned int n_bodies = problem.n_bodies();
    std::vector<std::vector<std::pair<unsigned int, unsigned int>>> below(
        n_bodies); // body and joint
    for (unsigned int e = 0; e < problem.joints().size(); ++e)
    {
      const Joint &joint = problem.joints()[e];
      below[std::min(joint.cell_minus, joint.cell_plus)].emplace_back(
          std::max(joint.cell_minus, joint.cell_plus), e);
    }

    const unsigned int n = n_components;
    const std::size_t n_entries =
        n_bodies * n * (n + 1) / 2 + problem.joints().size() * n * n;
    matrix =
        check(cholmod_allocate_sparse(n * n_bodies, n * n_bodies, n_entries,
                                      true, true, -1, CHOLMOD_REAL, &common));
    int *first = static_cast<int *>(matrix->p);
    int *rows = static_cast<int *>(matrix->i);
    of_body.resize(n_bodies * n);
    of_joint.resize(problem.joints().size() * n);
    int k = 0;
    for (unsigned int c = 0; c < n_bodies; ++c)
    {
      std::sort(below[c].begin(), below[c].end());
      for (unsigned int j = 0; j < n; ++j)
      {
        first[n * c + j] = k;
        of_body[n * c + j] = k;
        for (unsigned int i = j; i < n; ++i)
          rows[k++] = n * c + i;
        unsigned int previous = dealii::numbers::invalid_unsigned_int;
        for (const auto &[other, e] : below[c])
        {
          // Two joints between the same bodies share their entries.
          if (other != previous)
            for (unsigned int i = 0; i < n; ++i)
              rows[k++] = n * other + i;
          of_joint[n * e + j] = k - n;
          previous = other;
        }
      }
    }
    first[n * n_bodies] = k;
  }

  void fill(const std::vector<Jump> &coefficients, const double shift)
  {
    const unsigned int n = n_components;
    double *values = static_cast<double *>(matrix->x);
    std::fill_n(values, static_cast<int *>(matrix->p)[matrix->ncol], 0.);
    for (unsigned int c = 0; c < problem.n_bodies(); ++c)
      for (unsigned int j = 0; j < n; ++j)
        values[of_body[n * c + j]] = shift;
    for (unsigned int e = 0; e < coefficients.size(); ++e)
    {
      const Joint &joint = problem.joints()[e];
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
        {
          const double entry = n == 1 ? coefficients[e].normal
                                      : block(joint, coefficients[e], i, j);
          values[of_joint[n * e + j] + i] -= entry;
          if (i >= j)
            for (const unsigned int c : {joint.cell_minus, joint.cell_plus})
              values[of_body[n * c + j] + i - j] += entry;
        }
    }
  }

  const DiscreteProblem &problem;
  const unsigned int n_components;
  cholmod_common common;
  cholmod_sparse *matrix = nullptr;
  cholmod_factor *factor = nullptr;
  /** Where the diagonal entry of each column is. */
  std::vector<int> of_body;
  /** Where the first entry of each column of each joint's block is. */
  std::vector<int> of_joint;
};

/** The conjugate gradients of deal.II with Trilinos' matrix and ML. */
class JointSystem::Multigrid : public JointSystem::Method
{
public:
  explicit Multigrid(const DiscreteProblem &problem) : problem(problem)
  {
    dealii::DynamicSparsityPattern pattern(problem.n_dofs());
    const auto couple = [&](const unsigned int c, const unsigned int d) {
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j)
          pattern.add(problem.dof(c, i), problem.dof(d, j));
    };
    for (unsigned int b = 0; b < problem.n_bodies(); ++b)
      couple(b, b);
    for (const Joint &joint : problem.joints())
    {
      couple(joint.cell_minus, joint.cell_plus);
      couple(joint.cell_plus, joint.cell_minus);
    }
    const dealii::IndexSet all = dealii::complete_index_set(problem.n_dofs());
    matrix.reinit(all, pattern, MPI_COMM_SELF);
    right.reinit(all, MPI_COMM_SELF);
    solution.reinit(all, MPI_COMM_SELF);
  }

  bool prepare(const std::vector<Jump> &coefficients,
               const double shift) override
  {
    assemble(coefficients, shift);
    dealii::TrilinosWrappers::PreconditionAMG::AdditionalData data;
    data.elliptic = true;
    data.aggregation_threshold = aggregation_threshold;
    data.smoother_sweeps = n_smoother_sweeps;
    // The rigid motions of the packing: its translations.
    data.constant_modes.assign(2, std::vector<bool>(problem.n_dofs()));
    for (unsigned int b = 0; b < problem.n_bodies(); ++b)
      for (unsigned int i = 0; i < 2; ++i)
        data.constant_modes[i][problem.dof(b, i)] = true;
    preconditioner.initialize(matrix, data);
    return true;
  }

  std::vector<double> solve(const std::vector<double> &r) override
  {
    std::copy(r.begin(), r.end(), right.begin());
    solution = 0.;
    dealii::SolverControl control(n_max_multigrid_iterations,
                                  multigrid_tolerance * right.l2_norm());
    dealii::SolverCG<dealii::TrilinosWrappers::MPI::Vector> gradients(control);
    try
    {
      gradients.solve(matrix, solution, right, preconditioner);
    }
    catch (const dealii::SolverControl::NoConvergence &)
    {
      // The iterate reached so far is a direction of descent all the same.
    }
    return {solution.begin(), solution.end()};
  }

private:
  void assemble(const std::vector<Jump> &coefficients, const double shift)
  {
    matrix = 0.;
    for (unsigned int k = 0; k < problem.n_dofs(); ++k)
      matrix.add(k, k, shift);
    for (unsigned int e = 0; e < coefficients.size(); ++e)
    {
      const Joint &joint = problem.joints()[e];
      for (const unsigned int c : {joint.cell_minus, joint.cell_plus})
        for (unsigned int i = 0; i < 2; ++i)
        {
          std::array<dealii::types::global_dof_index, 4> columns;
          std::array<double, 4> values;
          unsigned int k = 0;
          for (const unsigned int d : {joint.cell_minus, joint.cell_plus})
            for (unsigned int j = 0; j < 2; ++j, ++k)
            {
              columns[k] = problem.dof(d, j);
              values[k] =
                  (c == d ? 1. : -1.) * block(joint, coefficients[e], i, j);
            }
          matrix.add(problem.dof(c, i), 4, columns.data(), values.data(),
                     false);
        }
    }
    matrix.compress(dealii::VectorOperation::add);
  }

  const DiscreteProblem &problem;
  dealii::TrilinosWrappers::SparseMatrix matrix;
  dealii::TrilinosWrappers::PreconditionAMG preconditioner;
  dealii::TrilinosWrappers::MPI::Vector right, solution;
};

JointSystem::JointSystem(const DiscreteProblem &problem,
                         const LinearSolver kind)
    : problem(problem), kind(kind)
{
}

JointSystem::~JointSystem() = default;

bool JointSystem::prepare(const std::vector<Jump> &coefficients,
                          const double shift)
{
  const bool apart =
      std::all_of(coefficients.begin(), coefficients.end(),
                  [](const Jump &a) { return a.normal == a.tangential; });
  const auto use = [&](auto &method, const auto &...arguments) {
    if (!method)
      method = std::make_unique<
          typename std::decay_t<decltype(method)>::element_type>(problem,
                                                                 arguments...);
    current = method.get();
  };
  if (kind == LinearSolver::multigrid ||
      (kind == LinearSolver::automatic && !apart &&
       problem.n_cells() >= n_cells_for_multigrid))
    use(multigrid);
  else if (apart)
    use(one_component, 1u);
  else
    use(two_components, 2u);
  return current->prepare(coefficients, shift);
}

bool JointSystem::is_direct() const
{
  return current != multigrid.get();
}

std::vector<double> JointSystem::solve(const std::vector<double> &r)
{
  return current->solve(r);
}
} // namespace Voussoir
