// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/invalid_index.h>
#include <voussoir/stress/fan.h>

#include <algorithm>
#include <limits>

namespace Voussoir
{
namespace
{
/** Ratio of the pivots of B B^T below which a cell counts as undetermined. */
constexpr double smallest_pivot_ratio = 1e-12;

/** The integral of tau : j(1) for tau with phi_k in the given row. */
double
skew_moment(const CellSpaces &spaces, unsigned int s, unsigned int row, int k)
{
  const auto &moment = spaces.integrals(s).moment(0, k);
  return row == 0 ? moment[1] : -moment[0];
}
} // namespace

Fan::Fan(const unsigned int n_sides)
    : CellStress(SubTriangulation::fan(), n_sides, 0, false), n_sides(n_sides),
      system(couplings())
{
  unknowns.reinit(2 * spaces.n_unknown_fluxes() + n_sides);
  gram.reinit(n_sides, n_sides);
  first_of_flux.resize(2 * spaces.n_unknown_fluxes());
}

/**
 * The divergence of phi_k is its flux, +-1, over det J, and det J the area of
 * the sub-cell times a function of the reference coordinates that is the same
 * in all. So the integral of the product of two is +-1 over the area times a
 * common factor, which the minimiser does not see; without it the divergence is
 * compared with the body force in the mean over each sub-cell.
 */
template <typename Visitor>
void Fan::for_each_entry(const Visitor &visit) const
{
  const unsigned int n = spaces.n_unknown_fluxes();
  const unsigned int n_local = spaces.n_fluxes_per_sub_cell();
  for (unsigned int s = 0; s < n_sides; ++s)
    for (unsigned int row = 0; row < 2; ++row)
      for (unsigned int k = 0; k < n_local; ++k)
      {
        if (spaces.flux(s, k).unknown == invalid_index)
          continue;
        const unsigned int i = row * n + spaces.flux(s, k).unknown;
        const double divergence =
            spaces.divergence(s, 0, k) / spaces.integrals(s).area;
        for (unsigned int l = 0; l < n_local; ++l)
          if (spaces.flux(s, l).unknown != invalid_index)
            visit(i, row * n + spaces.flux(s, l).unknown,
                  divergence * spaces.divergence(s, 0, l));
        const double moment = skew_moment(spaces, s, row, k);
        visit(i, 2 * n + s, moment);
        visit(2 * n + s, i, moment);
      }
}

/** The sparsity pattern of the matrix. */
dealii::DynamicSparsityPattern Fan::couplings() const
{
  dealii::DynamicSparsityPattern pattern(2 * spaces.n_unknown_fluxes() +
                                         n_sides);
  for_each_entry([&](const unsigned int i, const unsigned int j, double) {
    pattern.add(i, j);
  });
  return pattern;
}

bool Fan::find_fluxes()
{
  if (!is_determined())
    return false;
  system.clear();
  for_each_entry([&](const unsigned int i, const unsigned int j,
                     const double value) { system.add(i, j, value); });

  const unsigned int n = spaces.n_unknown_fluxes();
  unknowns = 0.; // holds the right hand side until it is solved
  for (unsigned int s = 0; s < n_sides; ++s)
    for (unsigned int row = 0; row < 2; ++row)
    {
      const double area = spaces.integrals(s).area;
      double known_divergence = body_force(s)[row] * area;
      for (unsigned int l = 0; l < spaces.n_fluxes_per_sub_cell(); ++l)
        if (spaces.flux(s, l).unknown == invalid_index)
          known_divergence +=
              coefficient(row, s, l) * spaces.divergence(s, 0, l);
      double known_skew = 0.;
      for (unsigned int k = 0; k < spaces.n_fluxes_per_sub_cell(); ++k)
        if (const unsigned int flux = spaces.flux(s, k).unknown;
            flux != invalid_index)
          unknowns[row * n + flux] -=
              spaces.divergence(s, 0, k) / area * known_divergence;
        else
          known_skew += coefficient(row, s, k) * skew_moment(spaces, s, row, k);
      unknowns[2 * n + s] -= known_skew;
    }
  return system.solve(unknowns);
}

/**
 * True if the equations (sigma, j(q)) = 0 are independent in the free fluxes:
 * by the pivots of B B^T, with their matrix B. Unlike the pivots of the whole
 * system these do not see the weight 1/|sub-cell| of div sigma, which is large
 * along a short side and harmless.
 */
bool Fan::is_determined()
{
  gram = 0.;
  std::fill(first_of_flux.begin(), first_of_flux.end(),
            std::make_pair(invalid_index, 0.));
  for (unsigned int s = 0; s < n_sides; ++s)
    for (unsigned int k = 0; k < spaces.n_fluxes_per_sub_cell(); ++k)
      for (unsigned int row = 0; row < 2; ++row)
      {
        const unsigned int flux = spaces.flux(s, k).unknown;
        if (flux == invalid_index)
          continue;
        const double moment = skew_moment(spaces, s, row, k);
        gram(s, s) += moment * moment;
        auto &[other, its_moment] =
            first_of_flux[row * spaces.n_unknown_fluxes() + flux];
        if (other != invalid_index)
          gram(s, other) += moment * its_moment; // s > other
        other = s;
        its_moment = moment;
      }
  double smallest = std::numeric_limits<double>::infinity(), largest = 0.;
  for (unsigned int k = 0; k < n_sides; ++k)
  {
    const double pivot = gram(k, k);
    smallest = std::min(smallest, pivot);
    largest = std::max(largest, pivot);
    if (!(smallest > smallest_pivot_ratio * largest))
      return false;
    for (unsigned int i = k + 1; i < n_sides; ++i)
    {
      const double factor = gram(i, k) / pivot;
      for (unsigned int j = k + 1; j <= i; ++j)
        gram(i, j) -= factor * gram(j, k);
    }
  }
  return true;
}
} // namespace Voussoir
