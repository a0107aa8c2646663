// SPDX-License-Identifier: LGPL-2.1-or-later

// A function beside: by another thread, or at once by this one; its result, its
// exception, and traps of invalid operations as here.

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
  auto at_once = beside(false, function);
  check("it is called at once", there == here);
  check("the result", at_once.get() == 42);

  for (const bool trapped : {true, false})
  {
    const InvalidOperationsTrapped as(trapped);
    const bool are_here = Voussoir::invalid_operations_are_trapped();
    check("the result", beside(true, function).get() == 42);
    check("another thread has called it", there != here);
    check("with the traps of this one", are_trapped == are_here);
  }

  const unsigned int n_threads = dealii::MultithreadInfo::n_threads();
  dealii::MultithreadInfo::set_thread_limit(1);
  check("with one thread there is no other", !has_other_threads());
  dealii::MultithreadInfo::set_thread_limit(n_threads);

  for (const bool by_another : {true, false})
  {
    const auto fails = []() -> int { throw std::runtime_error("as it is"); };
    auto failed = beside(by_another, fails);
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
}

const RoomTest test("beside", run);
} // namespace test_beside
