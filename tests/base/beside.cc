// SPDX-License-Identifier: LGPL-2.1-or-later

// A function beside: by another thread if that is worth it and there are
// several, by this one at once if not; its result, its exception, and traps of
// invalid operations as here.

#include <voussoir/base/beside.h>

#include "tests.h"
#include <stdexcept>
#include <thread>

namespace test_beside
{
using namespace Voussoir;

void run()
{
  const auto here = std::this_thread::get_id();
  std::thread::id there;
  bool are_trapped = false;
  const auto function = [&] {
    there = std::this_thread::get_id();
    are_trapped = Voussoir::invalid_operations_are_trapped();
    return 42;
  };
  const unsigned int n_threads = dealii::MultithreadInfo::n_threads();
  auto at_once = beside(false, function);
  check("it is called at once", there == here);
  check("the result", at_once.get() == 42);

  dealii::MultithreadInfo::set_thread_limit(1);
  there = {};
  auto alone = beside(true, function);
  check("so it is with one thread", there == here);
  check("the result", alone.get() == 42);

  dealii::MultithreadInfo::set_thread_limit(2);
  if (dealii::MultithreadInfo::n_threads() > 1)
  {
    for (const bool trapped : {true, false})
    {
      const InvalidOperationsTrapped as(trapped);
      const bool are_here = Voussoir::invalid_operations_are_trapped();
      check("the result", beside(true, function).get() == 42);
      check("another thread has called it", there != here);
      check("with the traps of this one", are_trapped == are_here);
    }
  }
  else // OpenBLAS without threads, or one core
    for (unsigned int k = 0; k < 6; ++k)
      check(k % 3 == 0   ? "the result"
            : k % 3 == 1 ? "another thread has called it"
                         : "with the traps of this one",
            true);

  for (const bool is_worth : {true, false})
  {
    const auto fails = []() -> int { throw std::runtime_error("as it is"); };
    auto failed = beside(is_worth, fails);
    try
    {
      failed.get();
      check("the exception", false);
    }
    catch (const std::runtime_error &error)
    {
      check("the exception", std::string(error.what()) == "as it is");
    }
  }
  dealii::MultithreadInfo::set_thread_limit(n_threads);
}

const RoomTest test("beside", run);
} // namespace test_beside
