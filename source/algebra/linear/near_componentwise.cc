// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/linear/near_componentwise.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/lac/solver_cg.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace Voussoir
{
namespace
{
/**
 * The factor by which the tangential coefficient may be above or below the sum
 * of the contacts. Below, as with smoothed friction, each iteration then halves
 * the error at least, and the iterations for a step take less time than a
 * factorisation of all unknowns.
 */
constexpr double largest_factor = 8.;
/** More than that needs for any residual that is asked for. */
constexpr unsigned int n_max_near_steps = 30;

/** The sum of the coefficients of the contacts of joint @p e. */
double sum_of_contacts(const Structure &structure,
                       const unsigned int e,
                       const std::vector<double> &coefficients)
{
  const auto a = coefficients.begin() + structure.first_row(e);
  return std::accumulate(a, a + structure.n_contacts(e), 0.);
}
} // namespace

class NearComponentwise::Operator
{
public:
  explicit Operator(const NearComponentwise &system) : of(system) {}
  void vmult(Vector &to, const Vector &from) const
  {
    to.equ(of.shift, from);
    rows.resize(of.structure.n_all_rows());
    of.structure.find_all_jumps(from.begin(), rows.data());
    of.structure.multiply_by_blocks(of.coefficients, rows);
    of.structure.add_all_jump_gradients(1., rows.data(), to.begin());
  }

private:
  const NearComponentwise &of;
  /** The forces, which are not allocated again for each product. */
  mutable std::vector<double> rows;
};

class NearComponentwise::Preconditioner
{
public:
  explicit Preconditioner(LinearMethod &method) : method(method) {}
  void vmult(Vector &to, const Vector &from) const
  {
    const std::vector<double> u = method.solve({from.begin(), from.end()}, 1);
    std::copy(u.begin(), u.end(), to.begin());
  }

private:
  LinearMethod &method;
};

NearComponentwise::NearComponentwise(
    const Structure &structure,
    std::unique_ptr<LinearMethod> componentwise,
    const double residual)
    : structure(structure), componentwise(std::move(componentwise)),
      residual(residual)
{
  Assert(structure.is_plane() && !structure.has_blocks() &&
             !structure.kinematics().turns(),
         dealii::ExcInternalError());
  AssertDimension(structure.processes().size(), 1);
}

bool NearComponentwise::serves(const Structure &structure,
                               const std::vector<double> &coefficients)
{
  for (unsigned int e = 0; e < structure.joints().size(); ++e)
  {
    const double sum = sum_of_contacts(structure, e, coefficients);
    const double tangential =
        coefficients[structure.first_row(e) + structure.n_contacts(e)];
    if (!(tangential <= largest_factor * sum &&
          sum <= largest_factor * tangential))
      return false;
  }
  return true;
}

bool NearComponentwise::prepare(const std::vector<double> &new_coefficients,
                                const double new_shift)
{
  std::vector<double> isotropic = new_coefficients;
  for (unsigned int e = 0; e < structure.joints().size(); ++e)
    isotropic[structure.first_row(e) + structure.n_contacts(e)] =
        sum_of_contacts(structure, e, isotropic);
  coefficients = new_coefficients;
  if (isotropic == factorised && new_shift == shift)
    return true;
  shift = new_shift;
  factorised = std::move(isotropic);
  return componentwise->prepare(factorised, shift);
}

std::vector<double> NearComponentwise::solve(const std::vector<double> &r,
                                             const unsigned int n_columns)
{
  AssertDimension(n_columns, 1);
  (void)n_columns;
  const Vector right(r.begin(), r.end());
  Vector u(right.size());
  dealii::SolverControl control(n_max_near_steps, residual * right.l2_norm());
  dealii::SolverCG<Vector> solver(control);
  try
  {
    solver.solve(Operator(*this), u, right, Preconditioner(*componentwise));
  }
  catch (const dealii::SolverControl::NoConvergence &)
  {
    return {};
  }
  return {u.begin(), u.end()};
}

} // namespace Voussoir
