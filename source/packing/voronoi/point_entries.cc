// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/voronoi/point_entries.h>

#include <utility>

namespace Voussoir
{
namespace
{
/** As many as have sides, or corners of faces, that 32 bits can number. */
template <int dim>
constexpr int most_points = dim == 2 ? 100000000 : 40000000;
} // namespace

template <int dim>
void PointEntries<dim>::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  add_choice<bool>(
      prm, "Points", reads_points,
      {{true, "file", "as given in 'Points file'.", "Points file"},
       {false, "random", "drawn at random, as densely as 'Cell size' asks.",
        "Number of points, Seed"}},
      "Where the points come from.");
  prm.add_parameter(
      "Points file", points_file,
      text("A file with one point \"", dim == 2 ? "x y" : "x y z",
           "\" a line; # begins a comment. A relative path starts at the "
           "directory of the .prm file."),
      Anything());
  prm.add_parameter("Number of points", n_points,
                    "Number of random points, which is that of the cells.",
                    Integer(1, most_points<dim>));
  prm.add_parameter("Seed", seed,
                    "Seed of the random points; the same seed gives the same "
                    "points on every machine.",
                    Integer(0));
  prm.add_parameter("Cell size", size_formula,
                    text("The size that cells are wanted to have, relative to "
                         "each other: a positive expression in ",
                         dim == 2 ? "x and y" : "x, y and z",
                         ", of which only ratios matter. It decides how "
                         "densely random points lie, and what Lloyd steps tend "
                         "to."),
                    Anything());
  prm.add_parameter("Lloyd steps", n_lloyd_steps,
                    text("How many times each point is moved to the centroid "
                         "of its cell, weighted by 'Cell size' to the power -",
                         dim + 2, "."),
                    Integer(0, 10000));
}

template <int dim>
std::vector<std::filesystem::path>
PointEntries<dim>::input_files(const std::filesystem::path &directory) const
{
  if (!reads_points || points_file.empty())
    return {};
  return {directory / points_file};
}

template <int dim>
CellSize<dim> PointEntries<dim>::cell_size() const
{
  return CellSize<dim>(size_formula, "Packing/Voronoi/Cell size");
}

template <int dim>
std::optional<PointList<dim>>
PointEntries<dim>::given_points(const std::filesystem::path &directory) const
{
  if (!reads_points)
    return {};
  if (points_file.empty())
    throw InputError("'Packing/Voronoi/Points' is 'file', but 'Packing/Voronoi/"
                     "Points file' names none.");
  return read_points_file<dim>((directory / points_file).lexically_normal());
}

template <int dim>
Cells<dim> PointEntries<dim>::relaxed_cells(
    PointList<dim> points,
    const std::function<Cells<dim>(const PointList<dim> &)> &cells_of,
    const std::function<std::vector<dealii::Point<dim>>(const Cells<dim> &)>
        &centroids_of,
    Terminal &terminal) const
{
  Cells<dim> cells = cells_of(points);
  for (unsigned int step = 0; step < n_lloyd_steps; ++step)
  {
    terminal.progress(step, n_lloyd_steps, "Lloyd steps");
    points.points = centroids_of(cells);
    cells = cells_of(points);
  }
  return cells;
}

template class PointEntries<2>;
template class PointEntries<3>;
} // namespace Voussoir
