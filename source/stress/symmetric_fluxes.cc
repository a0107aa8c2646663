// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/stress/symmetric_fluxes.h>

#include <deal.II/lac/exceptions.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/** The volume of no tetrahedron, where the size is one. */
constexpr double no_volume = 1e-9;
/**
 * The weight of the square of the stress beside that of the divergence times
 * the size of the cell, which it hardly changes where fluxes are determined;
 * and the change of fluxes, over that of the step before, from which on
 * it is rounding.
 */
constexpr double weight_of_stress = 1e-3, no_progress = 0.1;
constexpr unsigned int n_most_steps = 20;
/**
 * What lets the systems of the multipliers be solved, over their diagonal,
 * where conditions of symmetry follow from each other; the steps remove
 * it.
 */
constexpr double shift_of_multipliers = 1e-11;
} // namespace

SymmetricFluxes::SymmetricFluxes(const SurfaceTriangles &surface,
                                 const std::vector<Tensor<1, 3>> &forces,
                                 const Tensor<1, 3> &divergence)
    : surface(surface), forces(forces), wanted(divergence)
{
  for (const SurfaceTriangles::Triangle &triangle : surface.triangles)
  {
    const auto &p = surface.points;
    const auto &c = triangle.corners;
    fields.emplace_back(
        std::array<Point<3>, 4>{{p[c[0]], p[c[1]], p[c[2]], Point<3>()}});
  }
}

bool SymmetricFluxes::find()
{
  if (std::any_of(fields.begin(), fields.end(), [](const UnitFluxes &of) {
        return !(of.volume > no_volume);
      }))
    return false;
  try
  {
    return find_fluxes();
  }
  catch (const dealii::LACExceptions::ExcSingular &)
  {
    return false;
  }
}

/** The inverse of least squares, and what the multipliers see of it. */
void SymmetricFluxes::assemble()
{
  const unsigned int n = surface.n_edges, m = surface.triangles.size();
  inverse.reinit(n, n);
  inverse = 0.;
  for (unsigned int t = 0; t < m; ++t)
  {
    const SurfaceTriangles::Triangle &of = surface.triangles[t];
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        inverse(of.edges[i], of.edges[j]) +=
            of.signs[i] * of.signs[j] *
            (1. / fields[t].volume +
             weight_of_stress * fields[t].product(i, j));
  }
  inverse.set_property(dealii::LAPACKSupport::symmetric);
  inverse.invert();
  // Row q of tetrahedron t is sigma_kj - sigma_jk, j = q + 1, k = q + 2.
  schur.reinit(3 * m, 3 * m);
  // What a flux through an edge changes in the integral of tetrahedron t.
  std::vector<Tensor<1, 3>> of_edge(n);
  for (unsigned int t = 0; t < m; ++t)
  {
    const SurfaceTriangles::Triangle &of = surface.triangles[t];
    for (unsigned int e = 0; e < n; ++e)
    {
      of_edge[e] = 0.;
      for (unsigned int i = 0; i < 3; ++i)
        of_edge[e] +=
            of.signs[i] * inverse(e, of.edges[i]) * fields[t].integral(i);
    }
    for (unsigned int s = 0; s <= t; ++s)
    {
      const SurfaceTriangles::Triangle &other = surface.triangles[s];
      Tensor<2, 3> moment;
      for (unsigned int j = 0; j < 3; ++j)
        moment += outer_product(other.signs[j] * of_edge[other.edges[j]],
                                fields[s].integral(j));
      // With g and h in row r: row q sees g_j in row k, and -g_k in row j.
      for (unsigned int q = 0; q < 3; ++q)
        for (unsigned int w = 0; w < 3; ++w)
        {
          const unsigned int j = (q + 1) % 3, k = (q + 2) % 3, l = (w + 1) % 3,
                             o = (w + 2) % 3;
          double sum = 0.;
          if (k == o)
            sum += moment[j][l];
          if (k == l)
            sum -= moment[j][o];
          if (j == o)
            sum -= moment[k][l];
          if (j == l)
            sum += moment[k][o];
          schur(3 * s + w, 3 * t + q) = schur(3 * t + q, 3 * s + w) = sum;
        }
    }
  }
  // Each condition counts by itself: those of slender tetrahedra are small.
  scale.reinit(3 * m);
  for (unsigned int i = 0; i < 3 * m; ++i)
    scale[i] = 1. / std::sqrt(schur(i, i));
  for (unsigned int i = 0; i < 3 * m; ++i)
    for (unsigned int j = 0; j < 3 * m; ++j)
      schur(i, j) *= scale[i] * scale[j];
  for (unsigned int i = 0; i < 3 * m; ++i)
    schur(i, i) += shift_of_multipliers;
  schur.set_property(dealii::LAPACKSupport::symmetric);
  schur.compute_cholesky_factorization();
}

/** Steps of the multipliers, each with the least stress for them. */
bool SymmetricFluxes::find_fluxes()
{
  assemble();
  const unsigned int n = surface.n_edges, m = surface.triangles.size();
  // The multipliers of all steps so far, as they act on the fluxes.
  std::array<dealii::Vector<double>, 3> known, next, right, of_symmetry,
      change_of_symmetry;
  dealii::Vector<double> multipliers(3 * m);
  double last_change = HUGE_VAL;
  for (unsigned int r = 0; r < 3; ++r)
  {
    for (auto *const v : {&known[r], &next[r], &right[r], &of_symmetry[r],
                          &change_of_symmetry[r], &fluxes[r]})
      v->reinit(n);
    for (unsigned int t = 0; t < m; ++t)
    {
      const SurfaceTriangles::Triangle &of = surface.triangles[t];
      const double missing = wanted[r] - forces[t][r] / fields[t].volume;
      for (unsigned int i = 0; i < 3; ++i)
        known[r][of.edges[i]] +=
            of.signs[i] *
            (missing -
             weight_of_stress * fields[t].product(i, 3) * forces[t][r]);
    }
  }
  for (unsigned int step = 0; step < n_most_steps; ++step)
  {
    for (unsigned int r = 0; r < 3; ++r)
    {
      right[r] = known[r];
      right[r] -= of_symmetry[r];
      inverse.vmult(next[r], right[r]);
    }
    for (unsigned int t = 0; t < m; ++t)
    {
      const SurfaceTriangles::Triangle &of = surface.triangles[t];
      Tensor<2, 3> sum = outer_product(forces[t], fields[t].integral(3));
      for (unsigned int r = 0; r < 3; ++r)
        for (unsigned int i = 0; i < 3; ++i)
          sum[r] += of.signs[i] * next[r][of.edges[i]] * fields[t].integral(i);
      for (unsigned int q = 0; q < 3; ++q)
      {
        const unsigned int j = (q + 1) % 3, k = (q + 2) % 3;
        multipliers[3 * t + q] = sum[k][j] - sum[j][k];
      }
    }
    multipliers.scale(scale);
    schur.solve(multipliers);
    multipliers.scale(scale);
    for (unsigned int r = 0; r < 3; ++r)
      change_of_symmetry[r] = 0.;
    for (unsigned int t = 0; t < m; ++t)
    {
      const SurfaceTriangles::Triangle &of = surface.triangles[t];
      for (unsigned int q = 0; q < 3; ++q)
        for (unsigned int i = 0; i < 3; ++i)
        {
          const unsigned int j = (q + 1) % 3, k = (q + 2) % 3;
          const double times = of.signs[i] * multipliers[3 * t + q];
          change_of_symmetry[k][of.edges[i]] +=
              times * fields[t].integral(i)[j];
          change_of_symmetry[j][of.edges[i]] -=
              times * fields[t].integral(i)[k];
        }
    }
    double change = 0.;
    for (unsigned int r = 0; r < 3; ++r)
    {
      of_symmetry[r] += change_of_symmetry[r];
      right[r] -= change_of_symmetry[r];
      inverse.vmult(next[r], right[r]);
      for (unsigned int e = 0; e < n; ++e)
        change = std::max(change, std::abs(next[r][e] - fluxes[r][e]));
      fluxes[r] = next[r];
    }
    if (!std::isfinite(change))
      return false;
    if (!(change > 0.) || (step > 1 && change >= no_progress * last_change))
      break;
    last_change = change;
  }
  return true;
}

Tensor<2, 3> SymmetricFluxes::stress(const unsigned int t) const
{
  const SurfaceTriangles::Triangle &of = surface.triangles[t];
  Tensor<2, 3> integral = outer_product(forces[t], fields[t].integral(3));
  for (unsigned int r = 0; r < 3; ++r)
    for (unsigned int i = 0; i < 3; ++i)
      integral[r] +=
          of.signs[i] * fluxes[r][of.edges[i]] * fields[t].integral(i);
  return integral / fields[t].volume;
}

Tensor<1, 3> SymmetricFluxes::divergence(const unsigned int t) const
{
  const SurfaceTriangles::Triangle &of = surface.triangles[t];
  Tensor<1, 3> out = forces[t];
  for (unsigned int r = 0; r < 3; ++r)
    for (unsigned int i = 0; i < 3; ++i)
      out[r] += of.signs[i] * fluxes[r][of.edges[i]];
  return out / fields[t].volume;
}

double SymmetricFluxes::square() const
{
  double sum = 0.;
  for (unsigned int t = 0; t < fields.size(); ++t)
    sum += fields[t].volume * stress(t).norm_square();
  return sum;
}
} // namespace Voussoir
