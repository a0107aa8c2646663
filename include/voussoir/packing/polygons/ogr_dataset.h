// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_ogr_dataset_h
#define voussoir_packing_polygons_ogr_dataset_h

#include <voussoir/packing/polygons/drawn_arcs.h>
#include <voussoir/packing/polygons/gdal_library.h>

#include <filesystem>
#include <memory>
#include <string>
#include <type_traits>

namespace Voussoir
{
/** The library, loaded when it is first asked for. */
const GdalLibrary &gdal();

/** Something of GDAL's with the function that gives it back. */
template <typename Handle>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, void (*)(Handle)>;

/** Keeps the messages that GDAL would print, while it lives. */
class GdalMessages
{
public:
  GdalMessages();
  GdalMessages(const GdalMessages &) = delete;
  ~GdalMessages();

  /** The first error, in parentheses; empty if there was none. */
  std::string error() const;

  /** The first one, empty if there was none. */
  std::string first_error;
  /** The same of warnings. */
  std::string first_warning;

private:
  static void CPL_STDCALL keep(CPLErr severity, CPLErrorNum, const char *what);
};

/**
 * A file of features, one layer after the other. GDAL makes chords of the arcs
 * of some formats as it reads them, and tells of no arcs then: two datasets of
 * the same file with different steps do; see chain_between().
 */
class OgrDataset
{
public:
  /**
   * @param arc_step the largest angle between the vertices on an arc, in
   *   degrees; empty: as GDAL has it.
   */
  OgrDataset(const std::filesystem::path &file, std::string arc_step = "");

  /** Whether GDAL reads files of this format. */
  bool is_open() const { return dataset != nullptr; }
  /** Whether it is DXF, whose arcs GDAL makes chords of. */
  bool is_dxf() const;
  /** The number of layers of the file; DXF has one, in whatever its layers. */
  int n_layers() const;
  /** Begin to read a layer, and return it. */
  OGRLayerH begin_layer(int number);
  /** The next feature of the layer, or none. */
  Owned<OGRFeatureH> next();

private:
  /** What @p read returns with the step of arcs for GDAL's. */
  template <typename Read>
  auto with_step(const Read &read) const;

  std::string arc_step;
  Owned<GDALDatasetH> dataset;
  OGRLayerH layer = nullptr;
};

/** The vertices and arcs of a curve in the plane. */
DrawnChain chain_of(OGRGeometryH curve);
} // namespace Voussoir

#endif
