// SPDX-License-Identifier: LGPL-2.1-or-later

// The stress inside blocks in space: a uniform one comes back in random cells
// and in what each generator makes, and a linear one in random cells, convex or
// not; a column under its weight, and a block that is bent.

#include <voussoir/packing/polyhedra/generators/building.h>
#include <voussoir/packing/polyhedra/generators/column.h>
#include <voussoir/packing/polyhedra/generators/cross_vault.h>
#include <voussoir/packing/polyhedra/generators/dome.h>
#include <voussoir/packing/polyhedra/generators/stairs.h>
#include <voussoir/packing/polyhedra/generators/vault.h>
#include <voussoir/packing/polyhedra/generators/wall.h>
#include <voussoir/stress/linear_stress.h>
#include <voussoir/stress/tetrahedral_stress.h>

#include "../statics/extruded_scenes.h"
#include "block_checks.h"

namespace test_space_stress
{
using namespace Voussoir;
using dealii::Point;

/** A symmetric tensor of size one, and its derivatives. */
struct Field
{
  Field()
  {
    mean[0][0] = -1.;
    mean[1][1] = -0.7;
    mean[2][2] = -1.3;
    mean[0][1] = mean[1][0] = 0.2;
    mean[1][2] = mean[2][1] = -0.3;
    mean[0][2] = mean[2][0] = 0.1;
  }
  dealii::Tensor<2, 3> at(const Point<3> &x) const
  {
    dealii::Tensor<2, 3> sigma = mean;
    for (unsigned int k = 0; k < 3; ++k)
      sigma += x[k] * gradient[k];
    return sigma;
  }
  /** div sigma. */
  Vector3 divergence() const
  {
    Vector3 sum;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        sum[i] += gradient[j][i][j];
    return sum;
  }
  dealii::Tensor<2, 3> mean;
  dealii::Tensor<2, 3> gradient[3];
};

/** One that varies. */
Field linear_field()
{
  Field field;
  double value = 0.3;
  for (auto &derivative : field.gradient)
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = i; j < 3; ++j)
      {
        value = std::fmod(1.7 * value + 0.37, 1.) - 0.2;
        derivative[i][j] = derivative[j][i] = value;
      }
  return field;
}

/**
 * The forces of the tractions on a polygon, with their first moments: those at
 * the middles of the sides of triangles.
 */
template <typename Add>
void integrate(const dealii::ArrayView<const Point<3>> &polygon,
               const Vector3 &normal,
               const Field &field,
               const Add &add)
{
  for (unsigned int k = 1; k + 1 < polygon.size(); ++k)
  {
    const Point<3> corners[] = {polygon[0], polygon[k], polygon[k + 1]};
    const double area =
        0.5 * cross_product_3d(corners[1] - corners[0], corners[2] - corners[0])
                  .norm();
    for (unsigned int i = 0; i < 3; ++i)
    {
      const Point<3> x = corners[i] + 0.5 * (corners[(i + 1) % 3] - corners[i]);
      add(x, area / 3. * (field.at(x) * normal));
    }
  }
}

/** A scene and forces in which each face has the tractions of a field. */
struct Known
{
  Known(const SpaceCase &of, const Field &field)
      : scene(of.blocks(), loads_of(of.packing, field))
  {
    const Packing<3> &packing = of.packing;
    for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
    {
      integrate(packing.polygon(e), packing.interfaces()[e].normal, field,
                [&](const Point<3> &x, const Vector3 &f) {
                  forces.list.push_back({x, f});
                });
      forces.first.push_back(forces.list.size());
    }
  }

  static SpaceLoads loads_of(const Packing<3> &packing, const Field &field)
  {
    SpaceLoads loads(packing.n_cells());
    const auto &faces = packing.boundary_faces();
    for (unsigned int b = 0; b < faces.size(); ++b)
      for (unsigned int p = faces[b].first_part;
           p < faces[b].first_part + faces[b].n_parts; ++p)
        integrate(
            packing.parts()[p], faces[b].normal, field,
            [&](const Point<3> &x, const Vector3 &f) {
              loads.add(faces[b].cell, f, x - packing.centre(faces[b].cell));
              loads.add_on_face(b, faces.size(), f,
                                cross_product_3d(x - faces[b].centroid, f));
            });
    for (unsigned int c = 0; c < packing.n_cells(); ++c)
      loads.add(c, -packing.volume(c) * field.divergence(),
                packing.moments(c).centroid - packing.centre(c));
    return loads;
  }

  SpaceScene scene;
  FaceForces forces;
};

/** The largest error of the stress at a vertex of a cell. */
double largest_error(const std::vector<LinearStress> &found,
                     const Packing<3> &packing,
                     const Field &field)
{
  const CellFaces &cells = packing.polyhedra();
  double error = 0.;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    for (unsigned int f = cells.first_face[c]; f < cells.first_face[c + 1]; ++f)
      for (const unsigned int v : cells.corners(f))
        error = std::max(error, (found[c].at(cells.vertices[v]) -
                                 field.at(cells.vertices[v]))
                                    .norm());
  return error;
}

/**
 * What the force and the moment through the faces of a cell lack of those of a
 * field: RT_0 has a constant traction on each triangle. Over the largest
 * force.
 */
double error_of_tractions(const TetrahedralStress &found,
                          const Known &known,
                          const Field &field)
{
  const auto faces = loaded_faces(known.scene, known.forces);
  double error = 0.;
  for (unsigned int c = 0; c < faces.size(); ++c)
  {
    std::vector<Vector3> force, moment;
    double largest = 0., diameter = 0.;
    for (const LoadedFace &face : faces[c])
    {
      force.emplace_back();
      moment.emplace_back();
      for (const auto &polygon : face.polygons)
        integrate(polygon, face.normal, field,
                  [&](const Point<3> &x, const Vector3 &f) {
                    force.back() -= f;
                    moment.back() -= cross_product_3d(x - face.centroid, f);
                  });
      largest = std::max(largest, force.back().norm());
      diameter = std::max(diameter, std::sqrt(face.area));
    }
    for (std::size_t t = found.first[c]; t < found.first[c + 1]; ++t)
    {
      const auto &of = found.list[t];
      const auto &x = of.corners; // the centroid of the cell comes first
      const Vector3 area = 0.5 * cross_product_3d(x[2] - x[1], x[3] - x[1]);
      // From the mean in the tetrahedron.
      const Vector3 through =
          of.stress * area + (x[1] - x[0]) * area / 12. * of.divergence;
      const Point<3> middle = x[1] + ((x[2] - x[1]) + (x[3] - x[1])) / 3.;
      force[of.face] += through;
      moment[of.face] +=
          cross_product_3d(middle - faces[c][of.face].centroid, through);
    }
    for (unsigned int f = 0; f < force.size(); ++f)
      error = std::max({error, force[f].norm() / largest,
                        moment[f].norm() / (largest * diameter)});
  }
  return error;
}

/** The largest skew part of the integral of the stress over the tetrahedra of a
 * face, over the volume of the cell. */
double largest_skew_part(const TetrahedralStress &found,
                         const Packing<3> &packing)
{
  double largest = 0.;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    std::vector<dealii::Tensor<2, 3>> of_faces;
    for (std::size_t t = found.first[c]; t < found.first[c + 1]; ++t)
    {
      const auto &of = found.list[t];
      const auto &x = of.corners;
      of_faces.resize(std::max<std::size_t>(of_faces.size(), of.face + 1));
      of_faces[of.face] += cross_product_3d(x[1] - x[0], x[2] - x[0]) *
                           (x[3] - x[0]) / (6. * packing.volume(c)) * of.stress;
    }
    for (const auto &of : of_faces)
      largest = std::max(largest, (of - transpose(of)).norm());
  }
  return largest;
}

/** The stress of Raviart and Thomas: what it has to meet, and how well. */
void check_tetrahedra(const Known &known,
                      const Packing<3> &packing,
                      const Field &field,
                      const std::vector<dealii::Tensor<2, 3>> &means)
{
  const TetrahedralStress found =
      tetrahedral_stress(known.scene, known.forces, means);
  check("  all blocks have it", found.undetermined.empty());
  const bool is_uniform = field.divergence().norm() == 0.;
  double error = 0., volume_error = 0.;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    double volume = 0.;
    for (std::size_t t = found.first[c]; t < found.first[c + 1]; ++t)
    {
      const auto &of = found.list[t];
      const auto &x = of.corners;
      volume += cross_product_3d(x[1] - x[0], x[2] - x[0]) * (x[3] - x[0]) / 6.;
      if (is_uniform)
        error = std::max({error, (of.stress - field.mean).norm(),
                          of.divergence.norm() * std::cbrt(packing.volume(c))});
    }
    volume_error =
        std::max(volume_error, std::abs(volume / packing.volume(c) - 1.));
  }
  check_error("  volume of tetrahedra", volume_error, 1e-12);
  check_error("  those of a face are symmetric",
              largest_skew_part(found, packing), 1e-12);
  check_error("  force and moment of each face",
              error_of_tractions(found, known, field), 1e-12);
  if (is_uniform)
    check_error("  they have a uniform stress", error, 1e-10);
}

void check_field(const std::string &name,
                 const Packing<3> &packing,
                 const Field &field)
{
  std::cout << name << std::endl;
  SpaceCase of{packing};
  of.packing = packing;
  of.mu = 0.5;
  const Known known(of, field);
  const auto means = cell_mean_stresses(known.scene, known.forces);
  double error = 0., skew = 0.;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    error = std::max(error,
                     (means[c] - field.at(packing.moments(c).centroid)).norm());
    skew = std::max(skew, (means[c] - transpose(means[c])).norm());
  }
  check_error("  mean stress", error, 1e-10);
  check_error("  its skew part", skew, 1e-13);
  const auto found = linear_stresses(known.scene, known.forces, means);
  check_error("  stress at the vertices", largest_error(found, packing, field),
              1e-9);
  check_tetrahedra(known, packing, field, means);
  double residual = 0.;
  for (const LinearStress &of_cell : found)
    residual = std::max(residual, of_cell.residual);
  check_error("  forces through the faces", residual, 1e-8);
}

/** Boxes on each other, under their weight. */
void column()
{
  constexpr unsigned int n = 5;
  CellFaces cells;
  for (unsigned int k = 0; k < n; ++k)
    add_box(cells, {0., 0., 1. * k}, {0.8, 0.5, k + 1.});
  SpaceCase of{Packing<3>(cells)};
  of.mu = 0.5;
  const SpaceScene scene(of.blocks(),
                         body_force(of.packing, vector(0., 0., -2.)));
  const FaceForces forces = elastic_forces(scene);
  const auto found =
      linear_stresses(scene, forces, cell_mean_stresses(scene, forces));
  Field field;
  field.mean = 0.;
  field.mean[2][2] = -2. * n;
  field.gradient[2][2][2] = 2.;
  check_error("A column under its weight",
              largest_error(found, of.packing, field), 1e-9);
}

/** A block with a pressure on top that grows along x. */
void bending()
{
  CellFaces cells;
  add_box(cells, {0., 0., 0.}, {1., 0.5, 2.});
  SpaceCase of{Packing<3>(cells)};
  of.mu = 0.5;
  Field field;
  field.mean = 0.;
  field.mean[2][2] = -1.;
  field.gradient[0][2][2] = -0.4;
  const SpaceLoads loads = Known::loads_of(of.packing, field);
  const SpaceScene scene(of.blocks(), loads);
  const FaceForces forces = elastic_forces(scene);
  const auto found =
      linear_stresses(scene, forces, cell_mean_stresses(scene, forces));
  check_error("A block that is bent", largest_error(found, of.packing, field),
              1e-9);
}

/** A block whose fluxes have a kernel. */
Packing<3> octahedron()
{
  CellFaces cells;
  for (unsigned int i = 0; i < 3; ++i)
    for (const double sign : {1., -1.})
    {
      Point<3> x;
      x[i] = sign;
      cells.vertices.push_back(x);
    }
  // Vertex 2 i + s is at (-1)^s along axis i.
  for (unsigned int k = 0; k < 8; ++k)
  {
    const unsigned int a = k % 2, b = 2 + k / 2 % 2, c = 4 + k / 4;
    const bool is_right = (k % 2 + k / 2 % 2 + k / 4) % 2 == 0;
    cells.add_face(is_right ? std::vector<unsigned int>{a, b, c}
                            : std::vector<unsigned int>{a, c, b});
  }
  cells.end_cell();
  return Packing<3>(cells);
}

template <typename Generator>
void check_generator(const std::string &name, const std::string &settings = "")
{
  check_field("A uniform stress in a " + name,
              Packing<3>(generated<Generator>(settings)), Field());
}

void run()
{
  check_field("A uniform stress in random cells",
              cells_in_box(3000, {1., 1., 1.}, 3), Field());
  check_generator<SpaceWallGenerator>("wall of bricks");
  check_generator<BuildingGenerator>("building",
                                     "set Width = 3\nset Brick length = 0.5");
  check_generator<ColumnGenerator>("column");
  check_generator<StairsGenerator>("flight of stairs");
  check_generator<VaultGenerator>("vault");
  check_generator<DomeGenerator>("dome");
  check_generator<CrossVaultGenerator>("cross vault");
  check_field("A linear stress in random cells",
              cells_in_box(200, {1., 1., 1.}, 3), linear_field());
  check_field("A linear stress in prisms",
              Packing<3>(extruded(random_packing(40, 5))), linear_field());
  check_field("A uniform stress in an octahedron", octahedron(), Field());
  check_field("A linear stress in an octahedron", octahedron(), linear_field());
  // Whose bricks meet two others above and below.
  check_field("A uniform stress in a wall", Packing<3>(brick_wall(3, 2, 4)),
              Field());
  column();
  bending();
}

const RoomTest test("space_stress", run);
} // namespace test_space_stress
