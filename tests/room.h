// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_tests_room_h
#define voussoir_tests_room_h

#include <map>
#include <string>

// The tests of a folder are one program, which is compiled and linked in a
// fraction of the time of many. Each test is a file with a namespace and a
// RoomTest of its own; to ctest it is a test of its own.

/** A test of this program, under the name of its file. */
struct RoomTest
{
  using Run = void (*)();

  RoomTest(const std::string &name, const Run run) { all().emplace(name, run); }

  /** The tests that the files of this program have. */
  static std::map<std::string, Run> &all()
  {
    static std::map<std::string, Run> tests;
    return tests;
  }
};

#endif
