// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/vtu.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/grid/reference_cell.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
using dealii::DataComponentInterpretation::component_is_part_of_tensor;
using dealii::DataComponentInterpretation::component_is_part_of_vector;
using Interpretation =
    dealii::DataComponentInterpretation::DataComponentInterpretation;

/**
 * A grid of patches, one per line or quadrilateral, with values that are
 * constant in each patch.
 */
template <int dim>
class ConstantPatches
{
public:
  explicit ConstantPatches(const unsigned int n_patches) : patches(n_patches)
  {
  }

  void add_scalar(const std::string &name)
  {
    names.push_back(name);
  }

  void add_vector(const std::string &name)
  {
    add_range(name, 2, component_is_part_of_vector);
  }

  void add_tensor(const std::string &name)
  {
    add_range(name, 4, component_is_part_of_tensor);
  }

  /** Set patch @p i; the values in the order in which they were added. */
  template <typename Corners>
  void set(const unsigned int i,
           const Corners &corners,
           const std::vector<double> &values)
  {
    AssertDimension(values.size(), names.size());
    auto &patch = patches[i];
    std::copy(std::begin(corners), std::end(corners), patch.vertices);
    patch.patch_index = i;
    patch.n_subdivisions = 1;
    patch.reference_cell = dealii::ReferenceCells::get_hypercube<dim>();
    const unsigned int n_points = dealii::GeometryInfo<dim>::vertices_per_cell;
    patch.data.reinit(values.size(), n_points);
    for (unsigned int v = 0; v < values.size(); ++v)
      for (unsigned int p = 0; p < n_points; ++p)
        patch.data(v, p) = values[v];
  }

  void write(std::ostream &out) const
  {
    dealii::DataOutBase::VtkFlags flags;
    flags.print_date_and_time = false; // the same run gives the same file
    flags.compression_level = dealii::DataOutBase::VtkFlags::best_speed;
    dealii::DataOutBase::write_vtu(patches, names, ranges, flags, out);
  }

private:
  void add_range(const std::string &name,
                 const unsigned int n_components,
                 const Interpretation interpretation)
  {
    const unsigned int first = names.size();
    names.insert(names.end(), n_components, name);
    ranges.emplace_back(first, first + n_components - 1, name, interpretation);
  }

  std::vector<dealii::DataOutBase::Patch<dim, 2>> patches;
  std::vector<std::string> names;
  std::vector<
      std::tuple<unsigned int, unsigned int, std::string, Interpretation>>
      ranges;
};
} // namespace

void write_stress_vtu(std::ostream &out, const Results &results)
{
  const Packing &packing = results.scene.packing;
  const SubTriangulation &cut = results.stress.cut;
  ConstantPatches<2> grid(results.stress.sub_cells.size());
  grid.add_tensor("stress");
  grid.add_scalar("principal_stress_1");
  grid.add_scalar("principal_stress_2");
  grid.add_scalar("von_mises");
  grid.add_scalar("skew");
  grid.add_vector("div");
  grid.add_scalar("cell");
  grid.add_scalar("group");
  grid.add_vector("displacement");
  grid.add_scalar("reconstructed");

  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    const Tensor<1, 2> &u = results.displacement[c];
    const bool reconstructed =
        !std::binary_search(results.stress.undetermined.begin(),
                            results.stress.undetermined.end(), c);
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
      for (unsigned int k = 0; k < cut.of_triangle().size(); ++k)
      {
        const unsigned int number = results.stress.first(packing, c, i) + k;
        const SubCellStress &sub_cell = results.stress.sub_cells[number];
        const Tensor<2, 2> &s = sub_cell.stress;

        // Principal stresses of the symmetric part, by Mohr's circle.
        const double mean = 0.5 * (s[0][0] + s[1][1]);
        const double radius =
            std::hypot(0.5 * (s[0][0] - s[1][1]), 0.5 * (s[0][1] + s[1][0]));
        grid.set(number,
                 cut.corners(k, packing.centre(c), packing.vertex(c, i),
                             packing.vertex(c, i + 1)),
                 {s[0][0], s[0][1], s[1][0], s[1][1], mean + radius,
                  mean - radius, std::sqrt(mean * mean + 3. * radius * radius),
                  sub_cell.skew, sub_cell.divergence[0], sub_cell.divergence[1],
                  double(c), double(packing.group(c)), u[0], u[1],
                  double(reconstructed)});
      }
  }
  grid.write(out);
}

void write_interfaces_vtu(std::ostream &out, const Results &results)
{
  const Scene &scene = results.scene;
  const auto &interfaces = scene.packing.interfaces();
  const bool marked = !results.never_pressed.empty();
  ConstantPatches<1> grid(interfaces.size());
  for (const char *name : {"normal_force", "tangential_force", "normal_stress",
                           "tangential_stress", "strength", "utilisation",
                           "cell_minus", "cell_plus"})
    grid.add_scalar(name);
  if (marked)
    for (const char *name : {"never_pressed", "always_sliding"})
      grid.add_scalar(name);

  for (unsigned int e = 0; e < interfaces.size(); ++e)
  {
    const Packing::Interface &i = interfaces[e];
    const bool is_support = i.cell_plus == scene.packing.ground();
    const double normal = results.forces.normal[e];
    const double tangential = results.forces.tangential[e];
    std::vector<double> values = {normal,
                                  tangential,
                                  normal / i.length,
                                  tangential / i.length,
                                  scene.strength[e],
                                  utilisation(scene, results.forces, e),
                                  double(i.cell_minus),
                                  is_support ? -1. : double(i.cell_plus)};
    if (marked)
      values.insert(values.end(), {double(results.never_pressed[e]),
                                   double(results.always_sliding[e])});
    grid.set(e, std::array<Point<2>, 2>{{i.start, i.end}}, values);
  }
  grid.write(out);
}

void write_mechanism_vtu(std::ostream &out, const Collapse &collapse)
{
  const Packing &packing = collapse.scene.packing;
  ConstantPatches<2> grid(packing.first_side(packing.n_cells()));
  grid.add_vector("displacement");
  grid.add_scalar("cell");

  const SubTriangulation fan = SubTriangulation::fan();
  const double largest = std::sqrt(packing.area() / packing.n_cells());
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    const Tensor<1, 2> u = largest * collapse.displacement[c];
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
      grid.set(packing.first_side(c) + i,
               fan.corners(0, packing.centre(c) + u, packing.vertex(c, i) + u,
                           packing.vertex(c, i + 1) + u),
               {u[0], u[1], double(c)});
  }
  grid.write(out);
}
} // namespace Voussoir
