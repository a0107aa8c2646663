// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/models/mend_surface.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <map>
#include <utility>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;
using DefectKind = ModelDefect::Kind;

namespace
{
/**
 * The distance of the ends of two edges, over the length of the one, up to
 * which they are taken for the same edge: less than half, so that the ends are
 * not taken for each other.
 */
constexpr double largest_relative_gap = 0.25;

/** The edges that one face has. */
std::vector<FaceSide> open_sides_of(const FaceLoops &faces)
{
  const std::vector<FaceSide> sides = sides_of(faces);
  std::vector<FaceSide> open;
  for (std::size_t k = 0; k < sides.size();)
  {
    const std::size_t end = end_of_edge(sides, k);
    if (end == k + 1)
      open.push_back(sides[k]);
    k = end;
  }
  return open;
}

/** The vertices of open edges; finds those near to an edge. */
class OpenVertices
{
public:
  OpenVertices(const Surface &surface, const std::vector<FaceSide> &sides)
      : surface(surface)
  {
    std::vector<unsigned int> numbers;
    for (const FaceSide &side : sides)
      numbers.insert(numbers.end(), {side.low, side.high});
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    std::vector<Entry> entries;
    for (const unsigned int v : numbers)
      entries.emplace_back(surface.vertices[v], v);
    tree = Tree(entries);
  }

  /** Those in the box around an edge and @p distance, in ascending order. */
  std::vector<unsigned int> near(const FaceSide &side,
                                 const double distance) const
  {
    namespace bgi = boost::geometry::index;
    dealii::BoundingBox<3> box(std::vector<Point<3>>{
        surface.vertices[side.low], surface.vertices[side.high]});
    box.extend(distance);
    std::vector<unsigned int> found;
    for (auto near = tree.qbegin(bgi::intersects(box)); near != tree.qend();
         ++near)
      found.push_back(near->second);
    std::sort(found.begin(), found.end());
    return found;
  }

private:
  using Entry = std::pair<Point<3>, unsigned int>;
  using Tree =
      boost::geometry::index::rtree<Entry, boost::geometry::index::rstar<16>>;

  const Surface &surface;
  Tree tree;
};

/** The vertices within an edge, from its lower to its higher vertex. */
std::vector<unsigned int> vertices_within(const Surface &surface,
                                          const FaceSide &side,
                                          const OpenVertices &vertices,
                                          const double distance)
{
  const Point<3> &start = surface.vertices[side.low];
  const Tensor<1, 3> line = surface.vertices[side.high] - start;
  const double length = line.norm();
  if (length <= 2. * distance)
    return {};
  std::vector<std::pair<double, unsigned int>> within;
  for (const unsigned int v : vertices.near(side, distance))
  {
    const Tensor<1, 3> arm = surface.vertices[v] - start;
    const double along = line * arm / length;
    if (v != side.low && v != side.high && along > distance &&
        along < length - distance &&
        cross_product_3d(line, arm).norm() <= distance * length)
      within.emplace_back(along, v);
  }
  std::sort(within.begin(), within.end());
  std::vector<unsigned int> numbers;
  for (const auto &[along, v] : within)
    numbers.push_back(v);
  return numbers;
}

double distance_from_line(const Surface &surface,
                          const FaceSide &side,
                          const unsigned int vertex)
{
  const Point<3> &start = surface.vertices[side.low];
  const Tensor<1, 3> line = surface.vertices[side.high] - start;
  return cross_product_3d(line, surface.vertices[vertex] - start).norm() /
         line.norm();
}

/** A face with the vertices that its edges lack. */
std::vector<unsigned int>
loop_with(const dealii::ArrayView<const unsigned int> &loop,
          const std::map<std::pair<unsigned int, unsigned int>,
                         std::vector<unsigned int>> &within)
{
  std::vector<unsigned int> longer;
  for (unsigned int i = 0; i < loop.size(); ++i)
  {
    longer.push_back(loop[i]);
    const unsigned int next = loop[(i + 1) % loop.size()];
    const auto found = within.find(std::minmax(loop[i], next));
    if (found == within.end())
      continue;
    if (loop[i] < next)
      longer.insert(longer.end(), found->second.begin(), found->second.end());
    else
      longer.insert(longer.end(), found->second.rbegin(), found->second.rend());
  }
  return longer;
}

/** The larger of the distances of the ends of two edges, paired as is nearer.
 */
double distance_of_ends(const Surface &surface,
                        const FaceSide &one,
                        const FaceSide &other)
{
  const Point<3> &a = surface.vertices[one.low],
                 &b = surface.vertices[one.high];
  const Point<3> &p = surface.vertices[other.low],
                 &q = surface.vertices[other.high];
  return std::min(std::max(a.distance(p), b.distance(q)),
                  std::max(a.distance(q), b.distance(p)));
}
} // namespace

void add_hanging_vertices(MendedSurface &mended, const double distance)
{
  Surface &surface = mended.surface;
  const std::vector<FaceSide> open = open_sides_of(surface.faces);
  const OpenVertices vertices(surface, open);
  std::map<std::pair<unsigned int, unsigned int>, std::vector<unsigned int>>
      within;
  ModelDefect hanging = {DefectKind::hanging_vertex};
  hanging.count = 0;
  for (const FaceSide &side : open)
  {
    const std::vector<unsigned int> numbers =
        vertices_within(surface, side, vertices, distance);
    if (numbers.empty())
      continue;
    within[{side.low, side.high}] = numbers;
    for (const unsigned int v : numbers)
      if (const double off = distance_from_line(surface, side, v);
          hanging.count++ == 0 || off > hanging.size)
      {
        hanging.size = off;
        hanging.face = surface.source[side.face];
        hanging.place = surface.vertices[v];
      }
  }
  if (within.empty())
    return;
  FaceLoops faces;
  for (unsigned int f = 0; f < surface.faces.size(); ++f)
    faces.add(loop_with(surface.faces[f], within));
  surface.faces = std::move(faces);
  mended.defects.push_back(hanging);
}

void tell_gaps(MendedSurface &mended, const double tolerance)
{
  const Surface &surface = mended.surface;
  const auto open_defect = std::find_if(
      mended.defects.begin(), mended.defects.end(),
      [](const ModelDefect &d) { return d.kind == DefectKind::open; });
  if (open_defect == mended.defects.end())
    return;
  const std::vector<FaceSide> open = open_sides_of(surface.faces);
  std::map<unsigned int, std::vector<unsigned int>> sides_at;
  for (unsigned int k = 0; k < open.size(); ++k)
    for (const unsigned int v : {open[k].low, open[k].high})
      sides_at[v].push_back(k);
  const OpenVertices vertices(surface, open);

  ModelDefect gap = {DefectKind::gap};
  gap.count = 0;
  for (const FaceSide &side : open)
  {
    const double length =
        surface.vertices[side.low].distance(surface.vertices[side.high]);
    double nearest = largest_relative_gap * length;
    bool is_beside = false;
    for (const unsigned int v : vertices.near(side, nearest))
      for (const unsigned int k : sides_at[v])
        if (!open[k].is_along(side))
          if (const double distance = distance_of_ends(surface, side, open[k]);
              distance < nearest)
          {
            nearest = distance;
            is_beside = true;
          }
    if (is_beside && (gap.count++ == 0 || nearest > gap.size))
    {
      gap.size = nearest;
      gap.face = surface.source[side.face];
      gap.place =
          surface.vertices[side.low] +
          0.5 * (surface.vertices[side.high] - surface.vertices[side.low]);
    }
  }
  if (gap.count != open.size() || !(gap.size > tolerance))
    return; // a face is missing, too
  gap.detail = text(tolerance);
  *open_defect = gap;
}
} // namespace Voussoir
