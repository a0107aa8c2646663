// SPDX-License-Identifier: LGPL-2.1-or-later

// Blocks that turn. A uniform symmetric stress comes back, in every interface,
// with the same force at both ends, and in every sub-cell. Under their weight,
// and tractions that vary along an edge, the mean stress of each block is
// symmetric, the forces on the cells cut free have the same one, and the
// refined stress has div sigma = -b.

#include <voussoir/base/geometry.h>
#include <voussoir/scene/supports.h>
#include <voussoir/stress/cell_means.h>
#include <voussoir/stress/reconstruction.h>

#include "tests.h"

namespace test_couples_in_scenes
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

const Reconstruction standard = {};
const Reconstruction fine = {true, 0, 0};

void compare_uniform(const Tensor<2, 2> &S, const unsigned int seed)
{
  const Scene scene =
      scene_under_stress(random_packing(200, seed), 10., S, rotations());
  Solver solver(least_energy, 1e-12);
  const InterfaceForces forces = solver.forces(scene);
  double difference = 0.;
  for (unsigned int e = 0; e < forces.at_ends.size(); ++e)
    difference = std::max(
        difference, std::abs(forces.at_ends[e][0] - forces.at_ends[e][1]) /
                        scene.packing.interfaces()[e].length);
  check_error("uniform, interfaces", distance_from_uniform(scene, forces, S),
              1e-9);
  check_error("uniform, both ends", difference, 1e-9);
  for (const Reconstruction &how : {standard, fine})
  {
    const StressField field =
        reconstruct_stress(scene, forces, how, solver.quiet);
    double error = field.undetermined.size();
    for (const SubCellStress &sub_cell : field.sub_cells)
      error = std::max(error, (sub_cell.stress - S).norm());
    check_error(how.is_refined ? "uniform, fine" : "uniform, standard", error,
                1e-9);
  }
}

/** On the ground, under weight and a traction on top that grows with x. */
/** The weight, linear in x and y if @p slope is not zero. */
Tensor<1, 2> weight(const Point<2> &x, const double slope)
{
  return Tensor<1, 2>(
      {slope * (0.3 * x[0] - 0.2 * x[1]), -2. - slope * (x[0] + 2. * x[1])});
}

Scene on_the_ground(Packing<2> packing,
                    const double strength,
                    const double slope = 0.)
{
  packing.support(boundary_edges_where(packing, "y < 1e-9", "Supports/Where"));
  Loads loads;
  for (const auto &edge : packing.boundary_edges())
  {
    // (x / 2, -x) there, and its first moment.
    const double is_top = edge.midpoint()[1] > 1. - 1e-9 ? 1. : 0.;
    const Tensor<1, 2> slope({0.5 * is_top, -is_top});
    loads.traction.push_back(edge.midpoint()[0] * slope);
    loads.traction_moment.push_back(edge.length * edge.length / 12. *
                                    (edge.end - edge.start)[0] * slope);
  }
  loads.body = BodyForce(packing, [=](const Point<2> &x, unsigned int) {
    return weight(x, slope);
  });
  const std::vector<double> strengths(packing.interfaces().size(), strength);
  return Scene(std::move(packing), strengths, std::move(loads), rotations());
}

/** Cell @p c cut free. */
LoadedCell
cut_free(const Scene &scene, const CellForces &forces, const unsigned int c)
{
  LoadedCell cell;
  cell.centre = scene.packing.centre(c);
  for (unsigned int i = 0; i < scene.packing.n_sides(c); ++i)
  {
    const unsigned int side = scene.packing.first_side(c) + i;
    cell.vertices.push_back(scene.packing.vertex(c, i));
    cell.forces.push_back(forces.on_side[side]);
    cell.body_forces.push_back(forces.body[side]);
    cell.shifts.push_back(forces.shift_on_side[side]);
  }
  return cell;
}

/** The mean of a linear function in a quadrilateral, by its two triangles. */
Tensor<1, 2> mean_weight(const std::array<Point<2>, 4> &corners,
                         const double slope)
{
  double whole = 0.;
  Tensor<1, 2> mean;
  for (const unsigned int m : {1U, 2U})
  {
    const double area =
        std::abs(cross(corners[m] - corners[0], corners[3] - corners[0]));
    const Point<2> centroid(
        (Tensor<1, 2>(corners[0]) + corners[m] + corners[3]) / 3.);
    mean += area * weight(centroid, slope);
    whole += area;
  }
  return mean / whole;
}

/** The root mean square of div sigma + b in a cell; the largest one. */
double error_of_divergence(const Scene &scene,
                           const InterfaceForces &forces,
                           const double slope = 0.)
{
  const StressField field =
      reconstruct_stress(scene, forces, fine, Terminal::silent());
  const Packing<2> &packing = scene.packing;
  const unsigned int per_side = field.cut.of_triangle().size();
  double largest = field.undetermined.size();
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    double square = 0.;
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
      for (unsigned int k = 0; k < per_side; ++k)
      {
        const auto corners =
            field.cut.corners(k, packing.centre(c), packing.vertex(c, i),
                              packing.vertex(c, (i + 1) % packing.n_sides(c)));
        const SubCellStress &sub_cell =
            field.sub_cells[field.first(packing, c, i) + k];
        const double area =
            0.5 * cross(corners[3] - corners[0], corners[2] - corners[1]);
        square +=
            area *
            (sub_cell.divergence + mean_weight(corners, slope)).norm_square();
      }
    largest = std::max(largest, std::sqrt(square / packing.area(c)));
  }
  return largest;
}

void compare_balance(const std::string &name, const Scene &scene)
{
  Solver solver(least_energy, 1e-12);
  const InterfaceForces forces = solver.forces(scene);
  const auto means = cell_mean_stresses(scene, forces);
  const CellForces on_cells =
      cell_forces(scene, forces, all_cells(scene.packing));
  double size = 0., skew = 0., difference = 0.;
  for (unsigned int c = 0; c < means.size(); ++c)
  {
    size = std::max(size, means[c].norm());
    skew = std::max(skew, std::abs(means[c][0][1] - means[c][1][0]));
    difference = std::max(difference,
                          (means[c] - cut_free(scene, on_cells, c).moments() /
                                          scene.packing.area(c))
                              .norm());
  }
  check_error(name + ": skew part of the means", skew / size, 1e-12);
  check_error(name + ": means of the cells cut free", difference / size, 1e-13);

  check_error(name + ": div sigma + b", error_of_divergence(scene, forces),
              1e-9);
  // Without couples there is a torque that is not balanced.
  InterfaceForces at_midpoints = forces;
  at_midpoints.at_ends.clear();
  check(name + ": not so without the couples",
        error_of_divergence(scene, at_midpoints) > 0.1);
}

/** A weight that varies is known by its mean in each triangle. */
void compare_linear(const std::string &name, const Packing<2> &packing)
{
  const double slope = 1.;
  const Scene scene = on_the_ground(packing, 100., slope);
  const InterfaceForces forces = Solver(least_energy, 1e-12).forces(scene);
  check_error(name + ": div sigma + b, b linear",
              error_of_divergence(scene, forces, slope) /
                  weight({1., 1.}, slope).norm(),
              0.02);
}

void run()
{
  compare_uniform(tensor(-1., 0.3, 0.3, -1.2), 4);
  compare_uniform(tensor(-1., 0., 0., -0.1), 5);
  compare_uniform(tensor(-0.6, -0.5, -0.5, -0.5), 6);
  compare_uniform(tensor(-1., 0., 0., -1.), 7);
  compare_balance("random cells", on_the_ground(random_packing(100, 3), 5.));
  compare_balance("wall", on_the_ground(wall(8, 4), 5.));
  compare_linear("random cells", random_packing(100, 3));
  compare_linear("wall", wall(8, 4));
}

const RoomTest test("couples_in_scenes", run);
} // namespace test_couples_in_scenes
