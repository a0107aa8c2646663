// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_voronoi_point_entries_h
#define voussoir_packing_voronoi_point_entries_h

#include <voussoir/packing/cells.h>
#include <voussoir/packing/points_file.h>
#include <voussoir/packing/voronoi/cell_size.h>
#include <voussoir/terminal/terminal.h>

#include <deal.II/base/parameter_handler.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/** The entries on the points of Voronoi cells, and what is done with them. */
template <int dim>
class PointEntries
{
public:
  /** Declare them in the current section and bind them. */
  void add_parameters(dealii::ParameterHandler &prm);

  /** The files that are read. */
  std::vector<std::filesystem::path>
  input_files(const std::filesystem::path &directory) const;

  /**
   * The size that cells are wanted to have.
   *
   * @throws InputError if the formula cannot be parsed.
   */
  CellSize<dim> cell_size() const;

  /**
   * The points of the file, if they are from one; else none, and random_count()
   * of them are to be drawn with random_seed().
   *
   * @throws InputError as read_points_file() does, or if no file is named.
   */
  std::optional<PointList<dim>>
  given_points(const std::filesystem::path &directory) const;
  /** The number of points to draw. */
  unsigned int random_count() const { return n_points; }
  /** The seed to draw them with. */
  unsigned int random_seed() const { return seed; }

  /**
   * The cells of points that are moved by the Lloyd steps that are asked for.
   *
   * @param cells_of makes cells of points.
   * @param centroids_of gives the points of the next step.
   */
  Cells<dim> relaxed_cells(
      PointList<dim> points,
      const std::function<Cells<dim>(const PointList<dim> &)> &cells_of,
      const std::function<std::vector<dealii::Point<dim>>(const Cells<dim> &)>
          &centroids_of,
      Terminal &terminal) const;

private:
  bool reads_points = false;
  std::string points_file;
  unsigned int n_points = 100;
  unsigned int seed = 1;
  std::string size_formula = "1";
  unsigned int n_lloyd_steps = 0;
};
} // namespace Voussoir

#endif
