// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/stress/loaded_faces.h>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/** Add the second moments of a plane polygon about @p centroid. */
void add_second_moments(const dealii::ArrayView<const Point<3>> &polygon,
                        const Point<3> &centroid,
                        Tensor<2, 3> &second)
{
  for (unsigned int k = 1; k + 1 < polygon.size(); ++k)
  {
    const Tensor<1, 3> corners[] = {polygon[0] - centroid,
                                    polygon[k] - centroid,
                                    polygon[k + 1] - centroid};
    const double area =
        0.5 * cross_product_3d(corners[1] - corners[0], corners[2] - corners[0])
                  .norm();
    const Tensor<1, 3> sum = corners[0] + corners[1] + corners[2];
    second += area / 12. * outer_product(sum, sum);
    for (const Tensor<1, 3> &corner : corners)
      second += area / 12. * outer_product(corner, corner);
  }
}
} // namespace

std::vector<std::vector<LoadedFace>> loaded_faces(const SpaceScene &scene,
                                                  const FaceForces &forces)
{
  const Packing<3> &packing = scene.packing();
  std::vector<std::vector<LoadedFace>> of_cells(packing.n_cells());
  for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
  {
    const Packing<3>::Interface &i = packing.interfaces()[e];
    if (i.is_at_edge)
      continue;
    const FaceResultant of = forces.resultant(packing, e);
    LoadedFace face = {{i.centroid, i.normal, i.area, {}, of.force, of.moment},
                       {packing.polygon(e)}};
    add_second_moments(packing.polygon(e), i.centroid, face.second);
    of_cells[i.cell_minus].push_back(face);
    if (i.cell_plus == packing.ground())
      continue;
    for (Tensor<1, 3> *const v : {&face.normal, &face.force, &face.moment})
      *v *= -1.;
    of_cells[i.cell_plus].push_back(face);
  }
  const auto &loads = scene.loads.on_faces;
  for (unsigned int b = 0; b < packing.boundary_faces().size(); ++b)
  {
    const Packing<3>::BoundaryFace &free = packing.boundary_faces()[b];
    LoadedFace face = {{free.centroid, free.normal, free.area, {}, {}, {}}};
    if (!loads.empty())
    {
      face.force = loads[b].force;
      face.moment = loads[b].moment;
    }
    for (unsigned int p = free.first_part; p < free.first_part + free.n_parts;
         ++p)
    {
      face.polygons.push_back(packing.parts()[p]);
      add_second_moments(packing.parts()[p], free.centroid, face.second);
    }
    of_cells[free.cell].push_back(face);
  }
  return of_cells;
}
} // namespace Voussoir
