// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polygons/readers.h>

#ifdef VOUSSOIR_GDAL_LIBRARY
#include <voussoir/packing/polygons/gdal_library.h>
#endif

#include <memory>
#include <type_traits>

namespace Voussoir
{
#ifdef VOUSSOIR_GDAL_LIBRARY
namespace
{
const GdalLibrary &gdal()
{
  static const GdalLibrary library(VOUSSOIR_GDAL_LIBRARY);
  return library;
}

/** Something of GDAL's with the function that gives it back. */
template <typename Handle>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, void (*)(Handle)>;

/** Keeps the messages that GDAL would print, while it lives. */
class GdalMessages
{
public:
  GdalMessages()
  {
    gdal().CPLPushErrorHandlerEx(&GdalMessages::keep, this);
    gdal().CPLErrorReset();
  }
  GdalMessages(const GdalMessages &) = delete;
  ~GdalMessages() { gdal().CPLPopErrorHandler(); }

  /** The first error, in parentheses; empty if there was none. */
  std::string error() const
  {
    return first_error.empty() ? "" : " (GDAL: " + first_error + ")";
  }

  std::string first_error;
  std::string first_warning;

private:
  static void CPL_STDCALL keep(CPLErr severity, CPLErrorNum, const char *what)
  {
    auto *messages =
        static_cast<GdalMessages *>(gdal().CPLGetErrorHandlerUserData());
    std::string &first = severity >= CE_Failure ? messages->first_error
                                                : messages->first_warning;
    if (severity >= CE_Warning && first.empty())
      first = what;
  }
};

/** Reads one file; one object, used once. */
class OgrReader
{
public:
  explicit OgrReader(const std::filesystem::path &file)
  {
    list.file = file;
    list.record_name = "feature";
  }

  PolygonList read()
  {
    gdal().GDALAllRegister();
    const Owned<GDALDatasetH> dataset(
        gdal().GDALOpenEx(list.file.c_str(),
                          GDAL_OF_VECTOR | GDAL_OF_READONLY |
                              GDAL_OF_VERBOSE_ERROR,
                          nullptr, nullptr, nullptr),
        [](const GDALDatasetH which) { gdal().GDALClose(which); });
    if (dataset == nullptr)
      refuse_file("is of no format that GDAL reads" + messages.error() +
                  "; save it as .wkt, .off, GeoPackage, GeoJSON or DXF.");
    const int n_layers = gdal().GDALDatasetGetLayerCount(dataset.get());
    for (int i = 0; i < n_layers; ++i)
      read_layer(gdal().GDALDatasetGetLayer(dataset.get(), i));
    if (list.polygons.empty())
      refuse_file("has no polygons and no closed lines" + messages.error() +
                  "; a packing needs at least one.");
    give_notices();
    return std::move(list);
  }

private:
  using Kind = DrawingFault::Kind;

  [[noreturn]] void refuse(const std::string &fault,
                           const Kind kind = Kind::no_polygon) const
  {
    throw list.fault(kind, list.polygons.size(), feature, fault);
  }
  /** Read a part of a feature; what has a fault counts as a cell, too. */
  template <typename Read>
  void try_to(const Read &read)
  {
    if (!list.passes(read))
      list.polygons.push_back({{}, "", feature, true});
  }
  [[noreturn]] void refuse_file(const std::string &fault) const
  {
    throw InputError("The file of polygons '" + list.file.string() + "' " +
                     fault);
  }

  void read_layer(const OGRLayerH layer)
  {
    const OGRFeatureDefnH fields = gdal().OGR_L_GetLayerDefn(layer);
    int group_field = -1;
    for (const char *name : {"group", "name", "Layer"})
      if (group_field < 0)
        group_field = gdal().OGR_FD_GetFieldIndex(fields, name);

    gdal().OGR_L_ResetReading(layer);
    for (Owned<OGRFeatureH> next(gdal().OGR_L_GetNextFeature(layer),
                                 gdal().OGR_F_Destroy);
         next != nullptr; next.reset(gdal().OGR_L_GetNextFeature(layer)))
    {
      ++feature;
      group = group_field < 0 || !gdal().OGR_F_IsFieldSetAndNotNull(next.get(),
                                                                    group_field)
                  ? ""
                  : gdal().OGR_F_GetFieldAsString(next.get(), group_field);
      const OGRGeometryH geometry = gdal().OGR_F_GetGeometryRef(next.get());
      try_to([&] {
        if (geometry == nullptr)
          refuse("has no geometry" + messages.error() + "; delete it.");
      });
      if (geometry == nullptr)
        continue;
      has_z |= gdal().OGR_G_Is3D(geometry) != 0;
      if (gdal().OGR_G_HasCurveGeometry(geometry, true))
      {
        has_curves = true;
        constexpr double usual_angle = 0.;
        const Owned<OGRGeometryH> straight(
            gdal().OGR_G_GetLinearGeometry(geometry, usual_angle, nullptr),
            gdal().OGR_G_DestroyGeometry);
        read_geometry(straight.get());
      }
      else
        read_geometry(geometry);
    }
    if (!messages.first_error.empty())
      refuse_file(text("cannot be read beyond feature ", feature,
                       messages.error(),
                       "; open and save it again with the "
                       "program that wrote it."));
  }

  void read_geometry(const OGRGeometryH geometry)
  {
    const OGRwkbGeometryType type =
        gdal().OGR_GT_Flatten(gdal().OGR_G_GetGeometryType(geometry));
    const auto is_a = [type](const OGRwkbGeometryType other) {
      return gdal().OGR_GT_IsSubClassOf(type, other) != 0;
    };
    if (gdal().OGR_G_IsEmpty(geometry))
      try_to([&] { refuse("is empty; delete it."); });
    else if (is_a(wkbGeometryCollection) || is_a(wkbMultiSurface) ||
             is_a(wkbPolyhedralSurface))
      for (int i = 0; i < gdal().OGR_G_GetGeometryCount(geometry); ++i)
        read_geometry(gdal().OGR_G_GetGeometryRef(geometry, i));
    else if (is_a(wkbPolygon))
      try_to([&] { read_polygon(geometry); });
    else if (type == wkbLineString)
      try_to([&] { read_line(geometry); });
    else if (n_left_out++ == 0)
      first_left_out =
          text("feature ", feature, ", a ", gdal().OGRGeometryTypeToName(type));
  }

  void read_polygon(const OGRGeometryH polygon)
  {
    if (gdal().OGR_G_GetGeometryCount(polygon) > 1)
      refuse("has a hole; a cell is one loop, so cut it into cells without "
             "holes.",
             Kind::hole);
    add(points_of(gdal().OGR_G_GetGeometryRef(polygon, 0)));
  }

  void read_line(const OGRGeometryH line)
  {
    const std::vector<dealii::Point<2>> points = points_of(line);
    if (points.empty())
      refuse("has no points" + messages.error() + "; delete it.");
    if (points.size() < 2 || !(points.front() == points.back()))
      refuse("is a line from " + text_of_point(points.front()) + " to " +
                 text_of_point(points.back()) +
                 " that is not closed; close it, or delete it if it bounds no "
                 "cell.",
             Kind::not_closed);
    add(points);
  }

  static std::vector<dealii::Point<2>> points_of(const OGRGeometryH line)
  {
    std::vector<dealii::Point<2>> points;
    for (int i = 0; i < gdal().OGR_G_GetPointCount(line); ++i)
      points.emplace_back(gdal().OGR_G_GetX(line, i),
                          gdal().OGR_G_GetY(line, i));
    return points;
  }

  void add(std::vector<dealii::Point<2>> points)
  {
    if (points.size() > 1 && points.front() == points.back())
      points.pop_back();
    PolygonList::Polygon polygon;
    polygon.ring = std::move(points);
    polygon.group = group;
    polygon.record = feature;
    list.polygons.push_back(polygon);
  }

  void give_notices()
  {
    const std::string of_file = " of '" + list.file.string() + "' ";
    if (has_z)
      list.notices.push_back("The Z coordinates" + of_file + "are ignored.");
    if (has_curves)
      list.notices.push_back("The curves" + of_file +
                             "are replaced by chains of straight sides.");
    if (n_left_out > 0)
      list.notices.push_back(
          text(n_left_out, " geometries", of_file,
               "are left out because they bound no area; the "
               "first is ",
               first_left_out, "."));
    if (!messages.first_warning.empty())
      list.notices.push_back("On reading '" + list.file.string() +
                             "' GDAL says: " + messages.first_warning);
  }

  PolygonList list;
  GdalMessages messages;
  unsigned int feature = 0;
  std::string group;
  unsigned int n_left_out = 0;
  std::string first_left_out;
  bool has_z = false;
  bool has_curves = false;
};
} // namespace

PolygonList read_ogr_file(const std::filesystem::path &file)
{
  if (!std::filesystem::exists(file))
    throw InputError("The file of polygons '" + file.string() +
                     "' does not exist. Paths in a .prm file start at the "
                     "directory of that file.");
  // libxml2, which GDAL starts, computes 0/0 for its own NaN.
  const InvalidOperationsAllowed allowed;
  return OgrReader(file).read();
}

#else

PolygonList read_ogr_file(const std::filesystem::path &file)
{
  throw InputError("The file of polygons '" + file.string() +
                   "' is read through GDAL, without which Voussoir was built. "
                   "Save the polygons as .wkt or .off, or install GDAL "
                   "(Debian: libgdal-dev) and build with VOUSSOIR_GDAL=ON.");
}

#endif
} // namespace Voussoir
