// SPDX-License-Identifier: LGPL-2.1-or-later
/*
 * GDAL, which the program loads itself: of dlopen none, of dlsym none for all
 * functions of GDAL's; null of those that return pointers, and nan of
 * coordinates.
 */
#include "plant.h"
#include <cmath>
#include <cstring>

namespace
{
template <typename Type>
Type *real_of(const char *const name);

void *real_dlsym(void *const handle, const char *const name)
{
  using Find = void *(void *, const char *);
  static auto *const find =
      reinterpret_cast<Find *>(dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.34"));
  return find(handle, name);
}

void *gdal = nullptr;

template <typename Type>
Type *real_of(const char *const name)
{
  return reinterpret_cast<Type *>(real_dlsym(gdal, name));
}

/** A function of GDAL's that has pointers and numbers, and returns a pointer.
 */
#define PLANTED_POINTER(name)                                                  \
  void *name(void *a, long b, void *c, void *d, void *e)                       \
  {                                                                            \
    static Plant::Function function(#name);                                    \
    return Plant::is(function.call(), "null")                                  \
               ? nullptr                                                       \
               : real_of<void *(void *, long, void *, void *, void *)>(#name)( \
                     a, b, c, d, e);                                           \
  }
PLANTED_POINTER(GDALOpenEx)
PLANTED_POINTER(GDALDatasetGetLayer)
PLANTED_POINTER(OGR_L_GetLayerDefn)
PLANTED_POINTER(OGR_L_GetNextFeature)
PLANTED_POINTER(OGR_F_GetGeometryRef)
PLANTED_POINTER(OGR_F_GetFieldAsString)
PLANTED_POINTER(OGR_G_GetGeometryRef)
#undef PLANTED_POINTER

void GDALAllRegister()
{
  static Plant::Function function("GDALAllRegister");
  function.call();
  real_of<void()>("GDALAllRegister")();
}

int OGR_G_GetPointCount(void *geometry)
{
  static Plant::Function function("OGR_G_GetPointCount");
  return Plant::is(function.call(), "zero")
             ? 0
             : real_of<int(void *)>("OGR_G_GetPointCount")(geometry);
}

double OGR_G_GetX(void *geometry, int i)
{
  static Plant::Function function("OGR_G_GetX");
  double x = real_of<double(void *, int)>("OGR_G_GetX")(geometry, i);
  Plant::spoil(function.call(), &x, 1);
  return x;
}

/** What is planted under a name. */
void *planted(const char *const name)
{
#define PLANTED(function)                                                      \
  if (std::strcmp(name, #function) == 0)                                       \
  return reinterpret_cast<void *>(&function)
  PLANTED(GDALAllRegister);
  PLANTED(GDALOpenEx);
  PLANTED(GDALDatasetGetLayer);
  PLANTED(OGR_L_GetLayerDefn);
  PLANTED(OGR_L_GetNextFeature);
  PLANTED(OGR_F_GetGeometryRef);
  PLANTED(OGR_F_GetFieldAsString);
  PLANTED(OGR_G_GetGeometryRef);
  PLANTED(OGR_G_GetPointCount);
  PLANTED(OGR_G_GetX);
#undef PLANTED
  return nullptr;
}
} // namespace

extern "C" {
void *dlopen(const char *name, int flags)
{
  static Plant::Function function("dlopen_gdal");
  using Open = void *(const char *, int);
  static auto *const real =
      reinterpret_cast<Open *>(real_dlsym(RTLD_NEXT, "dlopen"));
  if (name == nullptr || std::strncmp(name, "libgdal", 7) != 0)
    return real(name, flags);
  if (Plant::is(function.call(), "none"))
    return real("libgdal-that-is-not-there.so", flags);
  return gdal = real(name, flags);
}

void *dlsym(void *handle, const char *name)
{
  if (gdal != nullptr && handle == gdal)
  {
    static Plant::Function function("dlsym_gdal");
    if (Plant::is(function.call(), "none"))
      return real_dlsym(handle, "no_such_function");
    if (void *const own = planted(name))
      return own;
  }
  return real_dlsym(handle, name);
}
}
