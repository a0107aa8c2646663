// SPDX-License-Identifier: LGPL-2.1-or-later

// Surfaces without their slender tetrahedra: boxes with a corner cut off, slabs
// and drums, and random cells. What is left is closed and has its volume and
// its forces, and the stress in it bears these forces and is symmetric.

#include <voussoir/stress/slender_tetrahedra.h>
#include <voussoir/stress/symmetric_fluxes.h>

#include "../statics/space_scenes.h"

namespace test_slender_tetrahedra
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

double volume_of(const SurfaceTriangles &surface, const unsigned int t)
{
  const auto &p = surface.points;
  const auto &c = surface.triangles[t].corners;
  return cross_product_3d(p[c[0]], p[c[1]]) * Tensor<1, 3>(p[c[2]]) / 6.;
}

/** What has to hold of every surface; the errors. */
struct Errors
{
  double forces = 0., shares = 0., volume = 0., tractions = 0., skew = 0.;
  bool are_closed = true;
  unsigned int n_left_out = 0;
};

void judge(const SurfaceTriangles &surface, Random &random, Errors &errors)
{
  std::vector<Tensor<1, 3>> forces;
  Tensor<1, 3> sum;
  double volume = -1.;
  for (unsigned int t = 0; t < surface.triangles.size(); ++t)
  {
    const double share = volume_of(surface, t);
    forces.push_back(share * vector(random(), random(), random()));
    sum += forces.back();
    volume += share;
  }
  const SlenderTetrahedra rest(surface, forces);
  errors.are_closed &= surface.is_closed && rest.surface.is_closed;
  const unsigned int n = rest.surface.triangles.size();
  errors.n_left_out += surface.triangles.size() - n;
  Tensor<1, 3> left = sum;
  for (unsigned int t = 0; t < n; ++t)
  {
    left -= rest.forces[t];
    volume -= volume_of(rest.surface, t);
  }
  errors.volume = std::max(errors.volume, std::abs(volume + 1.));
  errors.forces = std::max(errors.forces, left.norm());
  for (const auto &heirs : rest.heirs)
  {
    double shares = -1.;
    for (const auto &heir : heirs)
      shares += heir.share;
    errors.shares = std::max(errors.shares, std::abs(shares));
  }

  SymmetricFluxes fluxes(rest.surface, rest.forces, sum);
  if (!fluxes.find())
  {
    errors.tractions = HUGE_VAL;
    return;
  }
  double largest = 0.;
  for (unsigned int t = 0; t < n; ++t)
    largest = std::max(largest, fluxes.stress(t).norm());
  for (unsigned int t = 0; t < n; ++t)
  {
    const auto &p = rest.surface.points;
    const auto &c = rest.surface.triangles[t].corners;
    const Tensor<1, 3> area =
        0.5 * cross_product_3d(p[c[1]] - p[c[0]], p[c[2]] - p[c[0]]);
    // The row is the mean and div sigma / 3 times the place in the tetrahedron.
    const Tensor<1, 3> through =
        fluxes.stress(t) * area +
        0.25 * volume_of(rest.surface, t) * fluxes.divergence(t);
    errors.tractions =
        std::max(errors.tractions, (through - rest.forces[t]).norm() / largest);
    errors.skew = std::max(
        errors.skew,
        volume_of(rest.surface, t) *
            (fluxes.stress(t) - transpose(fluxes.stress(t))).norm() / largest);
  }
}

void report(const std::string &name,
            const Errors &errors,
            const double volume_limit)
{
  std::cout << name << std::endl;
  check("  they close", errors.are_closed);
  check_error("  forces", errors.forces, 1e-14);
  check_error("  shares", errors.shares, 1e-14);
  check_error("  volume", errors.volume, volume_limit);
  check_error("  tractions", errors.tractions, 1e-12);
  check_error("  symmetry", errors.skew, 1e-12);
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

void run()
{
  Random random(1);
  for (const double h : {1e-3, 1e-4, 1e-6})
  {
    Errors errors;
    judge(surface_of(Packing<3>(cut_cube(h)), 0), random, errors);
    report("A cube without a corner of " + std::to_string(h), errors, 2. * h);
    check("  the corner is one point", errors.n_left_out == 4);
  }

  CellFaces slab;
  add_box(slab, {0., 0., 0.}, {1., 1., 1e-3});
  Errors of_slab, of_drum;
  judge(surface_of(Packing<3>(slab), 0), random, of_slab);
  check("A slab keeps all", of_slab.n_left_out == 0);
  judge(surface_of(drum(64), 0), random, of_drum);
  check("A drum of 64 sides keeps all", of_drum.n_left_out == 0);

  const Packing<3> grains = cells_in_box(300, {1., 1., 1.}, 3);
  Errors errors;
  for (unsigned int c = 0; c < grains.n_cells(); ++c)
    judge(surface_of(grains, c), random, errors);
  report("Random cells", errors, 0.02);
  check("  some triangles are left out", errors.n_left_out > 0);
}

const RoomTest test("slender_tetrahedra", run);
} // namespace test_slender_tetrahedra
