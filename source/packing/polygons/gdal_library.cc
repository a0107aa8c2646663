// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/packing/polygons/gdal_library.h>

#include <dlfcn.h>

namespace Voussoir
{
namespace
{
[[noreturn]] void refuse()
{
  throw InputError(std::string("GDAL, which reads all polygons but .wkt and "
                               ".off, cannot be loaded: ") +
                   dlerror() +
                   ". Install GDAL (Debian: libgdal-dev), or save the polygons "
                   "as .wkt or .off.");
}
} // namespace

GdalLibrary::GdalLibrary(const std::string &name)
    : handle(dlopen(name.c_str(), RTLD_LAZY | RTLD_LOCAL))
{}

void *GdalLibrary::address_of(const char *name) const
{
  void *const address = handle == nullptr ? nullptr : dlsym(handle, name);
  if (address == nullptr)
    refuse();
  return address;
}
} // namespace Voussoir
