// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameters.h>
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
PackingParameters::PackingParameters()
{
  // The one place where a generator is registered.
  generators.push_back(std::make_unique<VoronoiGenerator>());
  generators.push_back(std::make_unique<WallGenerator>());
  generators.push_back(std::make_unique<ArchGenerator>());
  generators.push_back(std::make_unique<HoneycombGenerator>());
  generators.push_back(std::make_unique<PerturbedGridGenerator>());
  auto of_polygons = std::make_unique<PolygonGenerator>();
  polygons = of_polygons.get();
  generators.push_back(std::move(of_polygons));
}

void PackingParameters::add_parameters(dealii::ParameterHandler &prm)
{
  std::vector<Choice<unsigned int>> choices;
  for (unsigned int i = 0; i < generators.size(); ++i)
    choices.push_back({i, generators[i]->name(), generators[i]->meaning(),
                       generators[i]->name()});

  prm.enter_subsection("Packing");
  add_choice(prm, "Generator", chosen, choices,
             "Where the cells come from; the parameters are in the subsection "
             "of the same name.");
  for (const auto &generator : generators)
  {
    prm.enter_subsection(generator->name());
    generator->add_parameters(prm);
    prm.leave_subsection();
  }
  prm.add_parameter(
      "Groups", groups,
      "Names for groups of cells, \"name: condition | name: condition\", with "
      "expressions in the coordinates x, y of a cell's centre. Of the "
      "conditions that a cell meets the last one counts; a cell that meets "
      "none keeps the name that the generator gave it.",
      dealii::Patterns::Anything());
  prm.leave_subsection();
}

Packing PackingParameters::make_packing(const std::filesystem::path &directory,
                                        const bool joins_corners,
                                        Terminal &terminal) const
{
  CellLoops cells = generators[chosen]->generate(directory, terminal);
  if (joins_corners && generators[chosen].get() == polygons)
    join_corners(cells);
  terminal.progress("looking for interfaces");
  Packing packing(std::move(cells));
  assign_groups(packing, groups);
  return packing;
}
} // namespace Voussoir
