// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_polygon_list_h
#define voussoir_packing_polygons_polygon_list_h

#include <voussoir/packing/packing.h>
#include <voussoir/packing/polygons/drawing_faults.h>

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
    /** True if it has a fault that makes no cell of it. */
    bool is_broken = false;
    /**
     * True if it was drawn from its first vertex to its last one and not back;
     * see close_rings().
     */
    bool is_open = false;
    /** True if it is a line, which need not bound a cell by itself. */
    bool is_line = false;
    /**
     * What arcs bulge: for the side from each vertex to the next the tangent of
     * a quarter of the angle that it turns by, positive if to the left, and
     * zero if it is straight. Empty if all are; see replace_arcs().
     */
    std::vector<double> bulges = {};
    /** What else tells of the record, as "layer 'pier', handle 2A". */
    std::string detail = {};

    /** True if it has an area that can be shown. */
    bool is_drawable() const;
    /** True if all coordinates are. */
    bool is_finite() const;
    /** The number of sides: one less than vertices if it is open. */
    std::size_t n_sides() const { return ring.size() - (is_open ? 1 : 0); }
    /** The vertex behind the side that begins at vertex @p i; a length. */
    const dealii::Point<2> &end_of_side(const std::size_t i) const
    {
      return ring[(i + 1) % ring.size()];
    }
  };

  /** The file that they were read from. */
  std::filesystem::path file;
  /** The name of a record of the file: a line, or a feature of a drawing. */
  std::string record_name = "line";
  /** In the order of the file. */
  std::vector<Polygon> polygons;
  /** Notices to the user on how the file was understood. */
  std::vector<std::string> notices;
  /** What is wrong, so that one run can tell of all of it. */
  std::vector<DrawingFault> faults;

  /**
   * That @p cell, which is in @p record, has the @p fault, such as "Cell 2
   * (line 3 of 'wall.wkt') is not closed".
   *
   * @param detail of the record, as Polygon::detail.
   */
  DrawingFault fault(DrawingFault::Kind kind,
                     unsigned int cell,
                     unsigned int record,
                     const std::string &fault,
                     const std::string &detail = {}) const;
  /** That of a cell in the list. */
  DrawingFault fault(const DrawingFault::Kind kind,
                     const unsigned int cell,
                     const std::string &what) const
  {
    return fault(kind, cell, polygons[cell].record, what,
                 polygons[cell].detail);
  }
  /**
   * The record of a cell, as "feature 3, layer 'pier', handle 2A", or "feature
   * 3 of 'wall.dxf', layer 'pier', handle 2A".
   */
  std::string record_of(unsigned int cell, bool with_file = false) const;
  /** Throw the same of a cell in the list. */
  [[noreturn]] void refuse(const DrawingFault::Kind kind,
                           const unsigned int cell,
                           const std::string &what) const
  {
    throw fault(kind, cell, what);
  }

  /** Keep the fault that @p check throws; false if it does. */
  template <typename Check>
  bool passes(const Check &check)
  {
    try
    {
      check();
    }
    catch (const DrawingFault &found)
    {
      faults.push_back(found);
      return false;
    }
    return true;
  }

  /** @throws DrawingRefused if there are faults. */
  void refuse_faults() const;

private:
  /** As record_of(), of a record with this detail. */
  std::string
  named(unsigned int record, const std::string &detail, bool with_file) const;
};

/** The rings of all polygons that are not broken, each different point once. */
CellLoops loops_of(const PolygonList &polygons);

/** Find the names of groups that cannot be used. */
void check_group_names(PolygonList &polygons);

/**
 * Let cells, made of the polygons in their order, belong to the groups of these
 * and know the file and its records, and take over the notices.
 */
void hand_on_records(const PolygonList &polygons, CellLoops &cells);

/**
 * The text of a file of polygons.
 *
 * @throws InputError if the file cannot be read, or is in UTF-16.
 */
std::string read_polygon_text(const std::filesystem::path &file);
} // namespace Voussoir

#endif
