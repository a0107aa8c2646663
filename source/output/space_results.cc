// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/space_results.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>

namespace Voussoir
{
PrincipalStresses principal_stresses(const dealii::Tensor<2, 3> &sigma)
{
  const auto values = dealii::eigenvalues(dealii::symmetrize(sigma));
  return {values[2], values[0]};
}

PrincipalStresses principal_stresses(const LinearStress &stress,
                                     const CellFaces &cells,
                                     const unsigned int cell)
{
  PrincipalStresses found = principal_stresses(stress.mean);
  for (unsigned int f = cells.first_face[cell]; f < cells.first_face[cell + 1];
       ++f)
    for (const unsigned int v : cells.corners(f))
    {
      const PrincipalStresses there =
          principal_stresses(stress.at(cells.vertices[v]));
      found.least = std::min(found.least, there.least);
      found.greatest = std::max(found.greatest, there.greatest);
    }
  return found;
}
} // namespace Voussoir
