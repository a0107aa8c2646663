// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/scene/load_residual.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
/** What acts on edges and in cells, of which the files and the stress are. */
Resultant on_edges_and_in_cells(const Scene &scene)
{
  const Packing &packing = scene.packing;
  Resultant sum(reference_point(packing));
  for (unsigned int b = 0; b < packing.boundary_edges().size(); ++b)
  {
    const Packing::BoundaryEdge &edge = packing.boundary_edges()[b];
    sum.add(
        edge.midpoint(), edge.length * scene.traction[b],
        cross((edge.end - edge.start) / edge.length, scene.traction_moment[b]));
  }
  if (!scene.body.empty())
    for (unsigned int c = 0; c < packing.n_cells(); ++c)
      sum.add(packing.centre(c), scene.body.force(packing, c),
              scene.body.torque(c));
  return sum;
}

/** What is balanced: F_c, and where blocks turn also their torques. */
Resultant balanced(const Scene &scene)
{
  const Packing &packing = scene.packing;
  Resultant sum(reference_point(packing));
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    sum.add(packing.centre(c), scene.load[c],
            scene.turns() ? scene.load_torque[c] : 0.);
  return sum;
}
} // namespace

double load_residual(const Scene &scene)
{
  if (!scene.requested)
    return 0.;
  const Resultant &requested = *scene.requested;
  const Resultant acting = on_edges_and_in_cells(scene);
  const Resultant of_cells = balanced(scene);
  const dealii::BoundingBox<2> box = scene.packing.box();
  const double extent = std::hypot(box.side_length(0), box.side_length(1));
  const double size = std::max(requested.size(), acting.size());
  if (!(size > 0.))
    return 0.;
  double residual =
      std::max({(acting.force() - requested.force()).norm(),
                (of_cells.force() - requested.force()).norm(),
                std::abs(acting.moment() - requested.moment()) / extent});
  // Without rotations a cell's force has no place.
  if (scene.turns())
    residual = std::max(
        residual, std::abs(of_cells.moment() - requested.moment()) / extent);
  return residual / size;
}
} // namespace Voussoir
