// SPDX-License-Identifier: LGPL-2.1-or-later

// Files of polygons as Shapely, QGIS, PostGIS, CAD and GIS programs write them
// are read as the cells that they draw.

#include "polygons.h"
#include "tests.h"

#ifdef VOUSSOIR_WITH_GDAL
#include <voussoir/packing/polygons/gdal_library.h>

#include <ogrsf_frmts.h>
#endif

#include <filesystem>

using namespace Voussoir;

/** Two squares beside each other, in this order, that are groups a and b. */
bool is_pair_of_squares(const CellLoops &cells, const bool with_groups)
{
  const Packing<2> packing(cells);
  bool right = has_counts(packing, {2, 1, 6});
  right = right && std::abs(packing.interfaces()[0].length - 1.) < 1e-14 &&
          packing.interfaces()[0].normal[0] == 1. &&
          packing.centre(1).distance({1.5, 0.5}) < 1e-14;
  const std::vector<std::string> names = {"a", "b"};
  return right &&
         (with_groups ? cells.group_names == names &&
                            cells.group == std::vector<unsigned int>({0, 1})
                      : cells.group.empty());
}

void check_wkt(const std::string &what,
               const std::string &content,
               const bool with_groups = false,
               const std::string &file = "squares.wkt")
{
  write_file(file, content);
  const CellLoops cells = imported_cells(file);
  check(what, is_pair_of_squares(cells, with_groups));
  for (const std::string &notice : cells.notices)
    std::cout << "  " << notice << std::endl;
}

#ifdef VOUSSOIR_WITH_GDAL
void check_ogr(const std::string &what,
               const std::string &file,
               const unsigned int n_notices = 0)
{
  const CellLoops cells = imported_cells(file);
  check(what, is_pair_of_squares(cells, true) &&
                  cells.records == std::vector<unsigned int>({1, 2}) &&
                  cells.notices.size() == n_notices);
}

/** The refusal must hold these words. */
void check_refusal(const std::string &what,
                   const std::string &file,
                   const std::string &words)
{
  try
  {
    imported_cells(file);
    check(what + " is refused", false);
  }
  catch (const InputError &error)
  {
    check(what + " is refused",
          std::string(error.what()).find(words) != std::string::npos);
  }
}

/** A GDAL that is not there. */
void check_missing_library()
{
  try
  {
    const GdalLibrary library("libgdal.so.0");
    check("a missing GDAL is refused", false);
  }
  catch (const InputError &error)
  {
    check("a missing GDAL is refused",
          error.what() ==
              std::string("GDAL, which reads all polygons but .wkt and .off, "
                          "cannot be loaded: libgdal.so.0: cannot open shared "
                          "object file: No such file or directory. Install "
                          "GDAL (Debian: libgdal-dev), or save the polygons "
                          "as .wkt or .off."));
  }
}

/** Write the two squares in a binary format, by GDAL itself. */
void write_squares(const std::string &format, const std::string &file)
{
  std::filesystem::remove(file);
  // As in the reader: GDAL starts libxml2, which computes 0/0.
  const Voussoir::InvalidOperationsAllowed allowed;
  GDALAllRegister();
  GDALDriver *driver = GetGDALDriverManager()->GetDriverByName(format.c_str());
  const GDALDatasetUniquePtr dataset(
      driver->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  OGRLayer *layer =
      dataset->CreateLayer("blocks", nullptr, wkbPolygon, nullptr);
  OGRFieldDefn field("group", OFTString);
  layer->CreateField(&field);
  for (const double x : {0., 1.})
  {
    OGRLinearRing ring;
    for (const auto &[dx, y] : {std::pair<double, double>(0., 0.),
                                {1., 0.},
                                {1., 1.},
                                {0., 1.},
                                {0., 0.}})
      ring.addPoint(x + dx, y);
    OGRPolygon polygon;
    polygon.addRing(&ring);
    const OGRFeatureUniquePtr feature(
        OGRFeature::CreateFeature(layer->GetLayerDefn()));
    feature->SetField("group", x == 0. ? "a" : "b");
    feature->SetGeometry(&polygon);
    if (layer->CreateFeature(feature.get()) != OGRERR_NONE)
      check("writing " + file, false);
  }
}
#else
// Without GDAL every message says what to install.
bool says_what_to_install(const std::string &file)
{
  try
  {
    imported_cells(file);
    return false;
  }
  catch (const InputError &error)
  {
    return std::string(error.what()).find("VOUSSOIR_GDAL=ON") !=
           std::string::npos;
  }
}

void check_missing_library()
{
  check("a missing GDAL is refused", says_what_to_install("squares.dxf"));
}

void check_ogr(const std::string &what,
               const std::string &file,
               const unsigned int = 0)
{
  check(what, says_what_to_install(file));
}

void check_refusal(const std::string &what,
                   const std::string &file,
                   const std::string &)
{
  check(what + " is refused", says_what_to_install(file));
}

void write_squares(const std::string &, const std::string &) {}
#endif

void test_wkt()
{
  check_wkt("Shapely", "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n"
                       "POLYGON ((1 0, 2 0, 2 1, 1 1, 1 0))\n");
  check_wkt("PostGIS, clockwise", "SRID=4326;POLYGON((0 0,0 1,1 1,1 0,0 0))\n"
                                  "POLYGON((1 0,1 1,2 1,2 0,1 0))\n");
  check_wkt("QGIS, with Z",
            "Polygon Z ((0 0 3, 1 0 3, 1 1 3, 0 1 3, 0 0 3))\n"
            "Polygon Z ((1 0 3, 2 0 3, 2 1 3, 1 1 3, 1 0 3))\n");
  check_wkt("M, ZM, and Z without a mark",
            "POLYGONM((0 0 3,1 0 3,1 1 3,0 1 3,0 0 3))\n"
            "MULTIPOLYGON ZM (((1 0 3 4,2 0 3 4,2 1 3 4,1 1 3 4,1 0 3 4)))\n");
  check_wkt("MULTIPOLYGON", "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)),"
                            " ((1 0, 2 0, 2 1, 1 1, 1 0)))");
  check_wkt("comments, blank lines, tabs, CRLF, byte order mark, lower case",
            "\xEF\xBB\xBF# two squares\r\n\r\n  \t\r\n"
            "\tpolygon((0 0 ,\t1 0, 1 1,0\t1, 0 0) )  \r\n"
            "#POLYGON ((0 0, 1 0\r\n"
            "pOlygon ( ( 1 0, 2 0, 2 1, 1 1, 1 0 ) )\r\n");
  check_wkt("scientific notation and signs",
            "POLYGON ((-0.0 0e0, 1.0E+00 0, 10e-1 +1, 0 1., 0 -0))\n"
            "POLYGON ((.1e1 0, 2 0, 2 1, 1 1, 1 0))\n",
            false, "squares.TXT");
  check_wkt("groups",
            "POLYGON((0 0,1 0,1 1,0 1,0 0));a\n"
            "POLYGON((1 0,2 0,2 1,1 1,1 0))\tb\n",
            true);
  check_wkt("groups behind commas",
            "POLYGON((0 0,1 0,1 1,0 1,0 0)) , a \n"
            "POLYGON((1 0,2 0,2 1,1 1,1 0)),b\n",
            true);

  write_file("squares.wkt", "#\nPOLYGON((0 0,1 0,1 1,0 1,0 0));left side\n"
                            "MULTIPOLYGON(((1 0,2 0,2 1,1 1,1 0)),"
                            "((2 0,3 0,3 1,2 1,2 0)))\n");
  const CellLoops cells = imported_cells("squares.wkt");
  check("the line of each cell",
        cells.file == "squares.wkt" &&
            cells.records == std::vector<unsigned int>({2, 3, 3}));
  check("cells without a name beside others are called block",
        cells.group_names == std::vector<std::string>({"left side", "block"}) &&
            cells.group == std::vector<unsigned int>({0, 1, 1}));
}

void test_off()
{
  check_wkt("OFF",
            "OFF\n6 2 0\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n"
            "4 0 1 4 3\n4 1 2 5 4\n",
            false, "squares.off");
  check_wkt(
      "OFF with comments, colours, z, CRLF and a clockwise face",
      "OFF # faces\r\n# size\r\n6 2 7\r\n\r\n0 0 0\r\n1e0 0 0\r\n2 0 5\r\n"
      "0 1 0 # corner\r\n1 1 0\r\n2 1 0\r\n4 0 1 4 3 255 0 0\r\n"
      "4 1 4 5 2 0 255 0",
      false, "squares.off");
  check("the line of each face", imported_cells("squares.off").records ==
                                     std::vector<unsigned int>({11, 12}));
}

void test_ogr()
{
  const std::string head = R"({"type": "FeatureCollection", "features": [)";
  const std::string left =
      R"({"type": "Feature", "properties": {"name": "x", "group": "a"},
          "geometry": {"type": "Polygon", "coordinates":
          [[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]]}},)";
  const std::string right =
      R"({"type": "Feature", "properties": {"name": "x", "group": "b"},
          "geometry": {"type": "MultiPolygon", "coordinates":
          [[[[1, 0], [1, 1], [2, 1], [2, 0], [1, 0]]]]}})";
  write_file("squares.geojson", head + left + right + "]}");
  check_ogr("GeoJSON", "squares.geojson");
  write_file("squares.geojson", head + left + right + R"(,
      {"type": "Feature", "properties": {}, "geometry":
       {"type": "Point", "coordinates": [0, 0, 1]}}]})");
  check_ogr("GeoJSON with a point", "squares.geojson", 2);

  // The least that is a DXF file: closed LWPOLYLINEs on layers a and b.
  const std::string begin = "0\nSECTION\n2\nENTITIES\n";
  const auto square = [](const std::string &layer, const std::string &x0,
                         const std::string &x1) {
    return "0\nLWPOLYLINE\n8\n" + layer + "\n90\n4\n70\n1\n10\n" + x0 +
           "\n20\n0\n10\n" + x1 + "\n20\n0\n10\n" + x1 + "\n20\n1\n10\n" + x0 +
           "\n20\n1\n";
  };
  write_file("squares.dxf", begin + square("a", "0.0", "1.0") +
                                square("b", "1.0", "2.0") +
                                "0\nENDSEC\n0\nEOF\n");
  check_ogr("DXF", "squares.dxf");

  // QGIS writes WKT as a column of a table.
  write_file("squares.csv", "WKT,group\n\"POLYGON ((0 0,1 0,1 1,0 1,0 0))\",a\n"
                            "\"POLYGON ((1 0,2 0,2 1,1 1,1 0))\",b\n");
  check_ogr("CSV", "squares.csv");

  write_squares("GPKG", "squares.gpkg");
  check_ogr("GeoPackage", "squares.gpkg");
  write_squares("ESRI Shapefile", "squares.shp");
  check_ogr("Shapefile", "squares.shp");

  check_missing_library();
  std::filesystem::remove("missing.dxf");
  check_refusal("a missing file", "missing.dxf", "does not exist");
  write_file("squares.geojson", "nonsense");
  check_refusal("nonsense", "squares.geojson", "none of the formats");
  // In which GDAL would look for the end of the line without end.
  std::ofstream("zeros.dxf", std::ios::binary)
      << "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\npier\r" << '\0' << "\n20\n0";
  check_refusal("a byte 0", "zeros.dxf", "has a byte 0 in line 8");
  // GDAL reads it, and would read what it leads to.
  write_file("squares.vrt", R"(<OGRVRTDataSource><OGRVRTLayer name="squares">
<SrcDataSource>squares.shp</SrcDataSource></OGRVRTLayer></OGRVRTDataSource>)");
  check_refusal("a file that leads to another", "squares.vrt",
                "none of the formats");
  write_file("squares.geojson", head + left + "\n");
  check_refusal("a truncated file", "squares.geojson", "(GDAL: ");
  write_file("squares.geojson", head + "]}");
  check_refusal("no features", "squares.geojson", "has no polygons");
  write_file("squares.geojson",
             head + left + R"({"type": "Feature", "properties": {},
      "geometry": {"type": "LineString", "coordinates":
      [[0, 0], [1, 0], [1, 1]]}}]})");
  check_refusal(
      "an open line", "squares.geojson",
      "Cell 1 (feature 2 of 'squares.geojson', layer 'squares', id 1) "
      "is a line from (0, 0) "
      "to (1, 1) that is not closed; close it");
  write_file("squares.geojson",
             head + left + R"({"type": "Feature", "properties": {},
      "geometry": {"type": "Polygon", "coordinates":
      [[[5, 5], [9, 5], [9, 9], [5, 5]], [[7, 6], [8, 6], [8, 7], [7, 6]]]}}]})");
  check_refusal(
      "a hole", "squares.geojson",
      "Cell 1 (feature 2 of 'squares.geojson', layer 'squares', id 1) "
      "has a hole");
  write_file("squares.geojson",
             head + left + R"({"type": "Feature", "properties": {},
      "geometry": null}]})");
  check_refusal(
      "a feature without geometry", "squares.geojson",
      "Cell 1 (feature 2 of 'squares.geojson', layer 'squares', id 1) "
      "has no geometry");
}

/** A drawing in mm with its scale is that in m; the units of messages are m. */
void test_scale()
{
  write_file("m.wkt",
             "POLYGON ((0 0, 0.215 0, 0.215 0.065, 0 0.065, 0 0))\n"
             "POLYGON ((0.215 0, 0.43 0, 0.43 0.065, 0.215 0.065, 0.215 0))\n");
  write_file("mm.wkt", "POLYGON ((0 0, 215 0, 215 65, 0 65, 0 0))\n"
                       "POLYGON ((215 0, 430 0, 430 65, 215 65, 215 0))\n");
  write_file("m.txt", "0.1 0.03\n0.3 0.03\n");
  write_file("mm.txt", "100 30\n300 30\n");
  const CellLoops in_m = imported_cells("m.wkt", {{"Centres file", "m.txt"}}),
                  in_mm = imported_cells("mm.wkt", {{"Centres file", "mm.txt"},
                                                    {"Scale", "0.001"}});
  double error = in_m.vertices.size() == in_mm.vertices.size() ? 0. : 1.;
  for (unsigned int v = 0; v < in_m.vertices.size() && error < 1.; ++v)
    error = std::max(error, in_m.vertices[v].distance(in_mm.vertices[v]));
  for (unsigned int c = 0; c < 2; ++c)
    error = std::max(error, in_m.centres[c].distance(in_mm.centres[c]));
  check_error("a drawing in mm", error, 1e-15);
  for (const std::string scale : {"0", "-1"})
    show_refusal([&] { imported_cells("mm.wkt", {{"Scale", scale}}); });
}

int main()
{
  test_wkt();
  test_off();
  test_ogr();
  test_scale();
}
