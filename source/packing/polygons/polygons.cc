// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/points_file.h>
#include <voussoir/packing/polygons/arc_chords.h>
#include <voussoir/packing/polygons/facing_sides.h>
#include <voussoir/packing/polygons/joint_checks.h>
#include <voussoir/packing/polygons/line_work.h>
#include <voussoir/packing/polygons/matching.h>
#include <voussoir/packing/polygons/polygon_checks.h>
#include <voussoir/packing/polygons/polygons.h>
#include <voussoir/packing/polygons/readers.h>

#include <deal.II/base/numbers.h>

#include <boost/algorithm/string/case_conv.hpp>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
constexpr double radians_per_degree = dealii::numbers::PI / 180.;

void multiply(std::vector<dealii::Point<2>> &points, const double scale)
{
  for (dealii::Point<2> &x : points)
    x *= scale;
}

/** Refuse a choice of layers where there are none. */
void check_has_layers(const LayerChoice &layers, const std::string &polygons)
{
  if (layers.asks())
    throw InputError("'Packing/polygons/Layers' and 'Layer groups' choose "
                     "layers of a drawing, and " +
                     polygons +
                     " no layers: leave both empty, or give a file that GDAL "
                     "reads, such as DXF.");
}
} // namespace

void PolygonGenerator::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  prm.add_parameter(
      "File", file,
      "The file of the polygons, each a cell: WKT if its name ends in .wkt or "
      ".txt, OFF if in .off, otherwise a format of drawings that GDAL reads, "
      "such as DXF, GeoJSON, GeoPackage and Shapefile. A relative path starts "
      "at the directory of the .prm file.",
      Anything());
  prm.add_parameter(
      "Scale", scale,
      "What all coordinates of the file and of the centres file are multiplied "
      "by as they are read: 0.001 for a drawing in mm and loads with m. All "
      "other lengths, and those in messages, are the scaled ones.",
      Double());
  prm.add_parameter(
      "Layers", layers,
      "The layers of a drawing that are read, \"pier, arch *\": names with the "
      "wildcards *, ? and [abc], upper and lower case told apart. For files "
      "that GDAL reads, whose layers are those of DXF or tables. Empty: all.",
      Anything());
  prm.add_parameter(
      "Layer groups", layer_groups,
      "The groups of the cells on some of these layers, \"arch ?: voussoir | "
      "pier: abutment\", of which the first that fits counts. On other layers "
      "a cell has the group that its field 'group' or 'name' says, and in DXF "
      "its layer.",
      Anything());
  add_open_lines(prm, lines);
  prm.add_parameter(
      "Arc tolerance", arc_tolerance,
      "How far the chords that arcs of a drawing are replaced by may be from "
      "them, a length after 'Scale': there are as few as that allows, none of "
      "more than a right angle. An arc is cut where vertices of others lie on "
      "it, and neighbours along it have the same vertices, whichever way each "
      "was drawn. 0: a thousandth of the mean size of what is drawn, the "
      "diagonal of the box around a line.",
      Double(0.));
  prm.add_parameter(
      "Matching tolerance", tolerance,
      "Vertices and sides no further apart than this length touch, and move "
      "together; wider gaps stay open and carry nothing, and deeper overlaps "
      "are errors. A line whose ends are no further apart is closed. For what "
      "a drawing was rounded to: a move of more than a "
      "thousandth of the mean size of a cell is an error. 0: 1e-10 of that "
      "size, or 16 units of rounding of the largest coordinate if that is "
      "more.",
      Double(0.));
  prm.add_parameter(
      "Joint width", joint_width,
      "The widest joint, drawn as a gap between blocks that keep their shapes: "
      "sides that face each other no further apart than this length touch, and "
      "their forces act midway between them. Nothing is joined through a block "
      "or a narrower joint. A length of the scene, after 'Scale'; more than "
      "two thirds of the mean size of a block, the root of its area, is an "
      "error. "
      "Overlaps up to 'Matching tolerance' are joints, too. 0: blocks touch "
      "where they share their sides, within 'Matching tolerance'.",
      Double(0.));
  prm.add_parameter(
      "Joint angle", joint_angle,
      "The largest angle between two sides that face each other across a "
      "joint, in degrees; see 'Joint width'.",
      Double(0., 45.));
  prm.add_parameter(
      "Centres file", centres_file,
      "A file with the centre \"x y\" of one cell a line, in the order of the "
      "cells, on which the least energy formulation depends; empty: the "
      "centroids. A relative path starts at the directory of the .prm file.",
      Anything());
}

PolygonList PolygonGenerator::read(const std::filesystem::path &directory) const
{
  if (file.empty() && !given)
    throw InputError("'Packing/Generator' is 'polygons', but 'Packing/polygons/"
                     "File' names no file.");
  if (!(scale > 0. && std::isfinite(scale)))
    throw InputError(text("'Packing/polygons/Scale' = '", scale,
                          "' must be a positive number: that which makes "
                          "lengths of the drawing those of the scene."));
  const LayerChoice choice(layers, layer_groups);
  if (!given)
    return read_polygons((directory / file).lexically_normal(), choice);
  check_has_layers(choice, given->file.string() + " have");
  return *given;
}

void PolygonGenerator::make_rings(PolygonList &polygons) const
{
  for (PolygonList::Polygon &polygon : polygons.polygons)
    multiply(polygon.ring, scale);
  const double touching =
      tolerance > 0. ? tolerance : drawn_tolerance(polygons);
  close_rings(polygons, touching, lines);
  replace_arcs(polygons, arc_tolerance, touching);
  if (lines == OpenLines::join)
    join_lines(polygons, touching);
}

CellLoops PolygonGenerator::generate(const std::filesystem::path &directory,
                                     Terminal &) const
{
  PolygonList polygons = read(directory);
  make_rings(polygons);
  check_and_orient(polygons);
  const double used_tolerance =
      tolerance > 0. ? tolerance : automatic_tolerance(polygons);
  const GapLimits gap_limits =
      limits_of_gaps(polygons, used_tolerance, joint_width);
  check_tolerance(polygons, used_tolerance);
  check_overlaps(polygons, used_tolerance);
  check_group_names(polygons);
  if (polygons.faults.size() > 1)
    look_around(polygons, gap_limits);
  polygons.refuse_faults();
  if (joint_width > 0.)
    check_joint_width(polygons, joint_width, scale);
  CellLoops cells =
      joint_width > 0.
          ? join_facing_sides(
                polygons,
                {joint_width, joint_angle * radians_per_degree, used_tolerance})
          : match_polygons(polygons, used_tolerance);
  hand_on_records(polygons, cells);
  cells.gaps = find_gaps(cells, gap_limits);
  if (!cells.gaps.empty())
    cells.notices.push_back(describe_gaps(cells.gaps));
  if (centres_file.empty())
    return cells;
  cells.centres =
      read_points_file<2>((directory / centres_file).lexically_normal()).points;
  multiply(cells.centres, scale);
  if (cells.centres.size() != cells.n_cells())
    throw InputError(
        text("The centres file '",
             (directory / centres_file).lexically_normal().string(), "' has ",
             cells.centres.size(), " points, but '", polygons.file.string(),
             "' has ", cells.n_cells(),
             " cells; each cell needs one centre, in the same order."));
  return cells;
}

std::vector<std::filesystem::path>
PolygonGenerator::input_files(const std::filesystem::path &directory) const
{
  std::vector<std::filesystem::path> files;
  for (const std::string &name : {file, centres_file})
    if (!name.empty())
      files.push_back(directory / name);
  return files;
}

PolygonList read_polygons(const std::filesystem::path &file,
                          const LayerChoice &layers)
{
  const std::string extension = boost::to_lower_copy(file.extension().string());
  const bool is_wkt = extension == ".wkt" || extension == ".txt";
  if (!is_wkt && extension != ".off")
    return read_ogr_file(file, layers);
  check_has_layers(layers, "'" + file.string() + "' has");
  return is_wkt ? read_wkt_file(file) : read_off_file(file);
}
} // namespace Voussoir
