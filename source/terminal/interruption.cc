// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/terminal/interruption.h>
#include <voussoir/terminal/screen.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <fcntl.h>
#include <iterator>
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
[[noreturn]] void end(const int signal)
{
  // Not unlocked: no thread may write any more.
  shared().mutex.lock();
  try
  {
    if (shared().undo)
      shared().undo();
    if (shared().quiet)
      std::this_thread::sleep_for(head_start);
    else
      say(signal);
  }
  catch (...) // no memory: then at least end
  {}
  _exit(status_of_signals + signal);
}

void wait_for_signals(const int read_end)
{
  // Also SIGPIPE, should the reader of the message have been interrupted, too.
  sigset_t all;
  sigfillset(&all);
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
}

Interruption::~Interruption()
{
  for (std::size_t i = 0; i < n_signals; ++i)
    std::signal(signals[i].first, SIG_IGN);
  wake(no_signal);
  waiting.join();
  close(read_end);
  close(write_end.exchange(-1));
}

void Interruption::listen()
{
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
