// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/straight_runs.h>
#include <voussoir/scene/loads/load_parts.h>

#include <algorithm>

namespace Voussoir
{
namespace
{
/** Add the parts of the forces that act inside the cells. */
void add_forces_inside(const Scene &scene,
                       const Motion &motion,
                       std::vector<LoadPart> &parts)
{
  if (scene.body.empty())
    return;
  LoadPart body = {"the body force", 0.};
  for (unsigned int c = 0; c < scene.packing.n_cells(); ++c)
  {
    body.work += scene.body.force(scene.packing, c) * motion.displacement[c];
    if (!motion.rotation.empty())
      body.work += scene.body.torque(c) * motion.rotation[c];
  }
  for (const CellForce &f : scene.on_cells)
  {
    LoadPart part = {"the force on '" + f.name + "'", 0.};
    for (const unsigned int c : f.cells)
    {
      part.work += f.force * motion.displacement[c];
      if (!motion.rotation.empty())
        part.work += f.torque(scene.packing, c) * motion.rotation[c];
    }
    body.work -= part.work;
    parts.push_back(part);
  }
  if (scene.has_body_force)
    parts.push_back(body);
}
} // namespace

std::vector<LoadPart> load_parts(const Scene &scene, const Motion &motion)
{
  std::vector<Packing<2>::BoundaryEdge> loaded;
  std::vector<double> work;
  for (unsigned int b = 0; b < scene.traction.size(); ++b)
    if (scene.traction[b].norm() > 0.)
    {
      const Packing<2>::BoundaryEdge &edge = scene.packing.boundary_edges()[b];
      loaded.push_back(edge);
      const unsigned int c = edge.cell;
      work.push_back(edge.length * scene.traction[b] *
                     motion.at(c, edge.midpoint() - scene.packing.centre(c)));
      if (!motion.rotation.empty())
        work.back() +=
            motion.rotation[c] * cross((edge.end - edge.start) / edge.length,
                                       scene.traction_moment[b]);
    }

  std::vector<LoadPart> parts;
  for (const StraightRun &run : straight_runs(loaded))
  {
    LoadPart part = {"the traction on the side from " +
                         text_of_point(run.start) + " to " +
                         text_of_point(run.end),
                     0.};
    for (const unsigned int k : run.edges)
      part.work += work[k];
    parts.push_back(part);
  }
  add_forces_inside(scene, motion, parts);
  std::stable_sort(
      parts.begin(), parts.end(),
      [](const LoadPart &a, const LoadPart &b) { return a.work > b.work; });
  return parts;
}

double share_of_first(const std::vector<LoadPart> &parts)
{
  double sum = 0.;
  for (const LoadPart &part : parts)
    sum += std::max(part.work, 0.);
  return sum > 0. ? parts.front().work / sum : 0.;
}
} // namespace Voussoir
