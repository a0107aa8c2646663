// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/invalid_index.h>
#include <voussoir/stress/least_norm.h>

#include <algorithm>
#include <array>

namespace Voussoir
{
using dealii::Tensor;

namespace
{
/** The rigid motions: two translations and a rotation about the centre. */
constexpr unsigned int n_rigid = 3;

/** Rigid motion @p m at @p x; the rotation has p = -1 with it. */
Tensor<1, 2> rigid_motion(const unsigned int m, const dealii::Point<2> &x)
{
  Tensor<1, 2> v;
  if (m < 2)
    v[m] = 1.;
  else
  {
    v[0] = -x[1];
    v[1] = x[0];
  }
  return v;
}

/** j(1) : tau for a row of tau. */
double skew_of(const unsigned int row, const Tensor<1, 2> &tau)
{
  return row == 0 ? tau[1] : -tau[0];
}
} // namespace

LeastNorm::LeastNorm(const unsigned int n_sides,
                     const unsigned int n_refinements,
                     const unsigned int degree)
    : CellStress(
          SubTriangulation::thirds(n_refinements), n_sides, degree, true),
      n_fluxes(spaces.n_unknown_fluxes()),
      n_multipliers(spaces.n_sub_cells() * spaces.n_multipliers_per_sub_cell()),
      system(couplings())
{
  unknowns.reinit(2 * n_fluxes + 3 * n_multipliers);
}

unsigned int LeastNorm::velocity(const unsigned int row,
                                 const unsigned int s,
                                 const unsigned int j) const
{
  return 2 * n_fluxes + row * n_multipliers +
         s * spaces.n_multipliers_per_sub_cell() + j;
}

bool LeastNorm::find_fluxes()
{
  set_known();
  add_rigid_acceleration();
  assemble();
  for (const unsigned int i : held())
    unknowns[i] = 0.;
  return system.solve(unknowns);
}

/** The right-hand side, but for the rigid acceleration. */
void LeastNorm::set_known()
{
  unknowns = 0.;
  for (unsigned int s = 0; s < spaces.n_sub_cells(); ++s)
  {
    const CellSpaces::Integrals &integrals = spaces.integrals(s);
    for (unsigned int row = 0; row < 2; ++row)
    {
      for (unsigned int j = 0; j < integrals.mean.size(); ++j)
        unknowns[velocity(row, s, j)] -= body_force(s)[row] * integrals.mean[j];
      for (unsigned int k = 0; k < spaces.n_fluxes_per_sub_cell(); ++k)
      {
        if (spaces.flux(s, k).unknown != invalid_index)
          continue;
        const double c = coefficient(row, s, k);
        for (unsigned int l = 0; l < spaces.n_fluxes_per_sub_cell(); ++l)
          if (spaces.flux(s, l).unknown != invalid_index)
            unknowns[row * n_fluxes + spaces.flux(s, l).unknown] -=
                c * integrals.flux_mass(k, l);
        for (unsigned int j = 0; j < integrals.mean.size(); ++j)
        {
          unknowns[velocity(row, s, j)] -= c * spaces.divergence(s, j, k);
          unknowns[rotation(s, j)] -= c * skew_of(row, integrals.moment(j, k));
        }
      }
    }
  }
}

void LeastNorm::add_rigid_acceleration()
{
  Tensor<2, n_rigid> inertia;
  Tensor<1, n_rigid> unbalanced;
  const auto for_each_moment = [&](const auto &action) {
    for (unsigned int s = 0; s < spaces.n_sub_cells(); ++s)
    {
      const CellSpaces::Integrals &integrals = spaces.integrals(s);
      for (unsigned int j = 0; j < integrals.mean.size(); ++j)
      {
        // The moments of each motion with w_j, which at its node is one.
        std::array<Tensor<1, 2>, n_rigid> moments;
        for (unsigned int m = 0; m < n_rigid; ++m)
          for (unsigned int l = 0; l < integrals.mean.size(); ++l)
            moments[m] +=
                integrals.mass(j, l) * rigid_motion(m, integrals.nodes[l]);
        action(s, j, integrals.nodes[j], moments);
      }
    }
  };
  for_each_moment([&](const unsigned int s, const unsigned int j,
                      const dealii::Point<2> &node, const auto &moments) {
    for (unsigned int m = 0; m < n_rigid; ++m)
    {
      const Tensor<1, 2> v = rigid_motion(m, node);
      for (unsigned int l = 0; l < n_rigid; ++l)
        inertia[m][l] += v * moments[l];
      for (unsigned int row = 0; row < 2; ++row)
        unbalanced[m] -= v[row] * unknowns[velocity(row, s, j)];
    }
    unbalanced[2] += unknowns[rotation(s, j)];
  });
  const Tensor<1, n_rigid> acceleration = invert(inertia) * unbalanced;
  for_each_moment([&](const unsigned int s, const unsigned int j,
                      const dealii::Point<2> &, const auto &moments) {
    for (unsigned int row = 0; row < 2; ++row)
      for (unsigned int m = 0; m < n_rigid; ++m)
        unknowns[velocity(row, s, j)] += acceleration[m] * moments[m][row];
  });
}

template <typename Visitor>
void LeastNorm::for_each_entry(const Visitor &visit) const
{
  const auto visit_both = [&](const unsigned int i, const unsigned int j,
                              const double value) {
    visit(i, j, value);
    visit(j, i, value);
  };
  for (unsigned int s = 0; s < spaces.n_sub_cells(); ++s)
  {
    const CellSpaces::Integrals &integrals = spaces.integrals(s);
    for (unsigned int k = 0; k < spaces.n_fluxes_per_sub_cell(); ++k)
    {
      if (spaces.flux(s, k).unknown == invalid_index)
        continue;
      for (unsigned int row = 0; row < 2; ++row)
      {
        const unsigned int i = row * n_fluxes + spaces.flux(s, k).unknown;
        for (unsigned int l = 0; l < spaces.n_fluxes_per_sub_cell(); ++l)
          if (spaces.flux(s, l).unknown != invalid_index)
            visit(i, row * n_fluxes + spaces.flux(s, l).unknown,
                  integrals.flux_mass(k, l));
        for (unsigned int j = 0; j < integrals.mean.size(); ++j)
        {
          visit_both(i, velocity(row, s, j), spaces.divergence(s, j, k));
          visit_both(i, rotation(s, j), skew_of(row, integrals.moment(j, k)));
        }
      }
    }
  }
}

/** The sparsity pattern of the matrix. */
dealii::DynamicSparsityPattern LeastNorm::couplings() const
{
  dealii::DynamicSparsityPattern pattern(2 * n_fluxes + 3 * n_multipliers);
  for (unsigned int i = 2 * n_fluxes; i < pattern.n_rows(); ++i)
    pattern.add(i, i);
  for_each_entry([&](const unsigned int i, const unsigned int j, double) {
    pattern.add(i, j);
  });
  return pattern;
}

void LeastNorm::assemble()
{
  system.clear();
  const std::array<unsigned int, 3> fixed = held();
  const auto is_held = [&](const unsigned int i) {
    return std::find(fixed.begin(), fixed.end(), i) != fixed.end();
  };
  for_each_entry(
      [&](const unsigned int i, const unsigned int j, const double value) {
        if (!is_held(i) && !is_held(j))
          system.add(i, j, value);
      });
  for (const unsigned int i : fixed)
    system.add(i, i, 1.);
}
} // namespace Voussoir
