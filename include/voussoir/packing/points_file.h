// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_points_file_h
#define voussoir_packing_points_file_h

#include <deal.II/base/point.h>

#include <filesystem>
#include <string>
#include <vector>

namespace Voussoir
{
/** Points and, for messages, where each was given. */
template <int dim>
struct PointList
{
  /** In the order of the file; lengths. */
  std::vector<dealii::Point<dim>> points;
  /** The line of the file that each point stands in; empty if generated. */
  std::vector<unsigned int> lines;
  /** The file; empty if generated. */
  std::filesystem::path file;

  /** "Point 3 at (0.5, 1)", with line and file where there is one. */
  std::string describe(unsigned int i) const;
};

/**
 * Read a points file: one point "x y", or in space "x y z", a line, separated
 * by spaces, tabs, a comma or a semicolon; empty lines, and what follows a #,
 * are skipped.
 *
 * @throws InputError naming the line if the file cannot be read, a line is
 *   not as many finite numbers, or there is no point.
 */
template <int dim>
PointList<dim> read_points_file(const std::filesystem::path &file);
} // namespace Voussoir

#endif
