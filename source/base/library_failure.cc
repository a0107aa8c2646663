// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/library_failure.h>

#include <atomic>
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

/** The signal goes to the thread that has failed. */
void end(const int signal)
{
  if (message_of_thread == nullptr)
  {
    // Not a library's: as if it had come without this handler.
    std::signal(signal, SIG_DFL);
    std::raise(signal);
    return;
  }
  for (const char *const part : {"voussoir: ", message_of_thread, "\n"})
    if (write(STDERR_FILENO, part, std::strlen(part)) < 0)
      break;
  std::_Exit(no_answer);
}

/** Whether somebody else says the message. */
std::atomic<bool> is_left_to_others{false};

void install()
{
  if (!is_left_to_others)
    for (const int signal : {SIGABRT, SIGSEGV})
      std::signal(signal, end);
}
} // namespace

const char *message_of_library()
{
  return message_of_thread;
}

void leave_failures_to_others()
{
  is_left_to_others = true;
}

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
