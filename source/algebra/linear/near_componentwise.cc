// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/linear/near_componentwise.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/lac/solver_cg.h>

#include <algorithm>
#include <array>
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

double sum_of_contacts(const double *a, const unsigned int n_contacts)
{
  return std::accumulate(a, a + n_contacts, 0.);
}
} // namespace

class NearComponentwise::Operator
{
public:
  explicit Operator(const NearComponentwise &system) : of(system) {}
  void vmult(Vector &to, const Vector &from) const
  {
    to.equ(of.shift, from);
    std::array<double, Structure::most_rows> rows;
    const unsigned int n_rows = of.structure.n_rows();
    const double *a = of.coefficients.data();
    for (unsigned int e = 0; e < of.structure.joints().size(); ++e)
    {
      of.structure.find_jumps(e, from.begin(), rows.data());
      for (unsigned int r = 0; r < n_rows; ++r)
        rows[r] *= *a++;
      of.structure.add_jump_gradient(e, rows.data(), to.begin());
    }
  }

private:
  const NearComponentwise &of;
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
  AssertDimension(structure.n_unknowns(), 2);
  AssertDimension(structure.processes().size(), 1);
}

bool NearComponentwise::serves(const Structure &structure,
                               const std::vector<double> &coefficients)
{
  const unsigned int n_contacts = structure.n_contacts();
  for (auto a = coefficients.begin(); a != coefficients.end();
       a += n_contacts + 1)
  {
    const double sum = sum_of_contacts(&*a, n_contacts);
    if (!(a[n_contacts] <= largest_factor * sum &&
          sum <= largest_factor * a[n_contacts]))
      return false;
  }
  return true;
}

bool NearComponentwise::prepare(const std::vector<double> &new_coefficients,
                                const double new_shift)
{
  const unsigned int n_contacts = structure.n_contacts();
  std::vector<double> isotropic = new_coefficients;
  for (std::size_t k = 0; k < isotropic.size(); k += n_contacts + 1)
    isotropic[k + n_contacts] = sum_of_contacts(&isotropic[k], n_contacts);
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
