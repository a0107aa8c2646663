// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_beside_h
#define voussoir_base_beside_h

#include <voussoir/base/floating_point.h>

#include <deal.II/base/multithread_info.h>

#include <future>

namespace Voussoir
{
/** True if this is not the only thread that the program may have. */
inline bool has_other_threads()
{
  return dealii::MultithreadInfo::n_threads() > 1;
}

/**
 * Call a function by another thread, beside what this one does, with traps of
 * invalid operations as in this one.
 *
 * @param by_another false to call it at once by this thread.
 * @param function takes nothing, and outlives the result.
 * @return what it returns or throws, by get().
 */
template <typename Function>
auto beside(const bool by_another, const Function &function)
{
  const bool are_trapped = invalid_operations_are_trapped();
  // Where the system has no other thread, get() calls it.
  auto result =
      std::async(by_another ? std::launch::async | std::launch::deferred
                            : std::launch::deferred,
                 [&function, are_trapped] {
                   const InvalidOperationsTrapped as_there(are_trapped);
                   return function();
                 });
  if (!by_another)
    result.wait();
  return result;
}
} // namespace Voussoir

#endif
