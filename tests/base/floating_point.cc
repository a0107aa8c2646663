// SPDX-License-Identifier: LGPL-2.1-or-later

// Invalid floating-point operations end the program in Debug, in the main
// thread and in those of tasks, but for where they are allowed; in Release they
// give NaN.

#include <deal.II/base/multithread_info.h>
#include <deal.II/base/work_stream.h>

#include "tests.h"
#include <atomic>
#include <csignal>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace test_floating_point
{
/** Not known to the compiler. */
volatile double zero = 0.;
volatile double result;

void divide_zero_by_zero()
{
  result = zero / zero;
}

/** Whether a process of its own is ended by SIGFPE in @p action. */
bool is_trapped(const std::function<void()> &action)
{
  const pid_t child = fork();
  if (child == 0)
  {
    // Neither a core file's nor a sanitizer's business.
    std::signal(SIGFPE, SIG_DFL);
    action();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status))
    return WTERMSIG(status) == SIGFPE;
  if (WEXITSTATUS(status) != 0)
    throw std::runtime_error("The child failed.");
  return false;
}

/** Divide in one of WorkStream's threads that is not this one. */
void divide_in_a_task()
{
  const std::thread::id main_thread = std::this_thread::get_id();
  std::atomic<bool> divided(dealii::MultithreadInfo::n_threads() == 1);
  std::vector<unsigned int> items(1000);
  const auto work = [&](const std::vector<unsigned int>::iterator &, int &,
                        int &) {
    if (divided || std::this_thread::get_id() != main_thread)
    {
      divide_zero_by_zero();
      divided = true;
    }
    else
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
  };
  dealii::WorkStream::run(
      items.begin(), items.end(), work, [](const int &) {}, 0, 0);
  if (!divided)
    _exit(1);
}

void run()
{
#if defined(DEBUG) && defined(__GLIBC__)
  const bool expected = true;
#else
  const bool expected = false;
#endif

  check("0/0", is_trapped(divide_zero_by_zero) == expected);
  check("sqrt(-1)",
        is_trapped([] { result = std::sqrt(zero - 1.); }) == expected);
  check("NaN < 0", is_trapped([] {
                     volatile double nan =
                         std::numeric_limits<double>::quiet_NaN();
                     result = nan < zero;
                   }) == expected);
  check("0/0 in a task", is_trapped(divide_in_a_task) == expected);
  check("0/0 in a thread", is_trapped([] {
                             std::thread(divide_zero_by_zero).join();
                           }) == expected);

  check("0/0 where it is allowed", !is_trapped([] {
          const Voussoir::InvalidOperationsAllowed allowed;
          divide_zero_by_zero();
        }));
  check("0/0 behind it", is_trapped([] {
                           {
                             const Voussoir::InvalidOperationsAllowed allowed;
                             divide_zero_by_zero();
                           }
                           divide_zero_by_zero();
                         }) == expected);
  check("0/0 between two", is_trapped([] {
                             const Voussoir::InvalidOperationsAllowed outer;
                             {
                               const Voussoir::InvalidOperationsAllowed inner;
                             }
                             divide_zero_by_zero();
                           }) == false);
  check("1/0 is infinite", !is_trapped([] { result = 1. / zero; }));
}

const RoomTest test("floating_point", run);
} // namespace test_floating_point
