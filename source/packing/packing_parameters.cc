// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/cell_groups.h>
#include <voussoir/packing/generators/arch.h>
#include <voussoir/packing/generators/honeycomb.h>
#include <voussoir/packing/generators/perturbed_grid.h>
#include <voussoir/packing/generators/wall.h>
#include <voussoir/packing/packing_parameters.h>
#include <voussoir/packing/polygons/corner_contacts.h>
#include <voussoir/packing/polygons/polygons.h>
#include <voussoir/packing/voronoi/voronoi.h>

#include <utility>

namespace Voussoir
{
PackingParameters<2>::PackingParameters()
{
  // The one place where a generator is registered.
  generators.add<VoronoiGenerator>();
  generators.add<WallGenerator>();
  generators.add<ArchGenerator>();
  generators.add<HoneycombGenerator>();
  generators.add<PerturbedGridGenerator>();
  polygons = generators.add<PolygonGenerator>();
}

void PackingParameters<2>::add_parameters(dealii::ParameterHandler &prm)
{
  prm.enter_subsection("Packing");
  generators.add_parameters(prm);
  prm.add_parameter(
      "Groups", groups,
      "Names for groups of cells, \"name: condition | name: condition\", with "
      "expressions in the coordinates x, y of a cell's centre. Of the "
      "conditions that a cell meets the last one counts; a cell that meets "
      "none keeps the name that the generator gave it.",
      dealii::Patterns::Anything());
  prm.leave_subsection();
}

Packing<2>
PackingParameters<2>::make_packing(const std::filesystem::path &directory,
                                   const bool joins_corners,
                                   Terminal &terminal) const
{
  CellLoops cells = generators.chosen().generate(directory, terminal);
  if (joins_corners && &generators.chosen() == polygons)
    join_corners(cells);
  terminal.progress("looking for interfaces");
  Packing<2> packing(std::move(cells));
  assign_groups(packing, groups);
  return packing;
}
} // namespace Voussoir
