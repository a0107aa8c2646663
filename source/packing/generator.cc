// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters.h>
#include <voussoir/packing/generator.h>
#include <voussoir/packing/polygons.h>
#include <voussoir/packing/running_bond.h>
#include <voussoir/packing/voronoi.h>

namespace Voussoir
{
PackingParameters::PackingParameters()
{
  // The one place where a generator is registered.
  generators.push_back(std::make_unique<VoronoiGenerator>());
  generators.push_back(std::make_unique<RunningBondGenerator>());
  generators.push_back(std::make_unique<PolygonGenerator>());
}

void PackingParameters::add_parameters(dealii::ParameterHandler &prm)
{
  std::vector<Choice<unsigned int>> choices;
  for (unsigned int i = 0; i < generators.size(); ++i)
    choices.push_back({i, generators[i]->name(), generators[i]->meaning()});

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
  prm.leave_subsection();
}

Packing
PackingParameters::make_packing(const std::filesystem::path &directory) const
{
  return Packing(generators[chosen]->generate(directory));
}
} // namespace Voussoir
