// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/stress/symmetric_fluxes.h>
#include <voussoir/stress/tetrahedral_stress.h>

#include <deal.II/base/parallel.h>

#include <cmath>
#include <numeric>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
using Tetrahedron = TetrahedralStress::Tetrahedron;

/** An eigenvalue of the inertia of triangles that is none, over the square of
 * their area. */
constexpr double no_inertia = 1e-9;
/** A moment of a face, over its force and the size of the cell, that is
 * rounding. */
constexpr double no_moment = 1e-14;
constexpr unsigned int cells_of_task = 16;

/** The least solution of J a = M where J is no less than @p least, and M more
 * than @p rounding. */
Tensor<1, 3> least_solution(const Tensor<2, 3> &J,
                            const Tensor<1, 3> &M,
                            const double least,
                            const double rounding)
{
  const auto pairs = dealii::eigenvectors(dealii::symmetrize(J));
  Tensor<1, 3> a;
  for (const auto &[value, vector] : pairs)
    if (value > least && std::abs(vector * M) > rounding)
      a += (vector * M / value) * vector;
  return a;
}

/** One cell, in which the unit of length is its size. */
class CellOfTetrahedra
{
public:
  CellOfTetrahedra(const std::vector<LoadedFace> &faces,
                   const StressedCell &cell)
      : faces(faces), centroid(cell.centroid), size(std::cbrt(cell.volume)),
        mean(0.5 * (cell.mean + transpose(cell.mean)))
  {}

  SurfaceTriangles surface() const { return surface_triangles(faces, size); }
  /**
   * @param tetrahedra one for each triangle of the surface.
   * @return false if they have the mean stress.
   */
  bool find(Tetrahedron *tetrahedra) const;

private:
  void set_mean(const SurfaceTriangles &surface, Tetrahedron *tetrahedra) const;
  std::vector<Tensor<1, 3>> deviations(const SurfaceTriangles &surface) const;

  const std::vector<LoadedFace> &faces;
  const Point<3> centroid;
  const double size;
  const Tensor<2, 3> mean;
};

void CellOfTetrahedra::set_mean(const SurfaceTriangles &surface,
                                Tetrahedron *next) const
{
  const auto &p = surface.points;
  for (const SurfaceTriangles::Triangle &triangle : surface.triangles)
    *next++ = {{{centroid, p[triangle.corners[0]], p[triangle.corners[1]],
                 p[triangle.corners[2]]}},
               triangle.face,
               mean,
               {}};
}

/**
 * The forces on triangles, over the square of the size, by which those of the
 * faces with their moments differ from those of the mean stress.
 */
std::vector<Tensor<1, 3>>
CellOfTetrahedra::deviations(const SurfaceTriangles &surface) const
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
  std::vector<Tensor<1, 3>> angle, forces;
  for (unsigned int f = 0; f < faces.size(); ++f)
    angle.push_back(least_solution(inertia[f], faces[f].moment,
                                   no_inertia * faces[f].area * faces[f].area,
                                   no_moment * size * faces[f].force.norm()));
  for (unsigned int t = 0; t < surface.triangles.size(); ++t)
  {
    const LoadedFace &face = faces[surface.triangles[t].face];
    forces.push_back(
        area[t] / (size * size) *
        (face.force / face.area +
         cross_product_3d(angle[surface.triangles[t].face], arm[t]) -
         mean * face.normal));
  }
  return forces;
}

/** @p surface in units of the size around the centroid. */
SurfaceTriangles
scaled(SurfaceTriangles surface, const Point<3> &centroid, const double size)
{
  for (Point<3> &x : surface.points)
    x = Point<3>((x - centroid) / size);
  return surface;
}

bool CellOfTetrahedra::find(Tetrahedron *tetrahedra) const
{
  Tensor<1, 3> divergence;
  for (const LoadedFace &face : faces)
    divergence += face.force / (size * size);
  const SurfaceTriangles triangles = surface();
  set_mean(triangles, tetrahedra);
  if (!triangles.is_closed)
    return false;
  const SurfaceTriangles of_unit_size = scaled(triangles, centroid, size);
  const std::vector<Tensor<1, 3>> forces = deviations(triangles);
  SymmetricFluxes fluxes(of_unit_size, forces, divergence);
  if (!fluxes.find())
    return false;
  for (unsigned int t = 0; t < forces.size(); ++t)
  {
    tetrahedra[t].stress += fluxes.stress(t);
    tetrahedra[t].divergence = fluxes.divergence(t) / size;
  }
  return true;
}
} // namespace

std::vector<StressedCell> stressed_cells(const SpaceScene &scene,
                                         const std::vector<Tensor<2, 3>> &means)
{
  const Packing<3> &packing = scene.packing();
  std::vector<StressedCell> cells;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    cells.push_back({packing.moments(c).centroid, packing.volume(c), means[c]});
  return cells;
}

TetrahedralStress
tetrahedral_stress(const std::vector<StressedCell> &cells,
                   const std::vector<std::vector<LoadedFace>> &faces)
{
  const unsigned int n = cells.size();
  TetrahedralStress stress;
  stress.first.resize(n + 1, 0);
  std::vector<char> is_found(n, false);
  const auto for_each_cell = [&](const auto &action) {
    dealii::parallel::apply_to_subranges(
        0U, n,
        [&](const unsigned int begin, const unsigned int end) {
          for (unsigned int c = begin; c < end; ++c)
            action(c, CellOfTetrahedra(faces[c], cells[c]));
        },
        cells_of_task);
  };
  // They are counted first, since copies of lists would take as much memory
  // again as all the rest.
  for_each_cell([&](const unsigned int c, const CellOfTetrahedra &cell) {
    stress.first[c + 1] = cell.surface().triangles.size();
  });
  std::partial_sum(stress.first.begin(), stress.first.end(),
                   stress.first.begin());
  stress.list.resize(stress.first.back());
  for_each_cell([&](const unsigned int c, const CellOfTetrahedra &cell) {
    is_found[c] = cell.find(stress.list.data() + stress.first[c]);
  });
  for (unsigned int c = 0; c < n; ++c)
    if (!is_found[c])
      stress.undetermined.push_back(c);
  return stress;
}
} // namespace Voussoir
