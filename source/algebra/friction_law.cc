// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/friction_law.h>

#include <deal.II/base/exceptions.h>

namespace Voussoir
{
namespace
{

class Tresca : public FrictionLaw
{
public:
  std::string name() const override { return "Tresca"; }
  double limit(const double strength,
               const double /*compression*/) const override
  {
    return strength;
  }
};

} // namespace

const FrictionLaw &tresca()
{
  static const Tresca law;
  return law;
}

const FrictionLaw &friction_law_of(const std::string &name)
{
  for (const FrictionLaw *law : {&tresca()})
    if (law->name() == name)
      return *law;
  AssertThrow(false, dealii::ExcInternalError());
  return tresca();
}

} // namespace Voussoir
