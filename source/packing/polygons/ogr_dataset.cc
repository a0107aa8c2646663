// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polygons/ogr_dataset.h>

#include <optional>
#include <utility>

namespace Voussoir
{
namespace
{
constexpr const char *step_option = "OGR_ARC_STEPSIZE";

// Drawings and maps that are files. Others of GDAL lead to other files, data
// bases and addresses: a drawing from elsewhere must not.
constexpr const char *formats[] = {
    "DXF",        "CAD",          "DGN",  "GeoJSON", "GeoJSONSeq",
    "ESRIJSON",   "TopoJSON",     "GPKG", "SQLite",  "ESRI Shapefile",
    "FlatGeobuf", "MapInfo File", "GML",  "KML",     "LIBKML",
    "CSV",        "OpenFileGDB",  nullptr};

dealii::Point<2> vertex(const OGRGeometryH curve, const int i)
{
  return {gdal().OGR_G_GetX(curve, i), gdal().OGR_G_GetY(curve, i)};
}
} // namespace

const GdalLibrary &gdal()
{
  static const GdalLibrary library(VOUSSOIR_GDAL_LIBRARY);
  return library;
}

GdalMessages::GdalMessages()
{
  gdal().CPLPushErrorHandlerEx(&GdalMessages::keep, this);
  gdal().CPLErrorReset();
}

GdalMessages::~GdalMessages()
{
  gdal().CPLPopErrorHandler();
}

std::string GdalMessages::error() const
{
  return first_error.empty() ? "" : " (GDAL: " + first_error + ")";
}

void CPL_STDCALL GdalMessages::keep(CPLErr severity,
                                    CPLErrorNum,
                                    const char *what)
{
  auto *messages =
      static_cast<GdalMessages *>(gdal().CPLGetErrorHandlerUserData());
  std::string &first =
      severity >= CE_Failure ? messages->first_error : messages->first_warning;
  if (severity >= CE_Warning && first.empty())
    first = what;
}

template <typename Read>
auto OgrDataset::with_step(const Read &read) const
{
  if (arc_step.empty())
    return read();
  // The option is the thread's: others may read drawings at the same time.
  const char *const found =
      gdal().CPLGetThreadLocalConfigOption(step_option, nullptr);
  const std::optional<std::string> before =
      found == nullptr ? std::nullopt : std::optional<std::string>(found);
  gdal().CPLSetThreadLocalConfigOption(step_option, arc_step.c_str());
  auto result = read();
  gdal().CPLSetThreadLocalConfigOption(step_option,
                                       before ? before->c_str() : nullptr);
  return result;
}

OgrDataset::OgrDataset(const std::filesystem::path &file, std::string step)
    : arc_step(std::move(step)),
      dataset(with_step([&] {
                return gdal().GDALOpenEx(file.c_str(),
                                         GDAL_OF_VECTOR | GDAL_OF_READONLY |
                                             GDAL_OF_VERBOSE_ERROR,
                                         formats, nullptr, nullptr);
              }),
              [](const GDALDatasetH which) { gdal().GDALClose(which); })
{}

bool OgrDataset::is_dxf() const
{
  return std::string(gdal().GDALGetDriverShortName(
             gdal().GDALGetDatasetDriver(dataset.get()))) == "DXF";
}

int OgrDataset::n_layers() const
{
  return gdal().GDALDatasetGetLayerCount(dataset.get());
}

OGRLayerH OgrDataset::begin_layer(const int number)
{
  layer = gdal().GDALDatasetGetLayer(dataset.get(), number);
  gdal().OGR_L_ResetReading(layer);
  return layer;
}

Owned<OGRFeatureH> OgrDataset::next()
{
  return {with_step([&] { return gdal().OGR_L_GetNextFeature(layer); }),
          gdal().OGR_F_Destroy};
}

DrawnChain chain_of(const OGRGeometryH curve)
{
  const OGRwkbGeometryType type =
      gdal().OGR_GT_Flatten(gdal().OGR_G_GetGeometryType(curve));
  DrawnChain chain;
  if (type == wkbCompoundCurve)
  {
    for (int i = 0; i < gdal().OGR_G_GetGeometryCount(curve); ++i)
      chain.append(chain_of(gdal().OGR_G_GetGeometryRef(curve, i)));
    return chain;
  }
  const int n = gdal().OGR_G_GetPointCount(curve);
  const bool has_arcs = type == wkbCircularString;
  for (int i = 0; i < n; ++i)
    if (!has_arcs || i == 0)
      chain.add(vertex(curve, i));
    else if (i % 2 == 0)
      chain.add_arc(vertex(curve, i - 1), vertex(curve, i));
  return chain;
}
} // namespace Voussoir
