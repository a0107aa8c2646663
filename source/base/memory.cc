// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/memory.h>

#include <cstdint>
#include <cstdlib>
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

namespace Voussoir
{
void keep_memory()
{
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
  // Addresses alone, which all later memory is taken from.
  const std::size_t page = sysconf(_SC_PAGESIZE);
  const std::size_t n_bytes = sysconf(_SC_PHYS_PAGES) / 2 * page;
  void *const begin = std::malloc(n_bytes);
  if (begin == nullptr)
    return;
  const auto address = reinterpret_cast<std::uintptr_t>(begin);
  const std::size_t to_page = page - address % page;
  madvise(static_cast<char *>(begin) + to_page, n_bytes - to_page,
          MADV_HUGEPAGE);
  std::free(begin);
#endif
}
} // namespace Voussoir
