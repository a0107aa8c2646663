// SPDX-License-Identifier: LGPL-2.1-or-later

// Points files: the separators and comments that are read, and the lines that
// are not.

#include <voussoir/packing/points_file.h>

#include "tests.h"
#include <fstream>

namespace test_points_file
{
using namespace Voussoir;

PointList<2> read(const std::string &content)
{
  std::ofstream("points.txt") << content;
  return read_points_file<2>("points.txt");
}

void run()
{
  const PointList<2> list =
      read("# x y\n1 2\n\n 3,4 # a comment\r\n\t5;\t6e-1\n"
           "-.5 +1E2\n");
  for (unsigned int i = 0; i < list.points.size(); ++i)
    std::cout << list.describe(i) << std::endl;

  for (const char *content : {"", "# nothing\n", "1 2\n3\n", "1 2 3\n",
                              "1 2\nx y\n", "1 nan\n", "inf 1\n", "1.5.2 3\n"})
    show_refusal([&] { read(content); });
  show_refusal([] { read_points_file<2>("."); });
}

const RoomTest test("points_file", run);
} // namespace test_points_file
