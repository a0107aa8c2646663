// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_linear_cholmod_failure_h
#define voussoir_algebra_linear_cholmod_failure_h

#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>

#include <cholmod.h>
#include <new>

namespace Voussoir
{
/**
 * Throw what a call of CHOLMOD that has failed means: std::bad_alloc if there
 * is not enough memory or its integers are too small, else a SolverError.
 */
[[noreturn]] inline void throw_failure(const cholmod_common &common)
{
  if (common.status == CHOLMOD_OUT_OF_MEMORY ||
      common.status == CHOLMOD_TOO_LARGE)
    throw std::bad_alloc();
  throw SolverError(
      text("CHOLMOD, which solves the linear systems, has failed with the "
           "status ",
           common.status,
           ". Please report this with the .prm file, and try another "
           "'Formulation'."));
}

/** The result of a call of CHOLMOD; if it is null, throw_failure(). */
template <typename Result>
Result *check(Result *const result, const cholmod_common &common)
{
  if (result == nullptr)
    throw_failure(common);
  return result;
}
} // namespace Voussoir

#endif
