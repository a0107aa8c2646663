// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/statics/load_parts.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/** The angle, and the offset over the size of the packing, within rounding. */
constexpr double straightness = 1e-9;

/** Boundary edges on one straight line that face the same way. */
struct Side
{
  Tensor<1, 2> normal;
  Point<2> start;
  Point<2> end;
  double work = 0.;

  /** Counterclockwise around the packing. */
  Tensor<1, 2> along() const
  {
    return dealii::Point<2>(-normal[1], normal[0]);
  }

  bool continues(const Packing::BoundaryEdge &edge, const double size) const
  {
    return (edge.normal - normal).norm() <= straightness &&
           std::abs((edge.start - start) * normal) <= straightness * size;
  }

  void add(const Packing::BoundaryEdge &edge)
  {
    for (const Point<2> &x : {edge.start, edge.end})
    {
      if ((x - start) * along() < 0.)
        start = x;
      if ((x - end) * along() > 0.)
        end = x;
    }
  }
};
} // namespace

std::vector<LoadPart> load_parts(const Scene &scene,
                                 const std::vector<Tensor<1, 2>> &displacement)
{
  const double size = std::sqrt(scene.packing.area());
  std::vector<Side> sides;
  for (unsigned int b = 0; b < scene.traction.size(); ++b)
  {
    if (scene.traction[b].norm() == 0.)
      continue;
    const Packing::BoundaryEdge &edge = scene.packing.boundary_edges()[b];
    auto side =
        std::find_if(sides.begin(), sides.end(), [&](const Side &other) {
          return other.continues(edge, size);
        });
    if (side == sides.end())
      side = sides.insert(sides.end(), {edge.normal, edge.start, edge.end});
    side->add(edge);
    side->work += edge.length * scene.traction[b] * displacement[edge.cell];
  }

  std::vector<LoadPart> parts;
  for (const Side &side : sides)
    parts.push_back({"the traction on the side from " +
                         text_of_point(side.start) + " to " +
                         text_of_point(side.end),
                     side.work});
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
