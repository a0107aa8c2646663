// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polygons/readers.h>

#ifdef VOUSSOIR_WITH_GDAL
#include <ogrsf_frmts.h>
#endif

namespace Voussoir
{
#ifdef VOUSSOIR_WITH_GDAL
namespace
{
/** Keeps the messages that GDAL would print, while it lives. */
class GdalMessages
{
public:
  GdalMessages() : pusher(&GdalMessages::keep, this) { CPLErrorReset(); }

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
    auto *messages = static_cast<GdalMessages *>(CPLGetErrorHandlerUserData());
    std::string &first = severity >= CE_Failure ? messages->first_error
                                                : messages->first_warning;
    if (severity >= CE_Warning && first.empty())
      first = what;
  }

  CPLErrorHandlerPusher pusher;
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
    if (!std::filesystem::exists(list.file))
      refuse_file("does not exist. Paths in a .prm file start at the directory "
                  "of that file.");
    // libxml2, which GDAL starts, computes 0/0 for its own NaN.
    const InvalidOperationsAllowed allowed;
    GDALAllRegister();
    const GDALDatasetUniquePtr dataset(
        GDALDataset::Open(list.file.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY |
                                                 GDAL_OF_VERBOSE_ERROR));
    if (dataset == nullptr)
      refuse_file("is of no format that GDAL reads" + messages.error() +
                  "; save it as .wkt, .off, GeoPackage, GeoJSON or DXF.");
    for (OGRLayer *layer : dataset->GetLayers())
      read_layer(*layer);
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

  void read_layer(OGRLayer &layer)
  {
    const OGRFeatureDefn &fields = *layer.GetLayerDefn();
    int group_field = -1;
    for (const char *name : {"group", "name", "Layer"})
      if (group_field < 0)
        group_field = fields.GetFieldIndex(name);

    layer.ResetReading();
    for (OGRFeatureUniquePtr next(layer.GetNextFeature()); next != nullptr;
         next.reset(layer.GetNextFeature()))
    {
      ++feature;
      group = group_field < 0 || !next->IsFieldSetAndNotNull(group_field)
                  ? ""
                  : next->GetFieldAsString(group_field);
      const OGRGeometry *geometry = next->GetGeometryRef();
      try_to([&] {
        if (geometry == nullptr)
          refuse("has no geometry" + messages.error() + "; delete it.");
      });
      if (geometry == nullptr)
        continue;
      has_z |= geometry->Is3D();
      if (geometry->hasCurveGeometry(true))
      {
        has_curves = true;
        const OGRGeometryUniquePtr straight(geometry->getLinearGeometry());
        read_geometry(*straight);
      }
      else
        read_geometry(*geometry);
    }
    if (!messages.first_error.empty())
      refuse_file(text("cannot be read beyond feature ", feature,
                       messages.error(),
                       "; open and save it again with the "
                       "program that wrote it."));
  }

  void read_geometry(const OGRGeometry &geometry)
  {
    const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
    if (geometry.IsEmpty())
      try_to([&] { refuse("is empty; delete it."); });
    else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection) ||
             OGR_GT_IsSubClassOf(type, wkbMultiSurface))
      for (const OGRGeometry *part : *geometry.toGeometryCollection())
        read_geometry(*part);
    else if (OGR_GT_IsSubClassOf(type, wkbPolyhedralSurface))
      for (const OGRPolygon *part : *geometry.toPolyhedralSurface())
        try_to([&] { read_polygon(*part); });
    else if (OGR_GT_IsSubClassOf(type, wkbPolygon))
      try_to([&] { read_polygon(*geometry.toPolygon()); });
    else if (type == wkbLineString)
      try_to([&] { read_line(*geometry.toLineString()); });
    else if (n_left_out++ == 0)
      first_left_out =
          text("feature ", feature, ", a ", OGRGeometryTypeToName(type));
  }

  void read_polygon(const OGRPolygon &polygon)
  {
    if (polygon.getNumInteriorRings() > 0)
      refuse("has a hole; a cell is one loop, so cut it into cells without "
             "holes.",
             Kind::hole);
    add(*polygon.getExteriorRing());
  }

  void read_line(const OGRLineString &line)
  {
    if (!line.get_IsClosed())
    {
      OGRPoint start, end;
      line.StartPoint(&start);
      line.EndPoint(&end);
      refuse("is a line from " + text_of_point({start.getX(), start.getY()}) +
                 " to " + text_of_point({end.getX(), end.getY()}) +
                 " that is not closed; close it, or delete it if it bounds no "
                 "cell.",
             Kind::not_closed);
    }
    add(line);
  }

  void add(const OGRLineString &line)
  {
    PolygonList::Polygon polygon;
    for (int i = 0; i < line.getNumPoints(); ++i)
      polygon.ring.emplace_back(line.getX(i), line.getY(i));
    if (polygon.ring.size() > 1 && polygon.ring.front() == polygon.ring.back())
      polygon.ring.pop_back();
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
