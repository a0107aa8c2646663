// SPDX-License-Identifier: LGPL-2.1-or-later

// Every kind of bad input ends with exit status 2, one message that says what
// is wrong and what to do, and no file written.

#include "own_directory.h"
#include "run_program.h"
#include "tests.h"
#include <filesystem>
#include <fstream>

namespace test_failures
{
namespace fs = std::filesystem;

void run(const std::vector<std::string> &arguments)
{
  const Ended ended = run_program(arguments);
  std::cout << "status " << ended.status
            << (fs::exists("output") ? " FILES " : " ") << ended.error;
}

/** Run the scene "Generator = Voronoi" of one cell with more settings. */
void run_with(const std::string &settings)
{
  std::ofstream("scene.prm") << "subsection Packing\n subsection Voronoi\n"
                                "  set Number of points = 3\n end\nend\n"
                             << settings;
  run({"scene.prm"});
}

void run_points(const std::string &points)
{
  std::ofstream("points.txt") << points;
  run_with("subsection Packing\n subsection Voronoi\n  set Points = file\n"
           "  set Points file = points.txt\n end\nend\n");
}

/** Run a whole scene, as bytes. */
void run_text(const std::string &text)
{
  std::ofstream("scene.prm", std::ios::binary) << text;
  run({"scene.prm"});
}

/** What is wrong with sections and assignments, and other encodings. */
void parameter_texts()
{
  const std::string wall = "subsection Packing\n set Generator = wall\n"
                           " subsection wall\n";
  run_text(wall + "  set Width = 4,0\n end\nend\n");
  run_text(wall + "  set Openings = 0,25, 0, 0,5, 0,5\n end\nend\n");
  run_text(wall + "  set Courses = 4,0\n end\nend\n");
  run_text(wall + "  Width = 4\n end\nend\n");
  run_text(wall + "  Width 4\n end\nend\n");
  run_text(wall + "  set Width 4 # m\n end\nend\n");
  run_text(wall + "  set Widht 4\n end\nend\n");
  std::string sections; // of which a copy for each line takes many minutes
  for (unsigned int k = 0; k < 300000; ++k)
    sections += "subsection a\n";
  run_text(sections);
  run_text("set \x1b[2J = 1\n");
  // ISO 8859-1, in which a comment may be.
  run_text("# f\xfcr alle\nset Title = Mauer f\xfcr alle # 1\n");
  run_text("# f\xfcr alle\nset Width = 1\n");
  std::ofstream("scene.xml") << "<?xml version=\"1.0\"?><ParameterHandler>"
                                "<Title>f\xfcr</Title></ParameterHandler>";
  run({"scene.xml"});
  std::ofstream("scene.json") << "{\"Title\": \"f\xfcr\"}";
  run({"scene.json"});
  run({"scene.prm", "--set", "Title=f\xfcr"});
  run_text(wall + " end\n");
  run_text(wall);
  run_text(wall + " end\nsubsection Loads\nend\n");
  run_text(wall + " end\n set Title = Wall\n");
  run_text(wall + "  set Generator = wall\n end\nend\n");
  run_text(wall + " end\nend\n\nend\n");
  run_text(wall + " end wall\nend\n");
  run_text("\xEF\xBB\xBF" + wall + "  Width\n end\nend\n");
  run_text({"\xFF\xFEs\0e\0t\0", 8});
  run_text({"\0s\0e\0t", 6});
  run_text("subsection Loads\n set Body force = 0; -0,5\nend\n");
  run({"scene.prm", "--set", "Packing/wall/Width=4,0"});
  run({"scene.prm", "--set", "Loads/Body force=0; -0.5", "--set",
       "Friction/Strength=0,5"});
  std::cout << "a byte order mark and ends of lines of Windows: ";
  run_text(
      "\xEF\xBB\xBFsubsection Packing\r\n set Generator = wall\r\nend\r\n");
  fs::remove_all("output");
}

void run()
{
  work_in_own_directory();

  // The command line
  run({});
  run({"no_such_file.prm"});
  run({"."});
  run({"a.prm", "b.prm"});
  run({"--unknown"});
  run({"--set"});
  run_with("");
  fs::remove_all("output");
  run({"scene.prm", "--nonsense%original_token%"});
  run({"scene.prm", "--quiet=%original_token%"});
  run({"scene.prm", "--set", "nonsense"});
  run({"scene.prm", "--set", "Friction/Strenght=1"});
  run({"scene.prm", "--set", "Frictions/Strength=1"});
  run({"scene.prm", "--set", "Load factor/Analysis=state"});
  run({"scene.prm", "--set", "Packing/Generator=magic"});

  // The parameter file
  run_with("set Tittle = x\n");
  run_with("subsection Packing\n set Generator = hexagons\nend\n");
  run_with("subsection Friction\n");
  run_with("rubbish\n");
  run_with("subsection Solver\n set Tolerance = -1\nend\n");
  // However long a value is, a message shows its beginning.
  run_with("subsection Solver\n set Tolerance = " + std::string(300000, '1') +
           "x\nend\n");
  run_with("subsection Packing\n subsection Voronoi\n"
           "  set Number of points = 0\n end\nend\n");
  parameter_texts();

  // What the results would overwrite
  run_with("set Output directory = .\nsubsection Output\n"
           " set Packing = WKT\nend\n");
  for (const char *file : {"./packing.wkt", "packing_centres.txt"})
    run_with(std::string("set Output directory = .\nsubsection Packing\n"
                         " set Generator = polygons\n subsection polygons\n"
                         "  set File = packing.wkt\n  set Centres file = ") +
             file + "\n end\nend\n");
  std::cout << "packing.wkt is kept: " << fs::exists("packing.wkt") << '\n';

  // Expressions
  run_with("subsection Friction\n set Strength = 1 +\nend\n");
  run_with("subsection Friction\n set Strength = -2\nend\n");
  run_with("subsection Friction\n set Strength = 0/0\nend\n");
  run_with("subsection Loads\n set Traction = nz; 0\nend\n");
  run_with("subsection Loads\n set Traction = 1\nend\n");

  // Nothing where an expression, or another value, must be
  run_with("");
  fs::remove_all("output");
  for (const char *setting :
       {"Friction/Strength=", "Contact/Tensile strength=", "Loads/Where=",
        "Supports/Where=", "Ranges/Where=", "Packing/Voronoi/Cell size=",
        "Loads/Traction=", "Loads/Traction=; 0", "Loads/Body force=; 0",
        "Loads/Body force=0; -1;", "Loads/Group body forces=block: ; 0",
        "Friction/Pair strengths=block,: 1", "Packing/Groups=a: 1 |",
        "Ranges/Joints=block,", "Ranges/Joints=block |",
        "Loads/Stress=", "Solver/Tolerance=", "Friction/Law="})
    run({"scene.prm", "--set", setting});
  for (const char *setting : {"Friction/Coefficient=", "Friction/Cohesion="})
    run({"scene.prm", "--set", "Friction/Law=associated Coulomb", "--set",
         setting});
  for (const char *setting :
       {"Supports/Displacement=; 0", "Supports/Displacement=0; 1;",
        "Supports/Group displacements=block: ; 0"})
    run({"scene.prm", "--set", "Supports/Where=ny < -0.5", "--set", setting});

  // Points
  run_points("0.5 0.5\n0.25\n");
  run_points("0.5 0.5\n0.25 a\n");
  run_points("0.5 0.5\n0.25 0.25\n0.5 0.5\n");
  run_points("0.5 0.5\n0.25 2\n");
  run_points("# none\n");
  run_points("\xEF\xBB\xBF"
             "0,5 0,25\n");
  run_points("0,5\t0,25,0\n");
  run_points(std::string("0\0.\0", 4));
  fs::remove("points.txt");
  run_with("subsection Packing\n subsection Voronoi\n  set Points = file\n"
           "  set Points file = points.txt\n end\nend\n");

  // Polygons
  std::ofstream("bow_tie.wkt") << "POLYGON ((0 0, 1 1, 1 0, 0 1, 0 0))\n";
  run_with("subsection Packing\n set Generator = polygons\n"
           " subsection polygons\n  set File = bow_tie.wkt\n end\nend\n");

  // Geometry, loads, and the rest
  run_with("subsection Packing\n set Generator = wall\n"
           " subsection wall\n  set Width = 0\n end\nend\n");
  run_with("subsection Packing\n subsection Voronoi\n"
           "  set Upper right = 0, 1\n end\nend\n");
  run_with("subsection Loads\n set Traction = 1; 0\nend\n");
  run_with("subsection Solver\n subsection smoothed friction\n"
           "  set Smoothing length = 0\n end\nend\n");
  run_with("set Output directory = /dev/null/results\n");
  run_with("set Output directory =\n");
  run_with("include scene.prm\n");

  // A solver that is not given the iterations it needs writes nothing either.
  run_with("subsection Loads\n set Traction = -1.3*nx; -0.7*ny\nend\n"
           "subsection Packing\n subsection Voronoi\n"
           "  set Number of points = 200\n end\nend\n"
           "subsection Friction\n set Strength = 0.3\nend\n"
           "subsection Solver\n set Maximum iterations = 1\nend\n");

  // A state that is balanced as well as the tolerance says is one.
  run_with("set Formulation = least energy\n"
           "subsection Loads\n set Traction = -0.6*nx; -1.4*ny\nend\n"
           "subsection Packing\n subsection Voronoi\n"
           "  set Number of points = 200\n end\nend\n"
           "subsection Friction\n set Strength = 0.3\nend\n"
           "subsection Solver\n set Tolerance = 0.01\nend\n");
  run({"scene.prm", "--quiet"});
  fs::remove_all("output");

  // Load factors
  run_with("set Analysis = load factor\n");
  run_with("set Analysis = load factor\nset Forces from = output\n");
  run_with("subsection Friction\n set Law = associated Coulomb\n"
           " set Coefficient = -0.5\nend\n");

  // Strengths as a factor
  run_with("set Analysis = load factor\n"
           "subsection Load factor\n set Factor = strength\nend\n"
           "subsection Packing\n set Generator = wall\n subsection wall\n"
           "  set Courses = 12\n  set Bricks per course = 6\n"
           "  set Width = 1\n  set Height = 1\n end\nend\n"
           "subsection Loads\n set Traction = ny; 0\nend\n"
           "subsection Friction\n set Strength = 10\nend\n"
           "subsection Solver\n set Maximum iterations = 4\nend\n");
  const std::string strength =
      "set Analysis = load factor\nset Rotations = true\n"
      "subsection Load factor\n set Factor = strength\nend\n"
      "subsection Packing\n set Generator = wall\n subsection wall\n"
      "  set Courses = 1\n  set Bricks per course = 1\n end\nend\n"
      "subsection Supports\n set Where = y < 1e-9\nend\n";
  const std::string loads = "subsection Loads\n set Body force = 3; -1\nend\n";
  const std::string associated =
      "subsection Friction\n set Law = associated Coulomb\nend\n";
  run_with(strength);
  run_with(strength + loads);
  fs::remove_all("output");
  run_with(strength + loads +
           "subsection Load factor\n set Direction = least\nend\n");
  run_with(strength + loads + associated);
  fs::remove_all("output");
  run_with(strength + loads + "subsection Friction\n set Law = Coulomb\nend\n");

  // Tension and crushing
  run_with("subsection Contact\n set Compressive strength = 0\nend\n");
  run_with("subsection Contact\n set Tensile strength = -x\nend\n");
  run_with("subsection Contact\n set Tensile strength = 0.1\nend\n"
           "subsection Friction\n set Law = associated Coulomb\n"
           " set Cohesion = 0.05\nend\n");
}

const RoomTest test("failures", run);
} // namespace test_failures
