// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/contact/friction_parameters.h>
#include <voussoir/contact/laws/coulomb.h>
#include <voussoir/contact/laws/mohr_coulomb.h>
#include <voussoir/contact/laws/tresca.h>

#include <utility>

namespace Voussoir
{
namespace
{
/** All laws, in the order in which they are documented. */
std::vector<std::unique_ptr<FrictionLaw>> all_laws()
{
  std::vector<std::unique_ptr<FrictionLaw>> laws;
  laws.push_back(std::make_unique<Tresca>());
  auto coulomb = std::make_unique<Coulomb>();
  const Coulomb &its_entries = *coulomb;
  laws.push_back(std::move(coulomb));
  laws.push_back(std::make_unique<AssociatedCoulomb>(its_entries));
  laws.push_back(std::make_unique<MohrCoulomb>(its_entries));
  return laws;
}

template <int dim>
class MeansOf : public JointMeans
{
public:
  explicit MeansOf(const Packing<dim> &packing) : packing(packing) {}
  std::vector<double>
  operator()(const JointQuantity &quantity,
             std::vector<std::string> &warnings) const override
  {
    return means(packing, quantity, warnings);
  }
  std::string place(const unsigned int e) const override
  {
    return text_of_point(packing.interfaces()[e].middle());
  }

private:
  const Packing<dim> &packing;
};
} // namespace

FrictionParameters::FrictionParameters() : laws(all_laws()) {}

void FrictionParameters::add_parameters(dealii::ParameterHandler &prm)
{
  prm.enter_subsection("Friction");
  std::vector<Choice<unsigned int>> choices;
  for (unsigned int i = 0; i < laws.size(); ++i)
    choices.push_back(
        {i, laws[i]->name(), laws[i]->meaning(), laws[i]->entries()});
  add_choice(
      prm, "Law", chosen, choices,
      "The largest tangential force f_t on an interface of the length |e|, in "
      "space of the area |e|.");
  for (const auto &law : laws)
    law->add_parameters(prm);
  prm.leave_subsection();
}

template <int dim>
Strengths FrictionParameters::strengths(const Packing<dim> &packing) const
{
  Strengths found = laws[chosen]->strengths(MeansOf<dim>(packing));
  found.law = laws[chosen]->name();
  return found;
}

template Strengths FrictionParameters::strengths(const Packing<2> &) const;
template Strengths FrictionParameters::strengths(const Packing<3> &) const;
} // namespace Voussoir
