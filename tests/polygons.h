// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_tests_polygons_h
#define voussoir_tests_polygons_h

#include <voussoir/packing/packing.h>
#include <voussoir/packing/polygons/facing_sides.h>
#include <voussoir/packing/polygons/polygon_list.h>
#include <voussoir/packing/polygons/polygons.h>

#include <fstream>
#include <string>
#include <utility>
#include <vector>

// What the tests of files of polygons share.

/** Write @p content to the file @p name. */
inline void write_file(const std::string &name, const std::string &content)
{
  std::ofstream(name, std::ios::binary) << content;
}

/** The cells of a file; further parameters as pairs of name and value. */
inline Voussoir::CellLoops imported_cells(
    const std::string &file,
    const std::vector<std::pair<std::string, std::string>> &parameters = {})
{
  Voussoir::PolygonGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.set("File", file);
  for (const auto &[name, value] : parameters)
    prm.set(name, value);
  return generator.generate("", Voussoir::Terminal::silent());
}

/** Polygons by their vertices, as if a file had them line by line. */
inline Voussoir::PolygonList
list_of(const std::vector<std::vector<dealii::Point<2>>> &rings)
{
  Voussoir::PolygonList polygons;
  polygons.file = "drawing.wkt";
  for (const auto &ring : rings)
    polygons.polygons.push_back(
        {ring, "", static_cast<unsigned int>(polygons.polygons.size() + 1)});
  return polygons;
}

/** Polygons that are joined over gaps up to @p width, as a file's would be. */
inline Voussoir::Packing<2>
joined(const std::vector<std::vector<dealii::Point<2>>> &rings,
       const double width,
       const double tolerance = 1e-10)
{
  constexpr double fifteen_degrees = 0.2617993877991494;
  Voussoir::PolygonList polygons = list_of(rings);
  return Voussoir::Packing<2>(Voussoir::join_facing_sides(
      polygons, {width, fifteen_degrees, tolerance}));
}

/** A rectangle of b times h with its lower left corner at (x, y). */
inline std::vector<dealii::Point<2>>
rectangle(const double x, const double y, const double b, const double h)
{
  return {{x, y}, {x + b, y}, {x + b, y + h}, {x, y + h}};
}

/** The number of cells, interfaces and boundary edges that are expected. */
struct Counts
{
  unsigned int n_cells;
  unsigned int n_interfaces;
  unsigned int n_boundary_edges;
};

inline bool has_counts(const Voussoir::Packing<2> &packing,
                       const Counts &counts)
{
  return packing.n_cells() == counts.n_cells &&
         packing.interfaces().size() == counts.n_interfaces &&
         packing.boundary_edges().size() == counts.n_boundary_edges;
}

#endif
