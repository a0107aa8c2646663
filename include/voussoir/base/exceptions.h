// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_exceptions_h
#define voussoir_base_exceptions_h

#include <voussoir/base/printable.h>

#include <stdexcept>
#include <string>

namespace Voussoir
{
/**
 * The user's input cannot be used. The message says what is wrong, which value,
 * where, and what to do. The program ends with exit status 2.
 */
class InputError : public std::runtime_error
{
public:
  /** @param message that may quote whatever the input has; see printable(). */
  explicit InputError(const std::string &message)
      : std::runtime_error(printable(message))
  {}
};

/**
 * A solver ended without an answer on valid input. The program ends with exit
 * status 4.
 */
class SolverError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
} // namespace Voussoir

#endif
