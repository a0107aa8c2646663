// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_polygons_h
#define voussoir_packing_polygons_polygons_h

#include <voussoir/packing/generators/generator.h>
#include <voussoir/packing/polygons/drawn_lines.h>
#include <voussoir/packing/polygons/layer_choice.h>
#include <voussoir/packing/polygons/polygon_list.h>

#include <optional>
#include <utility>

namespace Voussoir
{
/**
 * Cells that were drawn or computed by another program: each polygon of a file
 * is a cell, in the order of the file. Cells that touch become neighbours; see
 * match_polygons(), and join_facing_sides() for those that are drawn apart.
 */
class PolygonGenerator : public PackingGenerator<2>
{
public:
  std::string name() const override { return "polygons"; }
  std::string meaning() const override { return "the polygons of a file."; }
  void add_parameters(dealii::ParameterHandler &prm) override;
  CellLoops generate(const std::filesystem::path &directory,
                     Terminal &terminal) const override;
  std::vector<std::filesystem::path>
  input_files(const std::filesystem::path &directory) const override;
  /** Take @p polygons from now on, and no file. */
  void give(PolygonList polygons) { given = std::move(polygons); }

private:
  /** What the file has, as it is drawn. */
  PolygonList read(const std::filesystem::path &directory) const;
  /** Make rings of straight sides of it, in the unit of the scene. */
  void make_rings(PolygonList &polygons) const;

  std::optional<PolygonList> given;
  std::string file;
  std::string centres_file;
  double scale = 1.;
  std::string layers, layer_groups;
  OpenLines lines = OpenLines::refuse;
  double arc_tolerance = 0.;
  double tolerance = 0.;
  double joint_width = 0.;
  double joint_angle = 15.;
};

/**
 * Read a file in the format that the extension of its name tells: .wkt and .txt
 * by read_wkt_file(), .off by read_off_file(), all else by read_ogr_file().
 *
 * @throws InputError also if @p layers asks for some of a file without layers.
 */
PolygonList read_polygons(const std::filesystem::path &file,
                          const LayerChoice &layers = {});
} // namespace Voussoir

#endif
