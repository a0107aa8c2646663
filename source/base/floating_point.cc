// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/floating_point.h>

#include <cfenv>

namespace Voussoir
{
namespace
{
/** Trap invalid operations, or not; return whether they were trapped. */
bool trap([[maybe_unused]] const bool trapped)
{
#if defined(DEBUG) && defined(__GLIBC__)
  // Earlier exceptions are not to be trapped now.
  std::feclearexcept(FE_INVALID);
  const int before =
      trapped ? feenableexcept(FE_INVALID) : fedisableexcept(FE_INVALID);
  return before != -1 && (before & FE_INVALID) != 0;
#else
  return false;
#endif
}
} // namespace

bool trap_invalid_operations()
{
  trap(true);
  return trap(true); // some processors have no such trap
}

bool invalid_operations_are_trapped()
{
#if defined(DEBUG) && defined(__GLIBC__)
  return (fegetexcept() & FE_INVALID) != 0;
#else
  return false;
#endif
}

InvalidOperationsTrapped::InvalidOperationsTrapped(const bool are_trapped)
    : were_trapped(trap(are_trapped))
{}

InvalidOperationsTrapped::~InvalidOperationsTrapped()
{
  trap(were_trapped);
}
} // namespace Voussoir
