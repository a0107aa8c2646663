// SPDX-License-Identifier: LGPL-2.1-or-later

// The stress on the tetrahedra of one cell: each triangle bears its force, the
// tetrahedra of each face together are symmetric, and the divergence is that of
// the balance, where there is one. In cubes with a corner cut off, in drums,
// slabs and random cells; however a cell is turned, and wherever its faces
// begin.

#include <voussoir/stress/symmetric_fluxes.h>

#include "../statics/space_scenes.h"
#include <numeric>

namespace test_symmetric_fluxes
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

/** The surface of a cell around its centroid, in units of its size. */
SurfaceTriangles surface_of(const Packing<3> &packing, const unsigned int cell)
{
  const SpaceCase of{packing};
  const SpaceScene scene(of.blocks(), SpaceLoads(packing.n_cells()));
  FaceForces forces;
  for (const auto &interface : of.packing.interfaces())
  {
    forces.list.push_back({interface.centroid, {}});
    forces.first.push_back(forces.list.size());
  }
  const double size = std::cbrt(packing.volume(cell));
  SurfaceTriangles surface =
      surface_triangles(loaded_faces(scene, forces)[cell], size);
  for (Point<3> &x : surface.points)
    x = Point<3>((x - packing.moments(cell).centroid) / size);
  return surface;
}

/** Twice the area along the normal. */
Tensor<1, 3> twice_area(const SurfaceTriangles &of, const unsigned int t)
{
  const auto &p = of.points;
  const auto &c = of.triangles[t].corners;
  return cross_product_3d(p[c[1]] - p[c[0]], p[c[2]] - p[c[0]]);
}

Tensor<1, 3> centre(const SurfaceTriangles &of, const unsigned int t)
{
  const auto &c = of.triangles[t].corners;
  return (Tensor<1, 3>(of.points[c[0]]) + of.points[c[1]] + of.points[c[2]]) /
         3.;
}

double volume_of(const SurfaceTriangles &of, const unsigned int t)
{
  return twice_area(of, t) *
         Tensor<1, 3>(of.points[of.triangles[t].corners[0]]) / 6.;
}

/** Forces on the triangles, as of an affine traction on each face, without a
 * torque about the origin. */
std::vector<Tensor<1, 3>> balanced_forces(const SurfaceTriangles &surface,
                                          Random &random)
{
  const auto any = [&]() {
    return vector(random() - 0.5, random() - 0.5, random() - 0.5);
  };
  std::vector<Tensor<1, 3>> forces, on_face, by_place[3];
  Tensor<1, 3> torque;
  Tensor<2, 3> inertia;
  for (unsigned int t = 0; t < surface.triangles.size(); ++t)
  {
    const Tensor<1, 3> x = centre(surface, t);
    const double area = 0.5 * twice_area(surface, t).norm();
    while (on_face.size() <= surface.triangles[t].face)
    {
      on_face.push_back(any());
      for (auto &of : by_place)
        of.push_back(any());
    }
    Tensor<1, 3> traction = on_face[surface.triangles[t].face];
    for (unsigned int i = 0; i < 3; ++i)
      traction += x[i] * by_place[i][surface.triangles[t].face];
    forces.push_back(area * traction);
    torque += cross_product_3d(x, forces.back());
    for (unsigned int i = 0; i < 3; ++i)
      inertia[i][i] += area * x.norm_square();
    inertia -= area * outer_product(x, x);
  }
  const Tensor<1, 3> turn = invert(inertia) * torque;
  for (unsigned int t = 0; t < surface.triangles.size(); ++t)
    forces[t] -= 0.5 * twice_area(surface, t).norm() *
                 cross_product_3d(turn, centre(surface, t));
  return forces;
}

/** What has to hold of every surface; the errors. */
struct Errors
{
  double tractions = 0., skew = 0., divergence = 0., largest = 0.;
  bool are_found = true;
};

void judge(const SurfaceTriangles &surface, Random &random, Errors &errors)
{
  const std::vector<Tensor<1, 3>> forces = balanced_forces(surface, random);
  const Tensor<1, 3> sum =
      std::accumulate(forces.begin(), forces.end(), Tensor<1, 3>());
  SymmetricFluxes fluxes(surface, forces, sum);
  if (!surface.is_closed || !fluxes.find())
  {
    errors.are_found = false;
    return;
  }
  std::vector<Tensor<2, 3>> of_faces;
  double square = 0.;
  for (unsigned int t = 0; t < forces.size(); ++t)
  {
    const double volume = volume_of(surface, t);
    // The row is the mean and div sigma / 3 times the place in the tetrahedron.
    const Tensor<1, 3> through =
        fluxes.stress(t) * twice_area(surface, t) / 2. +
        0.25 * volume * fluxes.divergence(t);
    errors.tractions = std::max(errors.tractions, (through - forces[t]).norm());
    errors.largest = std::max(errors.largest, fluxes.stress(t).norm());
    square += volume * (fluxes.divergence(t) - sum).norm_square();
    of_faces.resize(
        std::max<std::size_t>(of_faces.size(), surface.triangles[t].face + 1));
    of_faces[surface.triangles[t].face] += volume * fluxes.stress(t);
  }
  errors.divergence = std::max(errors.divergence, std::sqrt(square));
  for (const Tensor<2, 3> &of : of_faces)
    errors.skew = std::max(errors.skew, (of - transpose(of)).norm());
}

void report(const std::string &name, const Errors &errors)
{
  std::cout << name << std::endl;
  check("  all are found", errors.are_found);
  check_error("  forces on triangles", errors.tractions, 1e-12);
  check_error("  symmetry of faces", errors.skew, 1e-12);
}

/** A cube without the corner at (1, 1, 1), by the length @p h. */
Packing<3> cut_cube(const double h)
{
  CellFaces cells;
  cells.vertices = {{0., 0., 0.},    {1., 0., 0.},     {1., 1., 0.},
                    {0., 1., 0.},    {0., 0., 1.},     {1., 0., 1.},
                    {0., 1., 1.},    {1. - h, 1., 1.}, {1., 1. - h, 1.},
                    {1., 1., 1. - h}};
  for (const std::vector<unsigned int> &face :
       {std::vector<unsigned int>{0, 3, 2, 1},
        {0, 1, 5, 4},
        {0, 4, 6, 3},
        {1, 2, 9, 8, 5},
        {2, 3, 6, 7, 9},
        {4, 5, 8, 7, 6},
        {7, 8, 9}})
    cells.add_face(face);
  cells.end_cell();
  return Packing<3>(cells);
}

/** A drum of many sides. */
Packing<3> drum(const unsigned int n_sides)
{
  CellFaces cells;
  std::vector<Point<2>> base;
  for (unsigned int k = 0; k < n_sides; ++k)
    base.emplace_back(std::cos(2. * dealii::numbers::PI * k / n_sides),
                      std::sin(2. * dealii::numbers::PI * k / n_sides));
  add_prism(cells, base, 0., 1.);
  return Packing<3>(cells);
}

/**
 * The same cell with other numbers of its points, triangles and corners, turned
 * by a right angle: the stress is the same, turned.
 */
void other_order(const SurfaceTriangles &surface, Random &random)
{
  const std::vector<Tensor<1, 3>> forces = balanced_forces(surface, random);
  const auto turned = [](const Tensor<1, 3> &x) {
    return vector(-x[1], x[0], x[2]);
  };
  const unsigned int n = surface.points.size(), m = surface.triangles.size();
  SurfaceTriangles other = surface;
  std::vector<Tensor<1, 3>> other_forces(m);
  for (unsigned int k = 0; k < n; ++k)
    other.points[n - 1 - k] = Point<3>(turned(surface.points[k]));
  for (unsigned int t = 0; t < m; ++t)
  {
    const SurfaceTriangles::Triangle &of = surface.triangles[t];
    SurfaceTriangles::Triangle &to = other.triangles[m - 1 - t];
    to.face = surface.triangles[m - 1].face - of.face;
    for (unsigned int k = 0; k < 3; ++k)
      to.corners[(k + 1) % 3] = n - 1 - of.corners[k];
    other_forces[m - 1 - t] = turned(forces[t]);
  }
  number_edges(other);
  const Tensor<1, 3> sum =
      std::accumulate(forces.begin(), forces.end(), Tensor<1, 3>());
  SymmetricFluxes found(surface, forces, sum),
      found_there(other, other_forces, turned(sum));
  check("A cell in another order", found.find() && found_there.find());
  double error = 0., largest = 0.;
  for (unsigned int t = 0; t < m; ++t)
    for (unsigned int i = 0; i < 3; ++i)
    {
      Tensor<1, 3> axis;
      axis[i] = 1.;
      const Tensor<1, 3> here = found.stress(t) * axis,
                         there = found_there.stress(m - 1 - t) * turned(axis);
      error = std::max(error, (there - turned(here)).norm());
      largest = std::max(largest, here.norm());
    }
  check_error("  its stress", error / largest, 1e-9);
}

void run()
{
  Random random(1);
  for (const double h : {1e-1, 1e-2, 1e-3, 1e-4})
  {
    Errors errors;
    judge(surface_of(Packing<3>(cut_cube(h)), 0), random, errors);
    report("A cube without a corner of " + std::to_string(h), errors);
    check("  values are of the size of the tractions", errors.largest < 30.);
  }

  CellFaces box;
  add_box(box, {0., 0., 0.}, {1., 1.5, 0.7});
  Errors of_box, of_slab, of_drum;
  judge(surface_of(Packing<3>(box), 0), random, of_box);
  report("A box", of_box);
  check_error("  divergence", of_box.divergence, 1e-10);
  CellFaces slab;
  add_box(slab, {0., 0., 0.}, {1., 1., 1e-3});
  judge(surface_of(Packing<3>(slab), 0), random, of_slab);
  report("A slab", of_slab);
  judge(surface_of(drum(64), 0), random, of_drum);
  report("A drum of 64 sides", of_drum);

  const Packing<3> grains = cells_in_box(300, {1., 1., 1.}, 3);
  Errors errors;
  for (unsigned int c = 0; c < grains.n_cells(); ++c)
    judge(surface_of(grains, c), random, errors);
  report("Random cells", errors);
  check_error("  divergence", errors.divergence, 1e-8);
  for (unsigned int c = 0; c < 3; ++c)
    other_order(surface_of(grains, c), random);
  other_order(surface_of(Packing<3>(box), 0), random);
}

const RoomTest test("symmetric_fluxes", run);
} // namespace test_symmetric_fluxes
