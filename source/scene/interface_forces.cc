// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/scene/interface_forces.h>

namespace Voussoir
{
using dealii::Tensor;

Tensor<1, 2>
InterfaceForces::on_cell_minus(const Packing<2>::Interface &interface,
                               const unsigned int e) const
{
  return normal[e] * interface.normal + tangential[e] * interface.tangent();
}

double
InterfaceForces::torque_on_cell_minus(const Packing<2>::Interface &interface,
                                      const unsigned int e,
                                      const dealii::Point<2> &centre) const
{
  if (at_ends.empty())
    return cross(interface.midpoint() - centre, on_cell_minus(interface, e));
  return cross(interface.midpoint() - centre,
               tangential[e] * interface.tangent()) +
         cross(interface.start - centre, at_ends[e][0] * interface.normal) +
         cross(interface.end - centre, at_ends[e][1] * interface.normal);
}
} // namespace Voussoir
