// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_floating_point_h
#define voussoir_base_floating_point_h

namespace Voussoir
{
/**
 * From here on, in Debug, end the program by the signal SIGFPE wherever an
 * invalid operation is carried out.
 *
 * Such are 0/0, inf - inf, the root of a negative number, the conversion of
 * what no integer holds, and also < or > (but not ==) of a NaN. What makes a
 * NaN is then found where it is made. Threads started later, and TBB's tasks,
 * do as the thread that called this; call it first in main().
 *
 * @return true if they are trapped: in Debug with glibc, which alone has the
 *   functions for it.
 */
bool trap_invalid_operations();

/** True if invalid operations of this thread are trapped. */
bool invalid_operations_are_trapped();

/** While this lives, invalid operations of its thread are trapped, or not. */
class InvalidOperationsTrapped
{
public:
  /** @param are_trapped from now on, where they can be. */
  explicit InvalidOperationsTrapped(bool are_trapped);
  ~InvalidOperationsTrapped();
  InvalidOperationsTrapped(const InvalidOperationsTrapped &) = delete;
  InvalidOperationsTrapped &
  operator=(const InvalidOperationsTrapped &) = delete;

private:
  const bool were_trapped;
};

/**
 * While this lives, invalid operations of its thread give NaN without a trap:
 * for libraries that use NaN on purpose.
 */
class InvalidOperationsAllowed : InvalidOperationsTrapped
{
public:
  InvalidOperationsAllowed() : InvalidOperationsTrapped(false) {}
};
} // namespace Voussoir

#endif
