// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/library_failure.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <unistd.h>

namespace Voussoir
{
namespace
{
/** The exit status of a solver without an answer. */
constexpr int no_answer = 4;

/** The message of this thread; null where no library is called. */
thread_local const char *message_of_thread = nullptr;

/** @{ */
/** What the signals did before. */
void (*before_abort)(int) = SIG_DFL;
void (*before_fault)(int) = SIG_DFL;
/** @} */

/** The signal goes to the thread that has failed. */
void end(const int signal)
{
  if (message_of_thread == nullptr)
  {
    // Not a library's: as if it had come without this handler.
    std::signal(signal, signal == SIGABRT ? before_abort : before_fault);
    std::raise(signal);
    return;
  }
  for (const char *const part : {"voussoir: ", message_of_thread, "\n"})
    if (write(STDERR_FILENO, part, std::strlen(part)) < 0)
      break;
  std::_Exit(no_answer);
}

void install()
{
  before_abort = std::signal(SIGABRT, end);
  before_fault = std::signal(SIGSEGV, end);
}
} // namespace

LibraryFailure::LibraryFailure(const char *const message)
    : before(message_of_thread)
{
  static const bool is_installed = (install(), true);
  static_cast<void>(is_installed);
  message_of_thread = message;
}

LibraryFailure::~LibraryFailure()
{
  message_of_thread = before;
}
} // namespace Voussoir
