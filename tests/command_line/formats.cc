// SPDX-License-Identifier: LGPL-2.1-or-later

// Files of parameters in JSON and XML: each scene of prm/ goes through both and
// through its listings unchanged, a run gives the same forces, and faults are
// named by line or entry.

#include "own_directory.h"
#include "run_program.h"
#include "tests.h"
#include <algorithm>
#include <filesystem>
#include <fstream>

namespace test_formats
{
namespace fs = std::filesystem;

void write_file(const std::string &file, const std::string &text)
{
  std::ofstream(file) << text;
}

/** What the program prints, or its message behind the status. */
std::string run_with(const std::vector<std::string> &words)
{
  const Ended ended = run_program(words);
  return ended.status == 0 ? ended.out : ended.message();
}

void try_scenes()
{
  std::vector<std::string> scenes;
  for (const auto &file : fs::directory_iterator(SOURCE_DIR "/../../prm"))
    if (file.path().extension() == ".prm")
      scenes.push_back(file.path());
  std::sort(scenes.begin(), scenes.end());
  std::string differ;
  for (const std::string &scene : scenes)
  {
    const std::string settings = run_with({scene, "--print-settings"});
    const std::string listing = run_with({scene, "--print-parameters"});
    for (const std::string format : {"prm", "json", "xml"})
    {
      const std::string file = "scene." + format;
      write_file(file, run_with({scene, "--print-settings", "--as", format}));
      const bool same_settings =
          run_with({file, "--print-settings"}) == settings &&
          run_with({file, "--print-parameters"}) == listing;
      write_file(file, run_with({scene, "--print-parameters", "--as", format}));
      // A listing does not say that a default was set.
      if (!same_settings || run_with({file, "--print-parameters"}) != listing)
        differ += ' ' + scene + " (" + format + ')';
    }
  }
  check("there are scenes", scenes.size() > 20);
  check("scenes stay the same as .prm, .json and .xml" + differ,
        differ.empty());
}

const std::string wall = R"({
  "$schema": "voussoir.schema.json",
  "Output directory": "of_json",
  "Rotations": true,
  "Packing": {"Generator": "wall", "wall": {"Courses": 3, "Width": 2.5}},
  "Supports": {"Where": "ny < -0.5"},
  "Load cases": {"dead": {"Body force": "0; -1"}},
  "Loads": {"Combination": "dead"},
  "Friction": {"Strength": 1e2, "Law": {"value": "Tresca"}}
})";

void try_runs()
{
  write_file("wall.json", wall);
  std::cout << run_with({"wall.json", "--print-settings"});
  write_file("wall.prm", run_with({"wall.json", "--print-settings", "--set",
                                   "Output directory=of_prm"}));
  write_file("WALL.XML", run_with({"wall.json", "--print-settings", "--as",
                                   "xml", "--set", "Output directory=of_xml"}));
  for (const char *file : {"wall.json", "wall.prm", "WALL.XML"})
    check(file, run_with({file, "--quiet"}).empty());
  const std::string forces = content_of("of_json/interfaces.csv");
  check("the same forces", forces.size() > 1000 &&
                               content_of("of_prm/interfaces.csv") == forces &&
                               content_of("of_xml/interfaces.csv") == forces);
  std::cout << run_with({"--print-parameters=Packing/arch"})
            << run_with({"wall.json", "--print-settings",
                         "--print-parameters=Packing"})
            << run_with({"--print-parameters=Packing/arhc"})
            << run_with({"--print-parameters", "--as", "yaml"})
            << run_with({"wall.json", "--as", "xml"})
            << run_with({"wall.json", "--set", "Output/Directory=here"});
  check("# begins no comment on the command line",
        run_with({"wall.json", "--print-settings", "--set", "Title=a # b"})
                .find("set Title            = a # b") != std::string::npos);
}

/** The message if something in a text is replaced. */
void show_fault(const std::string &file,
                std::string text,
                const std::string &what,
                const std::string &by)
{
  text.replace(text.find(what), what.size(), by);
  write_file(file, text);
  std::cout << run_with({file});
}

void try_faults()
{
  const auto of_json = [](const std::string &what, const std::string &by) {
    show_fault("fault.json", wall, what, by);
  };
  of_json("\"Strength\"", "\"Strenght\"");
  of_json("\"Friction\"", "\"Fricton\"");
  of_json("\"Courses\": 3", "\"Courses\": 3.5");
  of_json("\"wall\": {\"Courses\": 3, \"Width\": 2.5}", "\"wall\": 3");
  of_json("\"0; -1\"", "[0, -1]");
  of_json("\"Courses\": 3", "\"Courses\": \"3\n\"");
  of_json("\"Where\": ", "\"Where\" ");
  of_json("}\n}", "}");
  write_file("fault.json", "3");
  std::cout << run_with({"fault.json"});
  write_file("fault.json", std::string(100000, '['));
  std::cout << run_with({"fault.json"});

  const std::string xml = "<?xml version=\"1.0\"?>\n"
                          "<!-- a wall -->\n"
                          "<ParameterHandler>\n"
                          "<Packing><Generator>wall</Generator>\n"
                          "<wall><Bricks_20per_20course>3\n"
                          "</Bricks_20per_20course></wall></Packing>\n"
                          "</ParameterHandler>\n";
  write_file("wall.xml", xml);
  std::cout << run_with({"wall.xml", "--print-settings"});
  const auto of_xml = [&](const std::string &what, const std::string &by) {
    show_fault("fault.xml", xml, what, by);
  };
  of_xml("<Packing>", "<Packing");
  of_xml("<Generator>wall</Generator>", "<Genrator>wall</Genrator>");
  of_xml("<ParameterHandler>\n", "<Parameters>\n");
  of_xml(">wall<", ">wal<");
  show_fault("fault.xml", "<a></a>", "a", "b");

  // Whatever hides their number from a count of braces or tags.
  const auto repeated = [](const std::string &level, const unsigned int n) {
    std::string all;
    for (unsigned int k = 0; k < n; ++k)
      all += level;
    return all;
  };
  constexpr unsigned int n_levels = 100000;
  write_file("fault.json", repeated("{\"}\\\"}\": ", n_levels));
  std::cout << run_with({"fault.json"});
  for (const std::string level :
       {"<a>", "<a b=\"/>\">", "<a b = '</a>' c='\"'>", "<a\" b='/>'>", "<a>/>",
        "<a><!--</a>-->", "<a><![CDATA[</a>]]>", "<a><?</a>?>",
        "<a><!DOCTYPE [</a>] >", "<a><!b </a>"})
  {
    write_file("fault.xml", "<ParameterHandler>" + repeated(level, n_levels));
    std::cout << run_with({"fault.xml"});
  }
  // And what is not deep, however long.
  write_file("long.xml",
             "<?xml version='1.0'?><!DOCTYPE a [<!ENTITY b '>'>]>"
             "<ParameterHandler>" +
                 repeated("<Title at=\"'>\" >a</Title ><Title/>", 1000) +
                 "<Title>b</Title></ParameterHandler>");
  check("a long file",
        run_with({"long.xml", "--print-settings"}) == "set Title = b\n");
}

void run()
{
  work_in_own_directory();
  try_scenes();
  try_runs();
  try_faults();
}

const RoomTest test("formats", run);
} // namespace test_formats
