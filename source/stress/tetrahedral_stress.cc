// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/stress/tetrahedral_stress.h>

#include <deal.II/base/parallel.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
using Tetrahedron = TetrahedralStress::Tetrahedron;

/** The volume of no tetrahedron, over that of the cell. */
constexpr double no_volume = 1e-9;
/**
 * The weight of the square of the stress beside that of the divergence times
 * the size of the cell, which it hardly changes where fluxes are determined;
 * and the change of fluxes, over the largest, with which steps end.
 */
constexpr double weight_of_stress = 1e-3, small_change_of_fluxes = 1e-13;
constexpr unsigned int n_most_steps = 20;
/**
 * What lets the systems of the multipliers be solved, over their diagonal,
 * where conditions of symmetry follow from each other; the steps remove
 * it.
 */
constexpr double shift_of_multipliers = 1e-11;
/** An eigenvalue of the inertia of triangles that is none, over the square of
 * their area. */
constexpr double no_inertia = 1e-9;
constexpr unsigned int cells_of_task = 16;

/** The least solution of J a = M where J is no less than @p least. */
Tensor<1, 3>
least_solution(const Tensor<2, 3> &J, const Tensor<1, 3> &M, const double least)
{
  const auto pairs = dealii::eigenvectors(dealii::symmetrize(J));
  Tensor<1, 3> a;
  for (const auto &[value, vector] : pairs)
    if (value > least)
      a += (vector * M / value) * vector;
  return a;
}

/** One cell, in which the unit of length is its size. */
class CellOfTetrahedra
{
public:
  CellOfTetrahedra(const std::vector<LoadedFace> &faces,
                   const Point<3> &centroid,
                   const double volume,
                   const Tensor<2, 3> &mean)
      : faces(faces), centroid(centroid), size(std::cbrt(volume)),
        mean(0.5 * (mean + transpose(mean))),
        surface(surface_triangles(faces, size))
  {}

  /** @return false if the tetrahedra have the mean stress. */
  bool find(std::vector<Tetrahedron> &tetrahedra);

private:
  Point<3> scaled(const unsigned int p) const
  {
    return Point<3>((surface.points[p] - centroid) / size);
  }
  bool make(std::vector<Tetrahedron> &tetrahedra);
  void find_tractions();
  bool find_fluxes();
  void assemble();
  void set(Tetrahedron &tetrahedron, unsigned int t) const;

  const std::vector<LoadedFace> &faces;
  const Point<3> centroid;
  const double size;
  const Tensor<2, 3> mean;
  const SurfaceTriangles surface;
  std::vector<double> volumes;
  /** Of each triangle the force on it, over the square of the size. */
  std::vector<Tensor<1, 3>> tractions;
  /** The divergence that balances the forces, times the size. */
  Tensor<1, 3> divergence;
  /** The integral of the product of two of the four fields of a unit of flux,
   * times the volume. */
  double product(const unsigned int t,
                 const unsigned int i,
                 const unsigned int j) const
  {
    return integrals[t][i] * integrals[t][j] + spread[t];
  }

  /** Per unit of flux out of each tetrahedron through the three facets within,
   * and through the triangle: the integral of its field. */
  std::vector<std::array<Tensor<1, 3>, 4>> integrals;
  /** The mean of |x - x_mean|^2 of each, over nine. */
  std::vector<double> spread;
  dealii::LAPACKFullMatrix<double> inverse, schur;
  /** Of the conditions of symmetry. */
  dealii::Vector<double> scale;
  /** Of each row, of each edge. */
  std::array<dealii::Vector<double>, 3> fluxes;
};

bool CellOfTetrahedra::make(std::vector<Tetrahedron> &tetrahedra)
{
  bool are_all_seen = true;
  for (const SurfaceTriangles::Triangle &triangle : surface.triangles)
  {
    std::array<Point<3>, 3> x;
    for (unsigned int m = 0; m < 3; ++m)
      x[m] = scaled(triangle.corners[m]);
    const double volume =
        cross_product_3d(x[0], x[1]) * Tensor<1, 3>(x[2]) / 6.;
    are_all_seen &= volume > no_volume;
    volumes.push_back(volume);
    const Tensor<1, 3> middle = (Tensor<1, 3>(x[0]) + x[1] + x[2]) / 4.;
    double squares = middle.norm_square();
    for (unsigned int m = 0; m < 3; ++m)
      squares += (x[m] - middle).norm_square();
    spread.push_back(squares / (20. * 9.));
    integrals.push_back({{(middle - x[0]) / 3., (middle - x[1]) / 3.,
                          (middle - x[2]) / 3., middle / 3.}});
    tetrahedra.push_back({{{centroid, surface.points[triangle.corners[0]],
                            surface.points[triangle.corners[1]],
                            surface.points[triangle.corners[2]]}},
                          mean,
                          {}});
  }
  return surface.is_closed && are_all_seen;
}

/** Spread the forces and moments of faces over their triangles. */
void CellOfTetrahedra::find_tractions()
{
  std::vector<Tensor<2, 3>> inertia(faces.size());
  std::vector<double> area(surface.triangles.size());
  std::vector<Tensor<1, 3>> arm(surface.triangles.size());
  for (unsigned int t = 0; t < surface.triangles.size(); ++t)
  {
    const SurfaceTriangles::Triangle &triangle = surface.triangles[t];
    const auto &p = surface.points;
    const auto &c = triangle.corners;
    area[t] =
        0.5 * cross_product_3d(p[c[1]] - p[c[0]], p[c[2]] - p[c[0]]).norm();
    arm[t] =
        ((p[c[0]] - centroid) + (p[c[1]] - centroid) + (p[c[2]] - centroid)) /
            3. -
        (faces[triangle.face].centroid - centroid);
    for (unsigned int i = 0; i < 3; ++i)
      inertia[triangle.face][i][i] += area[t] * arm[t].norm_square();
    inertia[triangle.face] -= area[t] * outer_product(arm[t], arm[t]);
  }
  std::vector<Tensor<1, 3>> angle;
  Tensor<1, 3> sum;
  for (unsigned int f = 0; f < faces.size(); ++f)
  {
    angle.push_back(least_solution(inertia[f], faces[f].moment,
                                   no_inertia * faces[f].area * faces[f].area));
    sum += faces[f].force;
  }
  divergence = sum / (size * size);
  for (unsigned int t = 0; t < surface.triangles.size(); ++t)
  {
    const LoadedFace &face = faces[surface.triangles[t].face];
    tractions.push_back(
        area[t] / (size * size) *
        (face.force / face.area +
         cross_product_3d(angle[surface.triangles[t].face], arm[t]) -
         mean * face.normal));
  }
}

/** The inverse of least squares, and what the multipliers see of it. */
void CellOfTetrahedra::assemble()
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
            of.signs[i] * of.signs[j] / volumes[t] *
            (1. + weight_of_stress * product(t, i, j));
  }
  inverse.set_property(dealii::LAPACKSupport::symmetric);
  inverse.invert();
  // Row q of tetrahedron t is sigma_kj - sigma_jk, j = q + 1, k = q + 2.
  schur.reinit(3 * m, 3 * m);
  for (unsigned int t = 0; t < m; ++t)
    for (unsigned int s = 0; s < m; ++s)
    {
      Tensor<2, 3> moment;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          moment += surface.triangles[t].signs[i] *
                    surface.triangles[s].signs[j] *
                    inverse(surface.triangles[t].edges[i],
                            surface.triangles[s].edges[j]) *
                    outer_product(integrals[t][i], integrals[s][j]);
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
          schur(3 * t + q, 3 * s + w) = sum;
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
bool CellOfTetrahedra::find_fluxes()
{
  assemble();
  const unsigned int n = surface.n_edges, m = surface.triangles.size();
  // The multipliers of all steps so far, as they act on the fluxes.
  std::array<dealii::Vector<double>, 3> known, next, right, of_symmetry,
      change_of_symmetry;
  dealii::Vector<double> multipliers(3 * m);
  for (unsigned int r = 0; r < 3; ++r)
  {
    for (auto *const v : {&known[r], &next[r], &right[r], &of_symmetry[r],
                          &change_of_symmetry[r], &fluxes[r]})
      v->reinit(n);
    for (unsigned int t = 0; t < m; ++t)
    {
      const SurfaceTriangles::Triangle &of = surface.triangles[t];
      const double missing = divergence[r] - tractions[t][r] / volumes[t];
      for (unsigned int i = 0; i < 3; ++i)
        known[r][of.edges[i]] +=
            of.signs[i] * (missing - weight_of_stress * product(t, i, 3) *
                                         tractions[t][r] / volumes[t]);
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
      Tensor<2, 3> sum = outer_product(tractions[t], integrals[t][3]);
      for (unsigned int r = 0; r < 3; ++r)
        for (unsigned int i = 0; i < 3; ++i)
          sum[r] += of.signs[i] * next[r][of.edges[i]] * integrals[t][i];
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
          change_of_symmetry[k][of.edges[i]] += times * integrals[t][i][j];
          change_of_symmetry[j][of.edges[i]] -= times * integrals[t][i][k];
        }
    }
    double change = 0., largest = 0.;
    for (unsigned int r = 0; r < 3; ++r)
    {
      of_symmetry[r] += change_of_symmetry[r];
      right[r] -= change_of_symmetry[r];
      inverse.vmult(next[r], right[r]);
      for (unsigned int e = 0; e < n; ++e)
      {
        change = std::max(change, std::abs(next[r][e] - fluxes[r][e]));
        largest = std::max(largest, std::abs(next[r][e]));
      }
      fluxes[r] = next[r];
    }
    if (!std::isfinite(change))
      return false;
    if (change <= small_change_of_fluxes * largest)
      break;
  }
  return true;
}

void CellOfTetrahedra::set(Tetrahedron &tetrahedron, const unsigned int t) const
{
  const SurfaceTriangles::Triangle &of = surface.triangles[t];
  Tensor<2, 3> integral = outer_product(tractions[t], integrals[t][3]);
  Tensor<1, 3> out = tractions[t];
  for (unsigned int r = 0; r < 3; ++r)
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double flux = of.signs[i] * fluxes[r][of.edges[i]];
      integral[r] += flux * integrals[t][i];
      out[r] += flux;
    }
  tetrahedron.stress = mean + integral / volumes[t];
  tetrahedron.divergence = out / (volumes[t] * size);
}

bool CellOfTetrahedra::find(std::vector<Tetrahedron> &tetrahedra)
{
  if (!make(tetrahedra))
    return false;
  find_tractions();
  try
  {
    if (!find_fluxes())
      return false;
  }
  catch (const dealii::LACExceptions::ExcSingular &)
  {
    return false;
  }
  for (unsigned int t = 0; t < tetrahedra.size(); ++t)
    set(tetrahedra[t], t);
  return true;
}
} // namespace

TetrahedralStress tetrahedral_stress(const SpaceScene &scene,
                                     const FaceForces &forces,
                                     const std::vector<Tensor<2, 3>> &means)
{
  const Packing<3> &packing = scene.packing();
  const std::vector<std::vector<LoadedFace>> faces =
      loaded_faces(scene, forces);
  std::vector<std::vector<Tetrahedron>> of_cells(packing.n_cells());
  std::vector<char> is_found(packing.n_cells(), false);
  dealii::parallel::apply_to_subranges(
      0U, packing.n_cells(),
      [&](const unsigned int begin, const unsigned int end) {
        for (unsigned int c = begin; c < end; ++c)
          is_found[c] = CellOfTetrahedra(faces[c], packing.moments(c).centroid,
                                         packing.volume(c), means[c])
                            .find(of_cells[c]);
      },
      cells_of_task);
  TetrahedralStress stress;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    if (!is_found[c])
      stress.undetermined.push_back(c);
    stress.list.insert(stress.list.end(), of_cells[c].begin(),
                       of_cells[c].end());
    stress.first.push_back(stress.list.size());
    of_cells[c] = {};
  }
  return stress;
}
} // namespace Voussoir
