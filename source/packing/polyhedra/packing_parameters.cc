// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/cell_groups.h>
#include <voussoir/packing/polyhedra/generators/building.h>
#include <voussoir/packing/polyhedra/generators/column.h>
#include <voussoir/packing/polyhedra/generators/cross_vault.h>
#include <voussoir/packing/polyhedra/generators/dome.h>
#include <voussoir/packing/polyhedra/generators/stairs.h>
#include <voussoir/packing/polyhedra/generators/vault.h>
#include <voussoir/packing/polyhedra/generators/wall.h>
#include <voussoir/packing/polyhedra/packing_parameters.h>
#include <voussoir/packing/polyhedra/voronoi/voronoi.h>

#include <utility>

namespace Voussoir
{
PackingParameters<3>::PackingParameters()
{
  // The one place where a generator is registered.
  generators.add<SpaceVoronoiGenerator>();
  generators.add<SpaceWallGenerator>();
  generators.add<BuildingGenerator>();
  generators.add<ColumnGenerator>();
  generators.add<StairsGenerator>();
  generators.add<VaultGenerator>();
  generators.add<DomeGenerator>();
  generators.add<CrossVaultGenerator>();
  models = generators.add<ModelGenerator>();
}

void PackingParameters<3>::add_parameters(dealii::ParameterHandler &prm)
{
  prm.enter_subsection("Packing");
  generators.add_parameters(prm);
  prm.add_parameter(
      "Groups", groups,
      "Names for groups of cells, \"name: condition | name: condition\", with "
      "expressions in the coordinates x, y, z of a cell's centre. Of the "
      "conditions that a cell meets the last one counts; a cell that meets "
      "none keeps the name that the generator gave it.",
      dealii::Patterns::Anything());
  prm.leave_subsection();
}

Packing<3>
PackingParameters<3>::make_packing(const std::filesystem::path &directory,
                                   const bool joins_edges,
                                   Terminal &terminal) const
{
  CellFaces cells = generators.chosen().generate(directory, terminal);
  cells.joins_edges = joins_edges && &generators.chosen() == models;
  terminal.progress("looking for interfaces");
  Packing<3> packing(std::move(cells));
  assign_groups(packing, groups);
  return packing;
}
} // namespace Voussoir
