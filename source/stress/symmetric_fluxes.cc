// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/stress/symmetric_fluxes.h>

#include <deal.II/lac/exceptions.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;
using dealii::Vector;

namespace
{
/** The volume of no tetrahedron, where the size is one. */
constexpr double no_volume = 1e-15;
/**
 * The weight of the square of the stress beside that of what div sigma times
 * the size of the cell lacks, in a step; and the change of fluxes, over that of
 * the step before, from which on it is rounding.
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
    collect_integrals();
    assemble();
    return find_fluxes();
  }
  catch (const dealii::LACExceptions::ExcSingular &)
  {
    return false;
  }
}

void SymmetricFluxes::collect_integrals()
{
  for (unsigned int t = 0; t < surface.triangles.size(); ++t)
  {
    const SurfaceTriangles::Triangle &of = surface.triangles[t];
    if (of.face >= of_faces.size())
      of_faces.resize(of.face + 1);
    FaceIntegrals &list = of_faces[of.face];
    for (unsigned int i = 0; i < 3; ++i)
    {
      const auto known =
          std::find_if(list.begin(), list.end(), [&](const auto &entry) {
            return entry.first == of.edges[i];
          });
      const Tensor<1, 3> integral = of.signs[i] * fields[t].integral(i);
      if (known == list.end())
        list.emplace_back(of.edges[i], integral);
      else
        known->second += integral;
    }
  }
}

/** The inverse of what a step minimises, and what the multipliers see of it. */
void SymmetricFluxes::assemble()
{
  const unsigned int n = surface.n_edges;
  inverse.reinit(n, n);
  inverse = 0.;
  for (unsigned int t = 0; t < surface.triangles.size(); ++t)
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
  assemble_multipliers();
}

void SymmetricFluxes::assemble_multipliers()
{
  // Row q of a face is the integral of sigma_kj - sigma_jk, j = q + 1, k = q +
  // 2.
  const unsigned int m = of_faces.size();
  schur.reinit(3 * m, 3 * m);
  // What a flux through an edge changes in the integral of face f.
  std::vector<Tensor<1, 3>> of_edge(surface.n_edges);
  for (unsigned int f = 0; f < m; ++f)
  {
    for (unsigned int e = 0; e < surface.n_edges; ++e)
    {
      of_edge[e] = 0.;
      for (const auto &[d, integral] : of_faces[f])
        of_edge[e] += inverse(e, d) * integral;
    }
    for (unsigned int g = 0; g <= f; ++g)
    {
      Tensor<2, 3> moment;
      for (const auto &[e, integral] : of_faces[g])
        moment += outer_product(of_edge[e], integral);
      // With a and b in row r: row q sees a_j in row k, and -b_k in row j.
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
          schur(3 * g + w, 3 * f + q) = schur(3 * f + q, 3 * g + w) = sum;
        }
    }
  }
  // Each condition counts by itself: those of small faces are small.
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

void SymmetricFluxes::add_force_of_multipliers(const Vector<double> &of,
                                               Rows &to) const
{
  for (unsigned int f = 0; f < of_faces.size(); ++f)
    for (const auto &[e, integral] : of_faces[f])
      for (unsigned int q = 0; q < 3; ++q)
      {
        const unsigned int j = (q + 1) % 3, k = (q + 2) % 3;
        to[k][e] += of[3 * f + q] * integral[j];
        to[j][e] -= of[3 * f + q] * integral[k];
      }
}

void SymmetricFluxes::set_skew_parts(const Rows &of, Vector<double> &skew) const
{
  for (unsigned int f = 0; f < of_faces.size(); ++f)
  {
    Tensor<2, 3> sum;
    for (const auto &[e, integral] : of_faces[f])
      for (unsigned int r = 0; r < 3; ++r)
        sum[r] += of[r][e] * integral;
    for (unsigned int q = 0; q < 3; ++q)
    {
      const unsigned int j = (q + 1) % 3, k = (q + 2) % 3;
      skew[3 * f + q] = sum[k][j] - sum[j][k];
    }
  }
}

/**
 * One of the method of multipliers: the least of the weighted squares under the
 * conditions of symmetry, from all that is left.
 * @return the largest change of a flux.
 */
double SymmetricFluxes::take_step()
{
  const unsigned int n = surface.n_edges, m = of_faces.size();
  Rows left, step;
  for (unsigned int r = 0; r < 3; ++r)
  {
    left[r].reinit(n);
    step[r].reinit(n);
    left[r] -= of_symmetry[r];
  }
  Vector<double> multipliers(3 * m);
  set_skew_parts(fluxes, multipliers);
  for (unsigned int t = 0; t < surface.triangles.size(); ++t)
  {
    const SurfaceTriangles::Triangle &of = surface.triangles[t];
    const Tensor<1, 3> lacks = wanted - divergence(t) + of_divergence[t];
    const Tensor<2, 3> outer = outer_product(forces[t], fields[t].integral(3));
    for (unsigned int q = 0; q < 3; ++q)
    {
      const unsigned int j = (q + 1) % 3, k = (q + 2) % 3;
      multipliers[3 * of.face + q] += outer[k][j] - outer[j][k];
    }
    for (unsigned int r = 0; r < 3; ++r)
      for (unsigned int i = 0; i < 3; ++i)
      {
        double of_stress = fields[t].product(i, 3) * forces[t][r];
        for (unsigned int j = 0; j < 3; ++j)
          of_stress +=
              of.signs[j] * fields[t].product(i, j) * fluxes[r][of.edges[j]];
        left[r][of.edges[i]] +=
            of.signs[i] * (lacks[r] - weight_of_stress * of_stress);
      }
  }
  for (unsigned int r = 0; r < 3; ++r)
    inverse.vmult(step[r], left[r]);
  Vector<double> of_step(3 * m);
  set_skew_parts(step, of_step);
  multipliers += of_step;
  multipliers.scale(scale);
  schur.solve(multipliers);
  multipliers.scale(scale);
  Rows change;
  for (unsigned int r = 0; r < 3; ++r)
    change[r].reinit(n);
  add_force_of_multipliers(multipliers, change);
  double largest = 0.;
  for (unsigned int r = 0; r < 3; ++r)
  {
    of_symmetry[r] += change[r];
    left[r] -= change[r];
    inverse.vmult(step[r], left[r]);
    fluxes[r] += step[r];
    largest = std::max<double>(largest, step[r].linfty_norm());
  }
  return largest;
}

bool SymmetricFluxes::find_fluxes()
{
  for (unsigned int r = 0; r < 3; ++r)
    for (Rows *const rows : {&fluxes, &of_symmetry})
      (*rows)[r].reinit(surface.n_edges);
  of_divergence.assign(surface.triangles.size(), {});
  double last_change = HUGE_VAL;
  for (unsigned int step = 0; step < n_most_steps; ++step)
  {
    const double change = take_step();
    if (!std::isfinite(change))
      return false;
    if (!(change > 0.) || (step > 1 && change >= no_progress * last_change))
      break;
    last_change = change;
    for (unsigned int t = 0; t < surface.triangles.size(); ++t)
      of_divergence[t] += wanted - divergence(t);
  }
  // Where the divergence cannot be met, its multipliers go on growing, and
  // those of the symmetry with them; without that these have all digits.
  take_step();
  // The largest of numbers may not be one of them that is no number.
  return std::all_of(fluxes.begin(), fluxes.end(), [](const auto &row) {
    return std::all_of(row.begin(), row.end(),
                       [](const double flux) { return std::isfinite(flux); });
  });
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
} // namespace Voussoir
