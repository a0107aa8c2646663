// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_gdal_library_h
#define voussoir_packing_polygons_gdal_library_h

#include <cpl_conv.h>
#include <gdal.h>
#include <ogr_api.h>
#include <string>

namespace Voussoir
{
/**
 * The functions of GDAL's C interface that read polygons, under their own
 * names. GDAL brings sixty libraries, which take a sixth of the time that the
 * program needs to start: it is loaded by the first file that asks for it, and
 * then stays.
 */
class GdalLibrary
{
  void *const handle;

  /** The function @p name, whose type is @p Function. */
  template <typename Function>
  Function *find(const char *name) const
  {
    return reinterpret_cast<Function *>(address_of(name));
  }
  void *address_of(const char *name) const;

public:
  /**
   * @param name of the library, such as libgdal.so.32, which the loader of the
   *   system looks for.
   * @throws InputError if it cannot be loaded or is no GDAL.
   */
  explicit GdalLibrary(const std::string &name);

/** @cond */ // GDAL's own names
// Says the name once instead of three times.
#define VOUSSOIR_OF_GDAL(name)                                                 \
  decltype(::name) *const name = find<decltype(::name)>(#name)
  VOUSSOIR_OF_GDAL(CPLErrorReset);
  VOUSSOIR_OF_GDAL(CPLGetErrorHandlerUserData);
  VOUSSOIR_OF_GDAL(CPLGetThreadLocalConfigOption);
  VOUSSOIR_OF_GDAL(CPLPopErrorHandler);
  VOUSSOIR_OF_GDAL(CPLPushErrorHandlerEx);
  VOUSSOIR_OF_GDAL(CPLSetThreadLocalConfigOption);
  VOUSSOIR_OF_GDAL(GDALAllRegister);
  VOUSSOIR_OF_GDAL(GDALClose);
  VOUSSOIR_OF_GDAL(GDALDatasetGetLayer);
  VOUSSOIR_OF_GDAL(GDALDatasetGetLayerCount);
  VOUSSOIR_OF_GDAL(GDALGetDatasetDriver);
  VOUSSOIR_OF_GDAL(GDALGetDriverShortName);
  VOUSSOIR_OF_GDAL(GDALOpenEx);
  VOUSSOIR_OF_GDAL(OGRGeometryTypeToName);
  VOUSSOIR_OF_GDAL(OGR_FD_GetFieldIndex);
  VOUSSOIR_OF_GDAL(OGR_FD_GetName);
  VOUSSOIR_OF_GDAL(OGR_F_Destroy);
  VOUSSOIR_OF_GDAL(OGR_F_GetFID);
  VOUSSOIR_OF_GDAL(OGR_F_GetFieldAsString);
  VOUSSOIR_OF_GDAL(OGR_F_GetGeometryRef);
  VOUSSOIR_OF_GDAL(OGR_F_IsFieldSetAndNotNull);
  VOUSSOIR_OF_GDAL(OGR_GT_Flatten);
  VOUSSOIR_OF_GDAL(OGR_GT_IsSubClassOf);
  VOUSSOIR_OF_GDAL(OGR_G_GetGeometryCount);
  VOUSSOIR_OF_GDAL(OGR_G_GetGeometryRef);
  VOUSSOIR_OF_GDAL(OGR_G_GetGeometryType);
  VOUSSOIR_OF_GDAL(OGR_G_GetPointCount);
  VOUSSOIR_OF_GDAL(OGR_G_GetX);
  VOUSSOIR_OF_GDAL(OGR_G_GetY);
  VOUSSOIR_OF_GDAL(OGR_G_Is3D);
  VOUSSOIR_OF_GDAL(OGR_G_IsEmpty);
  VOUSSOIR_OF_GDAL(OGR_L_GetLayerDefn);
  VOUSSOIR_OF_GDAL(OGR_L_GetNextFeature);
  VOUSSOIR_OF_GDAL(OGR_L_ResetReading);
#undef VOUSSOIR_OF_GDAL
  /** @endcond */
};
} // namespace Voussoir

#endif
