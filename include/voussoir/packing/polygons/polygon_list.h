// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_polygon_list_h
#define voussoir_packing_polygons_polygon_list_h

#include <voussoir/packing/packing.h>

#include <filesystem>
#include <string>
#include <vector>

namespace Voussoir
{
/** Polygons as they stand in a file; cell c of the packing is polygon c. */
struct PolygonList
{
  /** One polygon, which is to be a cell. */
  struct Polygon
  {
    /** The vertices in order, the first not repeated at the end; lengths. */
    std::vector<dealii::Point<2>> ring;
    /** The name of the group of cells that it belongs to; empty if none. */
    std::string group;
    /** The record of the file that it comes from, counted from one. */
    unsigned int record;
  };

  /** The file that they were read from. */
  std::filesystem::path file;
  /** The name of a record of the file: a line, or a feature of a drawing. */
  std::string record_name = "line";
  /** In the order of the file. */
  std::vector<Polygon> polygons;
  /** Notices to the user on how the file was understood. */
  std::vector<std::string> notices;

  /**
   * Throw the InputError that @p cell, which is in @p record, has the @p fault,
   * such as "Cell 2 (line 3 of 'wall.wkt') is not closed".
   */
  [[noreturn]] void refuse(unsigned int cell,
                           unsigned int record,
                           const std::string &fault) const;
  /** The same of a cell in the list. */
  [[noreturn]] void refuse(const unsigned int cell,
                           const std::string &fault) const
  {
    refuse(cell, polygons[cell].record, fault);
  }
};

/**
 * Let cells, made of the polygons in their order, belong to the groups of these
 * and know the file and its records, and take over the notices.
 *
 * @throws InputError naming the cell if a group has an impossible name.
 */
void hand_on_records(const PolygonList &polygons, CellLoops &cells);

/**
 * The text of a file of polygons, without the byte order mark that some
 * programs put first.
 *
 * @throws InputError if the file cannot be read.
 */
std::string read_polygon_text(const std::filesystem::path &file);
} // namespace Voussoir

#endif
