// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef planted_plant_h
#define planted_plant_h

#include <dlfcn.h>

/**
 * Failures of libraries, from outside of the program: a shared library that is
 * loaded before the others, by LD_PRELOAD. Each function here hides the one of
 * its name, and calls it, or fails as the environment says:
 *
 *     PLANT="FUNCTION:CALL:FAILURE[;...]"
 *
 * CALL is the number of the call, from 1 on, with a + behind it for all that
 * follow as well. FAILURE is one of those that any function may have, which are
 * done at once:
 *
 *     abort, fault, exit, throw, throw_int, bad_alloc
 *
 * or one that the function itself knows. With PLANT_RANK only the process of
 * that number has it. When it comes the file of the name in PLANT_MARK is made.
 */
namespace Plant
{
/** The calls of one function, and the failures that are planted there. */
class Function
{
public:
  constexpr explicit Function(const char *name) : name(name) {}
  /**
   * Count a call.
   *
   * @return the failure that it has, with a zero at its end as in PLANT; null
   *   if it has none.
   */
  const char *call();

private:
  const char *const name;
  long n_calls = 0;
};

/** Whether call() has returned the failure @p name. */
bool is(const char *failure, const char *name);

/** The number behind the = of a failure such as status=3. */
int number_of(const char *failure);

/** What the values of a solution become: nan, inf, zero or wrong. */
void spoil(const char *failure, double *values, long n);

/** The function that one of this library hides. */
template <typename Type>
Type *hidden(const char *name)
{
  return reinterpret_cast<Type *>(dlsym(RTLD_NEXT, name));
}
} // namespace Plant

#endif
