// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_generators_generator_choice_h
#define voussoir_packing_generators_generator_choice_h

#include <voussoir/base/parameters/parameters.h>
#include <voussoir/packing/generators/generator.h>

#include <memory>
#include <utility>
#include <vector>

namespace Voussoir
{
/** The generators of packings, and the entry that chooses one of them. */
template <int dim>
class GeneratorChoice
{
public:
  /** Offer one more; the first is the default. @return it. */
  template <typename Generator>
  Generator *add()
  {
    auto generator = std::make_unique<Generator>();
    Generator *const added = generator.get();
    generators.push_back(std::move(generator));
    return added;
  }

  /** Declare the entry, and the generators' sections, and bind them. */
  void add_parameters(dealii::ParameterHandler &prm)
  {
    std::vector<Choice<unsigned int>> choices;
    for (unsigned int i = 0; i < generators.size(); ++i)
      choices.push_back({i, generators[i]->name(), generators[i]->meaning(),
                         generators[i]->name()});
    add_choice(prm, "Generator", number, choices,
               "Where the cells come from; the parameters are in the "
               "subsection of the same name.");
    for (const auto &generator : generators)
    {
      prm.enter_subsection(generator->name());
      generator->add_parameters(prm);
      prm.leave_subsection();
    }
  }

  /** The generator that was chosen. */
  const PackingGenerator<dim> &chosen() const { return *generators[number]; }

private:
  std::vector<std::unique_ptr<PackingGenerator<dim>>> generators;
  unsigned int number = 0;
};
} // namespace Voussoir

#endif
