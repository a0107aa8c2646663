// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/scene/proofs/face_function.h>

namespace Voussoir
{
FaceFunction FaceFunction::times(const double factor) const
{
  FaceFunction product = *this;
  for (Term &term : product.terms)
  {
    term.displacement *= factor;
    term.rotation *= factor;
  }
  return product;
}

double FaceFunction::operator()(const FaceForces &forces) const
{
  double sum = 0.;
  for (const Term &term : terms)
    for (unsigned int k = forces.first[term.interface];
         k < forces.first[term.interface + 1]; ++k)
      sum += forces.list[k].force * term.at(forces.list[k].place);
  return sum;
}

std::vector<const FaceFunction::Term *>
FaceFunction::by_interface(const std::size_t n_interfaces) const
{
  std::vector<const Term *> found(n_interfaces, nullptr);
  for (const Term &term : terms)
    found[term.interface] = &term;
  return found;
}

FaceFunction normal_force(const Packing<3> &packing, const unsigned int e)
{
  return {{{e, packing.interfaces()[e].normal}}};
}

FaceFunction shear_force(const Packing<3> &packing,
                         const unsigned int e,
                         const unsigned int i)
{
  const dealii::Tensor<1, 3> &normal = packing.interfaces()[e].normal;
  dealii::Tensor<1, 3> direction;
  direction[i] = 1.;
  return {{{e, direction - normal[i] * normal}}};
}
} // namespace Voussoir
