// SPDX-License-Identifier: LGPL-2.1-or-later

// Every kind of broken geometry ends the program with status 2, and the cell,
// the line, the place and what to do; nothing is written.

#include <voussoir/run/command_line/command_line.h>

#include "polygons.h"
#include "tests.h"
#include <filesystem>

namespace test_polygon_failures
{
using namespace Voussoir;

const std::string square = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n";

void refuse(const std::string &kind,
            const std::string &content,
            const std::string &tolerance = "0",
            const std::string &file = "broken.wkt")
{
  write_file(file, content);
  write_file("broken.prm", "set Output directory = results\n"
                           "subsection Packing\n"
                           "  set Generator = polygons\n"
                           "  subsection polygons\n"
                           "    set File = " +
                               file +
                               "\n"
                               "    set Matching tolerance = " +
                               tolerance +
                               "\n"
                               "  end\n"
                               "end\n");
  std::ostringstream out, error;
  const int status = run_command_line({"broken.prm"}, out, error);
  std::cout << "[" << kind << "] status " << status << '\n'
            << error.str() << out.str();
  if (std::filesystem::exists("results"))
    std::cout << "FAILED: something was written" << std::endl;
}

/** A whole square in line 1, and in line 2 what is broken. */
void refuse_second(const std::string &kind, const std::string &content)
{
  refuse(kind, square + content + "\n");
}

void test_rings()
{
  refuse_second("self-crossing", "POLYGON ((2 0, 3 1, 3 0, 2 1, 2 0))");
  refuse_second("touching itself in a vertex",
                "POLYGON ((2 0, 3 0, 3 1, 4 1, 4 2, 3 1, 2 1, 2 0))");
  refuse_second("spike", "POLYGON ((2 0, 3 0, 3 2, 3 1, 2 1, 2 0))");
  refuse_second("zero area", "POLYGON ((2 0, 3 1, 4 2, 2 0))");
  refuse_second("sliver", "POLYGON ((2 0, 3 0, 3 1e-7, 2 0))");
  refuse_second("repeated vertex", "POLYGON ((2 0, 3 0, 3 0, 3 1, 2 1, 2 0))");
  refuse_second("two vertices", "POLYGON ((2 0, 3 0, 2 0))");
  refuse_second("one vertex", "POLYGON ((2 0))");
  refuse_second("unclosed ring", "POLYGON ((2 0, 3 0, 3 1, 2 1))");
  refuse_second("not a number", "POLYGON ((2 0, 3 nan, 3 1, 2 1, 2 0))");
  refuse_second("infinite", "POLYGON ((2 0, 3 0, inf 1, 2 1, 2 0))");
  refuse_second("too large", "POLYGON ((2 0, 1e200 0, 1e200 1e200, 2 0))");
  refuse_second("hole", "POLYGON ((2 0, 5 0, 5 3, 2 3, 2 0),"
                        " (3 1, 4 1, 4 2, 3 2, 3 1))");
  refuse_second("hole in the second part",
                "MULTIPOLYGON (((2 0, 3 0, 3 1, 2 1, 2 0)),"
                " ((4 0, 9 0, 9 9, 4 0), (6 1, 7 1, 7 2, 6 1)))");
}

void test_wkt()
{
  refuse_second("another tag", "LINESTRING (2 0, 3 0, 3 1, 2 0)");
  refuse_second("mixed tags", "GEOMETRYCOLLECTION (POLYGON ((2 0, 3 0, 3 1, "
                              "2 0)), POINT (0 0))");
  refuse_second(
      "two polygons in a line",
      "POLYGON ((2 0, 3 0, 3 1, 2 0)) POLYGON ((4 0, 5 0, 5 1, 4 0))");
  refuse_second("no polygon", "POLYGON EMPTY");
  refuse_second("no polygons", "MULTIPOLYGON ()");
  refuse_second("no ring", "POLYGON ()");
  refuse_second("no vertex", "POLYGON (())");
  refuse_second("unbalanced parentheses", "POLYGON ((2 0, 3 0, 3 1, 2 0)");
  refuse_second("too few parentheses", "POLYGON (2 0, 3 0, 3 1, 2 0)");
  refuse_second("too many parentheses", "POLYGON (((2 0, 3 0, 3 1, 2 0)))");
  refuse_second("a polygon called MULTIPOLYGON",
                "MULTIPOLYGON ((2 0, 3 0, 3 1, 2 0))");
  refuse_second("missing ordinate", "POLYGON ((2 0, 3, 3 1, 2 0))");
  refuse_second("missing comma", "POLYGON ((2 0 3 0, 3 1, 2 0))");
  refuse_second("missing vertex", "POLYGON ((2 0, 3 0,, 3 1, 2 0))");
  refuse_second("decimal commas", "POLYGON ((2,5 0,0, 3,5 0,0, 3,5 1, 2,5 0))");
  refuse_second("Z where the tag says none",
                "POLYGON Z ((2 0, 3 0, 3 1, 2 0))");
  refuse_second("a word", "POLYGON ((2 0, 3 zero, 3 1, 2 0))");
  refuse_second("beyond all numbers", "POLYGON ((2 0, 1e999 0, 3 1, 2 0))");
  refuse_second("two names", "POLYGON ((2 0, 3 0, 3 1, 2 0));a;b");
  refuse_second("the name of the ground",
                "POLYGON ((2 0, 3 0, 3 1, 2 0));ground");
  refuse_second("a name that is no text",
                "POLYGON ((2 0, 3 0, 3 1, 2 0));b\xe9ton");
  refuse_second("too small", "POLYGON ((2e-90 0, 3e-90 0, 3e-90 1e-90, "
                             "2e-90 0))");
  refuse_second("only a reference system", "SRID=4326");
  refuse_second("bytes", std::string("\0\1\2", 3));
  refuse("empty file", "");
  refuse("only comments", "# POLYGON ((0 0, 1 0, 0 1, 0 0))\n\n");
  refuse("huge line of words", std::string(10000000, 'x'));
  refuse("huge line of vertices", [] {
    std::string line = "POLYGON ((0 0";
    for (unsigned int i = 1; i < 100000; ++i)
      line += ", " + std::to_string(i) + " " + std::to_string(i % 2);
    return line;
  }());
}

void test_pairs()
{
  refuse_second("overlap",
                "POLYGON ((0.75 0.5, 2 0.5, 2 1, 0.75 1, 0.75 0.5))");
  refuse_second("the same polygon twice", square);
  refuse_second("one within the other",
                "POLYGON ((0.25 0.25, 0.5 0.25, 0.5 0.5, 0.25 0.25))");
  refuse_second("a vertex in the other",
                "POLYGON ((0.5 0.9, 1 2, 0 2, 0.5 0.9))");
  refuse_second("a cross without a vertex in the other",
                "POLYGON ((-1 0.25, 2 0.25, 2 0.75, -1 0.75, -1 0.25))");
  refuse_second(
      "the parts of one feature overlap",
      "MULTIPOLYGON (((2 0, 3 0, 3 1, 2 0)), ((2 0, 3 0, 3 1, 2 0)))");
  refuse_second("in the arms of one that is not convex",
                "POLYGON ((2 0, 5 0, 5 3, 4 3, 4 1, 3 1, 3 3, 2 3, 2 0))\n"
                "POLYGON ((3.5 0.5, 4 1, 4 2, 3 2, 3 1, 3.5 0.5))");
  refuse("overlap deeper than the tolerance",
         square + "POLYGON ((0.98 0, 2 0, 2 1, 0.98 1, 0.98 0))\n", "0.01");
}

void test_tolerance()
{
  refuse("thinner than the tolerance",
         "POLYGON ((0 0, 1 0, 1 0.01, 0 0.01, 0 0))", "0.02");
  refuse("tolerance below rounding",
         "POLYGON ((1e6 0, 1000001 0, 1000001 1, 1e6 0))", "1e-12");
  refuse("corner within the tolerance of another side",
         "POLYGON ((0 0, 1 0, 1 1, 0.5 0.004, 0 1, 0 0))", "0.01");
  refuse("chain of short sides",
         "POLYGON ((0 0, 1 0, 1 1, 0.99 1.009, 0.98 1.018, 0.97 1.027, "
         "0.96 1.036, 0 0.9, 0 0))",
         "0.015");
}

void test_off()
{
  const auto refuse_off = [](const std::string &kind,
                             const std::string &content) {
    refuse(kind, content, "0", "broken.off");
  };
  refuse_off("empty OFF", "");
  refuse_off("no header", "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  refuse_off("no faces", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n");
  refuse_off("truncated", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n");
  refuse_off("too many announced", "OFF\n2000000000 1 0\n0 0 0\n");
  refuse_off("vertex of two numbers", "OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2");
  refuse_off("not a number", "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n");
  refuse_off("unknown vertex", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n");
  refuse_off("negative vertex", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 -1 2\n");
  refuse_off("missing vertex", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n");
  refuse_off("self-crossing face",
             "OFF\n4 1 0\n0 0 0\n1 1 0\n1 0 0\n0 1 0\n4 0 1 2 3\n");
}

void test_files()
{
  std::filesystem::remove("missing.wkt");
  show_refusal([] { imported_cells("missing.wkt"); });
  show_refusal([] { imported_cells(""); });
  std::filesystem::create_directory("directory.wkt");
  show_refusal([] { imported_cells("directory.wkt"); });

  write_file("square.wkt", square);
  write_file("centres.txt", "0.5 0.5\n0.25 0.25\n");
  show_refusal([] {
    imported_cells("square.wkt", {{"Centres file", "centres.txt"}});
  });
}

void run()
{
  test_rings();
  test_wkt();
  test_pairs();
  test_tolerance();
  test_off();
  test_files();
}

const RoomTest test("polygon_failures", run);
} // namespace test_polygon_failures
