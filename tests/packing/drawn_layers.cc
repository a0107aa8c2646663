// SPDX-License-Identifier: LGPL-2.1-or-later

// Layers of a DXF file are chosen and grouped, messages say layers, handles and
// scaled coordinates, and open lines are in the pictures of faults.

#include <voussoir/base/text_file.h>
#include <voussoir/run/command_line/command_line.h>

#include "dxf.h"
#include "tests.h"
#include <regex>

namespace test_drawn_layers
{
using namespace Voussoir;
using namespace drawn;

/** Stones on three layers, a dimension and a text. */
Dxf three_layers()
{
  Dxf drawing;
  drawing.lwpolyline("pier left", {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  drawing.lwpolyline("pier right", {{2, 0}, {3, 0}, {3, 1}, {2, 1}});
  drawing.lwpolyline("LINTEL", {{0, 1}, {3, 1}, {3, 2}, {0, 2}});
  drawing.line("dimensions", {0, -1}, {3, -1.5});
  drawing.text_entity("dimensions");
  return drawing;
}

void layers()
{
  const Dxf drawing = three_layers();
  const CellLoops stones = cells_of(drawing, {{"Layers", "pier *, LINTEL"}});
  check("chosen layers",
        stones.n_cells() == 3 && stones.notices.empty() &&
            stones.group_names == std::vector<std::string>(
                                      {"pier left", "pier right", "LINTEL"}));
  check("a layer by each wildcard",
        cells_of(drawing, {{"Layers", "pier ?eft, [KL]INTEL"}}).n_cells() == 2);
  const CellLoops grouped =
      cells_of(drawing, {{"Layers", "pier *, LINTEL"},
                         {"Layer groups", "*right: abutment | pier*: pier"}});
  check("groups of layers, the first that fits",
        grouped.group_names ==
            std::vector<std::string>({"pier", "abutment", "LINTEL"}));
  for (const Parameters &parameters : std::vector<Parameters>{
           {{"Layers", "pier *, lintel"}},
           {{"Layers", "dimensions"}, {"Lines", "ignore"}},
           {{"Layers", "pier *,"}},
           {{"Layers", "pier *"}, {"Layer groups", "LINTEL: beam"}},
           {{"Layer groups", "beam"}}})
    show_refusal([&] { cells_of(drawing, parameters); });
  Dxf words;
  words.text_entity("dimensions");
  show_refusal([&] { cells_of(words); });
}

/** Messages have layers, handles or ids, and scaled coordinates. */
void messages()
{
  const Parameters in_mm = {{"Scale", "0.001"}};
  const auto wide = [](const std::string &layer, const double x,
                       const double y) {
    return std::make_pair(
        layer,
        Vertices({{x, y}, {x + 1000, y}, {x + 1000, y + 1000}, {x, y + 1000}}));
  };
  const auto drawn =
      [&](const std::vector<std::pair<std::string, Vertices>> &stones) {
        Dxf drawing;
        for (const auto &[layer, vertices] : stones)
          drawing.lwpolyline(layer, vertices);
        return drawing;
      };
  show_refusal([&] {
    cells_of(drawn({wide("pier", 0, 0), wide("arch", 900, 0)}), in_mm);
  });
  show_refusal([&] {
    cells_of(drawn({{"pier", {{0, 0}, {1000, 1000}, {1000, 0}, {0, 1000}}}}),
             in_mm);
  });
  Dxf open = three_layers();
  show_refusal([&] { cells_of(open, in_mm); });
  write_file("lines.geojson",
             R"({"type": "FeatureCollection", "features": [
      {"type": "Feature", "properties": {}, "geometry": {"type": "LineString",
       "coordinates": [[0, 0], [1000, 0], [1000, 1000], [1, 1]]}}]})");
  show_refusal([&] { imported_cells("lines.geojson", in_mm); });
  const CellLoops cells =
      cells_of(drawn({wide("pier", 0, 0), wide("arch", 1020, 0)}), in_mm);
  std::cout << cells.describe(1) << '\n' << cells.notices.at(0) << std::endl;
  Dxf fine;
  fine.circle("pier", {0, 0}, 1000.);
  show_refusal([&] {
    cells_of(fine, {{"Scale", "0.001"}, {"Arc tolerance", "1e-12"}});
  });
}

/** Open lines are in the pictures of a drawing with several faults. */
void pictures()
{
  Dxf drawing = three_layers();
  drawing.lwpolyline("pier left", {{0, 2}, {1, 2, 0.5}, {1, 3}}, false);
  drawing.write();
  write_file("scene.prm", "set Output directory = faulty\n"
                          "subsection Packing\n"
                          "  set Generator = polygons\n"
                          "  subsection polygons\n"
                          "    set File = drawing.dxf\n"
                          "    set Scale = 0.1\n"
                          "  end\n"
                          "end\n");
  std::ostringstream out, error;
  const int status = run_command_line({"scene.prm", "--quiet"}, out, error);
  std::cout << "status " << status << '\n' << error.str();
  const std::string page = *read_text_file("faulty/drawing_check.html"),
                    grid = *read_text_file("faulty/drawing_check.vtu");
  const std::regex lines("class=\"open\"");
  check("both open lines are on the page",
        std::distance(std::sregex_iterator(page.begin(), page.end(), lines),
                      std::sregex_iterator()) == 2);
  check("and in the grid, with three stones",
        grid.find("NumberOfCells=\"5\"") != std::string::npos);
}

void run()
{
  layers();
  messages();
  pictures();
}

const RoomTest test("drawn_layers", run);
} // namespace test_drawn_layers
