// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/none.h>
#include <voussoir/stress/fan.h>

#include <algorithm>
#include <limits>

namespace Voussoir
{
namespace
{
/** Ratio of the pivots of B B^T below which a cell counts as undetermined. */
constexpr double smallest_pivot_ratio = 1e-12;

/** The sparsity pattern of the mixed problem. */
dealii::DynamicSparsityPattern couplings(const CellSpaces &spaces)
{
  const unsigned int n = spaces.n_unknown_fluxes();
  dealii::DynamicSparsityPattern pattern(2 * n + spaces.n_sub_cells());
  for (unsigned int s = 0; s < spaces.n_sub_cells(); ++s)
    for (unsigned int k = 0; k < spaces.n_fluxes_per_sub_cell(); ++k)
    {
      const unsigned int flux = spaces.flux(s, k).unknown;
      if (flux == none)
        continue;
      for (unsigned int row = 0; row < 2; ++row)
      {
        for (unsigned int l = 0; l < spaces.n_fluxes_per_sub_cell(); ++l)
          if (spaces.flux(s, l).unknown != none)
            pattern.add(row * n + flux, row * n + spaces.flux(s, l).unknown);
        pattern.add(row * n + flux, 2 * n + s);
        pattern.add(2 * n + s, row * n + flux);
      }
    }
  return pattern;
}

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
      system(couplings(spaces))
{
  unknowns.reinit(2 * spaces.n_unknown_fluxes() + n_sides);
  gram.reinit(n_sides, n_sides);
  first_of_flux.resize(2 * spaces.n_unknown_fluxes());
}

bool Fan::find_fluxes()
{
  if (!is_determined())
    return false;

  const unsigned int n = spaces.n_unknown_fluxes();
  const unsigned int n_local = spaces.n_fluxes_per_sub_cell();
  system.clear();
  unknowns = 0.; // holds the right hand side until it is solved
  for (unsigned int s = 0; s < n_sides; ++s)
    for (unsigned int row = 0; row < 2; ++row)
    {
      // The divergence of phi_k is its flux, +-1, over det J, and det J the
      // area of the sub-cell times a function of the reference coordinates that
      // is the same in all. So the integral of the product of two is +-1 over
      // the area times a common factor, which the minimiser does not see;
      // without it the divergence is compared with the body force in the mean
      // over each sub-cell.
      const double area = spaces.integrals(s).area;
      double known_divergence = body_force(s)[row] * area, known_skew = 0.;
      for (unsigned int l = 0; l < n_local; ++l)
        if (spaces.flux(s, l).unknown == none)
        {
          const double c = coefficient(row, s, l);
          known_divergence += c * spaces.divergence(s, 0, l);
          known_skew += c * skew_moment(spaces, s, row, l);
        }
      for (unsigned int k = 0; k < n_local; ++k)
      {
        if (spaces.flux(s, k).unknown == none)
          continue;
        const unsigned int i = row * n + spaces.flux(s, k).unknown;
        const double divergence = spaces.divergence(s, 0, k) / area;
        unknowns[i] -= divergence * known_divergence;
        for (unsigned int l = 0; l < n_local; ++l)
          if (spaces.flux(s, l).unknown != none)
            system.add(i, row * n + spaces.flux(s, l).unknown,
                       divergence * spaces.divergence(s, 0, l));
        const double moment = skew_moment(spaces, s, row, k);
        system.add(i, 2 * n + s, moment);
        system.add(2 * n + s, i, moment);
      }
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
            std::make_pair(none, 0.));
  for (unsigned int s = 0; s < n_sides; ++s)
    for (unsigned int k = 0; k < spaces.n_fluxes_per_sub_cell(); ++k)
      for (unsigned int row = 0; row < 2; ++row)
      {
        const unsigned int flux = spaces.flux(s, k).unknown;
        if (flux == none)
          continue;
        const double moment = skew_moment(spaces, s, row, k);
        gram(s, s) += moment * moment;
        auto &[other, its_moment] =
            first_of_flux[row * spaces.n_unknown_fluxes() + flux];
        if (other != none)
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
