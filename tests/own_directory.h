// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_tests_own_directory_h
#define voussoir_tests_own_directory_h

#include <filesystem>

/**
 * Go on in an empty directory of the test's own: the runner of the tests uses
 * the name "output" in the one that it starts them in.
 */
inline void work_in_own_directory()
{
  namespace fs = std::filesystem;
  fs::remove_all("run");
  fs::create_directory("run");
  fs::current_path("run");
}

#endif
