// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/models/block_places.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/numbers.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;
using DefectKind = ModelDefect::Kind;

namespace
{
/** How much the volumes of two blocks at one place differ that are the same. */
constexpr double volume_of_same = 1e-3;

/** The winding number of a surface, 1 inside, above which a place is there. */
constexpr double least_winding_inside = 0.75;

using BlockBox = dealii::BoundingBox<3>;

/** Half the solid angle of a triangle; Van Oosterom and Strackee 1983. */
double half_solid_angle(const Tensor<1, 3> &a,
                        const Tensor<1, 3> &b,
                        const Tensor<1, 3> &c)
{
  const double x = a.norm(), y = b.norm(), z = c.norm();
  return std::atan2(a * cross_product_3d(b, c),
                    x * y * z + (a * b) * z + (b * c) * x + (c * a) * y);
}

/** How often a surface winds around a place. */
double winding_number_of(const Surface &surface, const Point<3> &place)
{
  double sum = 0.;
  for (unsigned int f = 0; f < surface.faces.size(); ++f)
  {
    const auto loop = surface.faces[f];
    for (unsigned int i = 1; i + 1 < loop.size(); ++i)
      sum += half_solid_angle(surface.vertices[loop[0]] - place,
                              surface.vertices[loop[i]] - place,
                              surface.vertices[loop[i + 1]] - place);
  }
  return sum / (2. * dealii::numbers::PI);
}

/** True if all vertices of a surface are inside of another. */
bool is_inside(const Surface &inner, const Surface &outer)
{
  return std::all_of(inner.faces.corners.begin(), inner.faces.corners.end(),
                     [&](const unsigned int v) {
                       return winding_number_of(outer, inner.vertices[v]) >
                              least_winding_inside;
                     });
}

/** The places of the vertices that have faces. */
BlockBox box_of_surface(const Surface &surface)
{
  std::vector<Point<3>> places;
  for (const unsigned int v : surface.faces.corners)
    places.push_back(surface.vertices[v]);
  return BlockBox(places);
}
} // namespace

void check_repeated_blocks(std::vector<ModelBlock> &blocks,
                           const CellRecords &records,
                           const double tolerance)
{
  namespace bgi = boost::geometry::index;
  std::vector<std::pair<Point<3>, unsigned int>> centroids;
  for (unsigned int b = 0; b < blocks.size(); ++b)
    if (blocks[b].mended.is_usable())
      centroids.emplace_back(blocks[b].sums.centroid, b);
  const bgi::rtree<std::pair<Point<3>, unsigned int>, bgi::rstar<16>> tree(
      centroids);
  for (const auto &[centroid, b] : centroids)
  {
    Point<3> low = centroid, high = centroid;
    for (unsigned int d = 0; d < 3; ++d)
    {
      low[d] -= tolerance;
      high[d] += tolerance;
    }
    const dealii::BoundingBox<3> box({low, high});
    for (auto near = tree.qbegin(bgi::intersects(box)); near != tree.qend();
         ++near)
    {
      const double other = blocks[near->second].sums.volume;
      if (near->second < b &&
          std::abs(other - blocks[b].sums.volume) <= volume_of_same * other)
      {
        ModelDefect repeated = {DefectKind::repeated_block};
        repeated.place = centroid;
        repeated.detail = describe_named(records, near->second);
        blocks[b].mended.defects.push_back(repeated);
        break;
      }
    }
  }
}

void check_enclosed_blocks(std::vector<ModelBlock> &blocks,
                           const CellRecords &records,
                           const double tolerance)
{
  namespace bgi = boost::geometry::index;
  std::vector<std::pair<BlockBox, unsigned int>> boxes;
  for (unsigned int b = 0; b < blocks.size(); ++b)
    if (blocks[b].mended.is_usable())
      boxes.emplace_back(box_of_surface(blocks[b].mended.surface), b);
  const bgi::rtree<std::pair<BlockBox, unsigned int>, bgi::rstar<16>> tree(
      boxes);
  for (const auto &[box, b] : boxes)
  {
    BlockBox larger = box;
    larger.extend(tolerance);
    for (auto found = tree.qbegin(bgi::covers(larger)); found != tree.qend();
         ++found)
      if (is_inside(blocks[b].mended.surface,
                    blocks[found->second].mended.surface))
      {
        ModelDefect enclosed = {DefectKind::enclosed_block};
        enclosed.place = blocks[b].sums.centroid;
        enclosed.detail = describe_named(records, found->second);
        blocks[b].mended.defects.push_back(enclosed);
        break;
      }
  }
}
} // namespace Voussoir
