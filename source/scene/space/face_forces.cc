// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/scene/space/face_forces.h>

namespace Voussoir
{
FaceResultant FaceForces::resultant(const Packing<3> &packing,
                                    const unsigned int e) const
{
  FaceResultant sum;
  for (unsigned int k = first[e]; k < first[e + 1]; ++k)
  {
    sum.force += list[k].force;
    sum.moment += cross_product_3d(
        list[k].place - packing.interfaces()[e].centroid, list[k].force);
  }
  return sum;
}
} // namespace Voussoir
