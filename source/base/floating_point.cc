// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/floating_point.h>

#include <cfenv>

namespace Voussoir
{
#if defined(DEBUG) && defined(__GLIBC__)
namespace
{
/** Trap invalid operations, or not; return whether they were trapped. */
bool trap(const bool trapped)
{
  // Earlier exceptions are not to be trapped now.
  std::feclearexcept(FE_INVALID);
  const int before =
      trapped ? feenableexcept(FE_INVALID) : fedisableexcept(FE_INVALID);
  return before != -1 && (before & FE_INVALID) != 0;
}
} // namespace

bool trap_invalid_operations()
{
  trap(true);
  // Some processors have no such trap.
  return (fegetexcept() & FE_INVALID) != 0;
}

InvalidOperationsAllowed::InvalidOperationsAllowed() : were_trapped(trap(false))
{}

InvalidOperationsAllowed::~InvalidOperationsAllowed()
{
  trap(were_trapped);
}
#else
bool trap_invalid_operations()
{
  return false;
}

InvalidOperationsAllowed::InvalidOperationsAllowed() : were_trapped(false) {}

InvalidOperationsAllowed::~InvalidOperationsAllowed() = default;
#endif
} // namespace Voussoir
