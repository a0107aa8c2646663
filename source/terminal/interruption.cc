// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/library_failure.h>
#include <voussoir/terminal/interruption.h>
#include <voussoir/terminal/screen.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <fcntl.h>
#include <iterator>
#include <new>
#include <poll.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace Voussoir
{
namespace
{
/** The number that a shell adds to that of the signal that ended a program. */
constexpr int status_of_signals = 128;

/** The byte that wakes the thread without a signal. */
constexpr unsigned char no_signal = 0;

/**
 * The time that a message waits for a terminal or pipe that takes nothing; ms.
 */
constexpr int patience_with_terminal = 1000;

/**
 * The time that processes with nothing to undo and no message wait. Open MPI
 * kills the others within milliseconds when the first one has ended, although
 * it means to wait for a second.
 */
constexpr auto head_start = std::chrono::seconds(2);

constexpr std::pair<int, const char *> signals[] = {
    {SIGINT, "SIGINT"}, {SIGTERM, "SIGTERM"}, {SIGHUP, "SIGHUP"}};
constexpr std::size_t n_signals = std::size(signals);

/** The exit status of a solver without an answer, and of a failure. */
constexpr int no_answer = 4;

/** Those of what fails; the last stands for exit() by a library. */
constexpr unsigned char ended_by_exit = 0xff;
#ifdef __SANITIZE_ADDRESS__ // which has its own report
constexpr std::array<int, 0> failures = {};
#else
constexpr std::array<int, 5> failures = {
    {SIGABRT, SIGSEGV, SIGBUS, SIGILL, SIGFPE}};
#endif

/**
 * The time that a failure waits for the thread to clear up: that may need a
 * lock which the place of the failure holds; s.
 */
constexpr time_t patience_with_undo = 5;

/** The state that the thread shares with the rest of the program. */
struct Shared
{
  std::mutex mutex;
  std::function<void()> undo;
  std::string state = "nothing was written.";
  bool quiet = false;
  bool screen = false;
};

/** Never destroyed: the thread may outlive what std::exit() destroys. */
Shared &shared()
{
  static Shared &the_only = *new Shared;
  return the_only;
}

struct sigaction previous[n_signals];

std::atomic<int> write_end{-1};
static_assert(std::atomic<int>::is_always_lock_free,
              "a handler of signals must not wait for a lock");

void wake(const unsigned char signal)
{
  // A full pipe has signals enough.
  [[maybe_unused]] const ssize_t n = write(write_end, &signal, 1);
}

extern "C" void wake_on_signal(const int signal)
{
  const int error = errno;
  wake(static_cast<unsigned char>(signal));
  errno = error;
}

/** Write without a stream, and after poll(): the reader may have stopped. */
void write_to(const int file_descriptor, const std::string &text)
{
  pollfd reader = {file_descriptor, POLLOUT, 0};
  if (poll(&reader, 1, patience_with_terminal) == 1)
  {
    [[maybe_unused]] const ssize_t n =
        write(file_descriptor, text.data(), text.size());
  }
}

/** The exit status of a program that is over; negative before. */
std::atomic<int> final_status{-1};

/** @{ */
/** True once the program has failed, and once that is said. */
std::atomic<bool> has_failed{false};
std::atomic<bool> failure_is_said{false};
/** @} */

/** The message of a library that has failed and says so; null of others. */
std::atomic<const char *> of_library{nullptr};

/** What no one has caught; it needs no memory. */
std::array<char, 512> uncaught = {};

bool is_failure(const unsigned char signal)
{
  for (const int one : failures)
    if (one == signal)
      return true;
  return signal == ended_by_exit;
}

const char *words_of(const unsigned char failure)
{
  switch (failure)
  {
  case SIGABRT: return "abort()";
  case SIGSEGV: return "an invalid address (SIGSEGV)";
  case SIGBUS: return "an invalid address (SIGBUS)";
  case SIGILL: return "an unknown instruction (SIGILL)";
  case SIGFPE: return "a division by zero (SIGFPE)";
  default: return "exit()";
  }
}

/**
 * Say once that the program has failed, and how, by what a handler of signals
 * may do.
 */
void say_failure(const unsigned char failure, const char *const state)
{
  if (failure_is_said.exchange(true))
    return;
  if (const char *const message = of_library)
  {
    for (const char *const part : {"voussoir: ", message, "\n"})
      if (write(STDERR_FILENO, part, std::strlen(part)) < 0)
        break;
    return;
  }
  for (const char *const part :
       {"voussoir: The program, or a library that it uses, has failed by ",
        uncaught.front() != 0 ? uncaught.data() : words_of(failure), state,
        " Please report this with the .prm file, the files that it names, the "
        "output of 'voussoir --version' and what stands before.\n"})
    if (write(STDERR_FILENO, part, std::strlen(part)) < 0)
      break;
}

void say(const int number)
{
  const char *name = "a signal";
  for (const auto &[signal, its_name] : signals)
    if (signal == number)
      name = its_name;
  const std::string message = std::string("voussoir: Interrupted by ") + name +
                              "; " + shared().state + "\n";
  // Clear the line of progress, and the terminal's echo of Ctrl-C.
  if (shared().screen)
    write_to(STDOUT_FILENO, clear_line);
  write_to(STDERR_FILENO, message);
}

/** End the program as @p signal asks, once no Uninterrupted lives. */
[[noreturn]] void end(const unsigned char signal)
{
  // Not unlocked: no thread may write any more.
  shared().mutex.lock();
  try
  {
    if (shared().undo)
      shared().undo();
    if (is_failure(signal))
    {
      if (shared().screen)
        write_to(STDOUT_FILENO, clear_line);
      say_failure(signal, ("; " + shared().state).c_str());
      _exit(no_answer);
    }
    if (shared().quiet)
      std::this_thread::sleep_for(head_start);
    else
      say(signal);
  }
  catch (...) // no memory: then at least end
  {
    if (is_failure(signal))
      say_failure(signal, ".");
  }
  _exit(is_failure(signal) ? no_answer : status_of_signals + signal);
}

/** End the program after a failure, by the thread if that can. */
extern "C" void end_by_failure(const int signal)
{
  if (final_status >= 0)
    _exit(final_status);
  // A second one may come on the way out.
  if (!has_failed.exchange(true))
  {
    of_library = message_of_library();
    wake(static_cast<unsigned char>(signal));
  }
  else if (failure_is_said)
    _exit(no_answer);
  for (timespec left = {patience_with_undo, 0};
       nanosleep(&left, &left) != 0 && errno == EINTR;)
    ;
  say_failure(static_cast<unsigned char>(signal), ".");
  _exit(no_answer);
}

/** What no one catches, in a thread or through a library written in C. */
[[noreturn]] void keep_words_and_abort()
{
  const auto keep = [](const char *const words) {
    std::strncpy(uncaught.data(), words, uncaught.size() - 1);
  };
  try
  {
    if (const auto thrown = std::current_exception())
      std::rethrow_exception(thrown);
  }
  catch (const std::bad_alloc &)
  {
    keep("want of memory");
  }
  catch (const std::exception &error)
  {
    keep("an exception (");
    std::strncat(uncaught.data(), error.what(),
                 uncaught.size() - std::strlen(uncaught.data()) - 2);
    std::strcat(uncaught.data(), ")");
  }
  catch (...)
  {
    keep("an exception without words");
  }
  std::abort();
}

/** A library may call exit() as well, with any status. */
void end_unless_over()
{
  if (final_status < 0)
    end_by_failure(ended_by_exit);
}

void wait_for_signals(const int read_end)
{
  // Also SIGPIPE, should the reader of the message have been interrupted, too.
  sigset_t all;
  sigfillset(&all);
  for (const int one : failures) // of this thread, should the undo fail
    sigdelset(&all, one);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
  unsigned char signal = no_signal;
  while (read(read_end, &signal, 1) == -1 && errno == EINTR)
    ;
  if (signal != no_signal)
    end(signal);
}
} // namespace

Interruption::Interruption()
{
  int ends[2];
  if (pipe2(ends, O_CLOEXEC | O_NONBLOCK) != 0)
    throw std::system_error(errno, std::generic_category(), "pipe2");
  // The thread waits, the handler must not.
  fcntl(ends[0], F_SETFL, 0);
  read_end = ends[0];
  write_end = ends[1];
  waiting = std::thread(wait_for_signals, read_end);

  for (std::size_t i = 0; i < n_signals; ++i)
    sigaction(signals[i].first, nullptr, &previous[i]);
  listen();
  watch_failures();
}

void Interruption::watch_failures()
{
  if (failures.empty())
    return;
  // Where the stack itself has come to its end, that of the main thread.
  static std::array<char, 1 << 16> stack;
  stack_t other = {};
  other.ss_sp = stack.data();
  other.ss_size = stack.size();
  sigaltstack(&other, nullptr);
  struct sigaction action = {};
  leave_failures_to_others();
  action.sa_handler = end_by_failure;
  action.sa_flags = SA_ONSTACK;
  for (const int signal : failures)
    sigaction(signal, &action, nullptr);
  std::set_terminate(keep_words_and_abort);
}

Interruption::~Interruption()
{
  for (std::size_t i = 0; i < n_signals; ++i)
    std::signal(signals[i].first, SIG_IGN);
  wake(no_signal);
  waiting.join();
  close(read_end);
  close(write_end.exchange(-1));
  int not_over = -1; // an exception ends the program
  final_status.compare_exchange_strong(not_over, no_answer);
}

void Interruption::listen()
{
  std::atexit(end_unless_over);
  struct sigaction action = {};
  action.sa_handler = wake_on_signal;
  // System calls go on after a signal, until the thread ends the program.
  action.sa_flags = SA_RESTART;
  sigfillset(&action.sa_mask);
  for (std::size_t i = 0; i < n_signals; ++i)
  {
    const bool stays_ignored =
        signals[i].first == SIGHUP && previous[i].sa_handler == SIG_IGN;
    sigaction(signals[i].first, stays_ignored ? &previous[i] : &action,
              nullptr);
  }
}

void Interruption::is_over(const int status)
{
  final_status = status;
}

void Interruption::be_quiet()
{
  const std::lock_guard<std::mutex> lock(shared().mutex);
  shared().quiet = true;
}

void Interruption::clear_screen()
{
  const std::lock_guard<std::mutex> lock(shared().mutex);
  shared().screen = true;
}

Uninterrupted::Uninterrupted() : lock(shared().mutex) {}

void Uninterrupted::on_interruption(std::function<void()> undo)
{
  shared().undo = std::move(undo);
}

void Uninterrupted::state(const std::string &sentence)
{
  shared().state = sentence;
}
} // namespace Voussoir
