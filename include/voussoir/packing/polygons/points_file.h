// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_points_file_h
#define voussoir_packing_polygons_points_file_h

#include <deal.II/base/point.h>

#include <filesystem>
#include <vector>

namespace Voussoir
{
/** Points and, for messages, where each was given. */
struct PointList
{
  /** In the order of the file; lengths. */
  std::vector<dealii::Point<2>> points;
  /** The line of the file that each point stands in; empty if generated. */
  std::vector<unsigned int> lines;
  /** The file; empty if generated. */
  std::filesystem::path file;

  /** "Point 3 at (0.5, 1)", with line and file where there is one. */
  std::string describe(unsigned int i) const;
};

/**
 * Read a points file: one point "x y" a line, separated by spaces, tabs, a
 * comma or a semicolon; empty lines, and what follows a #, are skipped.
 *
 * @throws InputError naming the line if the file cannot be read, a line is
 *   not two finite numbers, or there is no point.
 */
PointList read_points_file(const std::filesystem::path &file);
} // namespace Voussoir

#endif
