// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/models/mend_surface.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace Voussoir
{
using dealii::Point;
using DefectKind = ModelDefect::Kind;

bool MendedSurface::is_usable() const
{
  return std::none_of(defects.begin(), defects.end(),
                      [](const ModelDefect &d) { return d.is_refusal(); });
}

namespace
{
/**
 * Lengths within which the fifth powers of them, of which moments are made, and
 * the squares of areas are numbers with all their digits.
 */
constexpr double shortest_length = 1e-50, longest_length = 1e50;

/** What numbers with seven digits differ by, over the diagonal of a block. */
constexpr double error_of_seven_digits = 1e-6;

/** Remove vertices twice in a row, and spikes; false if there are none. */
bool remove_repeated_vertices(std::vector<unsigned int> &loop)
{
  const std::size_t n_before = loop.size();
  for (std::size_t i = 0; i < loop.size() && loop.size() > 2;)
  {
    const std::size_t n = loop.size(), j = (i + 1) % n, k = (i + 2) % n;
    if (loop[i] == loop[j])
      loop.erase(loop.begin() + std::max(i, j));
    else if (loop[i] == loop[k]) // of a spike i, j, i both j and the second i
    {
      loop.erase(loop.begin() + std::max(j, k));
      loop.erase(loop.begin() + std::min(j, k));
    }
    else
    {
      ++i;
      continue;
    }
    i = 0;
  }
  if (loop.size() == 2 && loop[0] == loop[1])
    loop.pop_back();
  return loop.size() < n_before;
}

/** Count one more of a kind, of which the first face is told. */
void count_face(std::optional<ModelDefect> &defect,
                const DefectKind kind,
                const unsigned int face,
                const Point<3> &place)
{
  if (!defect)
  {
    defect.emplace();
    *defect = {kind, 0, 0, face, 0., place};
  }
  ++defect->count;
}

/** Leave out faces with the same vertices as one before. */
void remove_repeated_faces(MendedSurface &mended)
{
  const Surface &surface = mended.surface;
  const unsigned int n = surface.faces.size();
  FaceLoops sorted = surface.faces;
  for (unsigned int f = 0; f < n; ++f)
    std::sort(sorted.corners.begin() + sorted.first[f],
              sorted.corners.begin() + sorted.first[f + 1]);
  std::vector<unsigned int> order(n);
  std::iota(order.begin(), order.end(), 0);
  const auto less = [&](const unsigned int f, const unsigned int g) {
    return std::lexicographical_compare(sorted[f].begin(), sorted[f].end(),
                                        sorted[g].begin(), sorted[g].end());
  };
  std::stable_sort(order.begin(), order.end(), less);
  std::vector<bool> is_repeated(n, false);
  for (unsigned int k = 1; k < n; ++k)
    is_repeated[order[k]] = !less(order[k - 1], order[k]);
  if (std::none_of(is_repeated.begin(), is_repeated.end(),
                   [](const bool is) { return is; }))
    return;

  Surface kept;
  std::optional<ModelDefect> repeated;
  for (unsigned int f = 0; f < n; ++f)
    if (is_repeated[f])
      count_face(repeated, DefectKind::repeated_face, surface.source[f],
                 surface.vertices[surface.faces[f][0]]);
    else
      kept.add(surface.faces[f], surface.source[f]);
  kept.vertices = std::move(mended.surface.vertices);
  mended.surface = std::move(kept);
  mended.defects.push_back(*repeated);
}
} // namespace

double distance_of_seven_digits(const std::vector<Point<3>> &vertices)
{
  return error_of_seven_digits * diagonal_of(vertices);
}

std::vector<unsigned int>
first_vertices_nearby(const std::vector<Point<3>> &vertices,
                      const double distance)
{
  namespace bgi = boost::geometry::index;
  bgi::rtree<std::pair<Point<3>, unsigned int>, bgi::linear<16>> tree;
  std::vector<unsigned int> first(vertices.size());
  for (unsigned int v = 0; v < vertices.size(); ++v)
  {
    Point<3> low = vertices[v], high = vertices[v];
    for (unsigned int d = 0; d < 3; ++d)
    {
      low[d] -= distance;
      high[d] += distance;
    }
    first[v] = v;
    const dealii::BoundingBox<3> box({low, high});
    for (auto near = tree.qbegin(bgi::intersects(box)); near != tree.qend();
         ++near)
      if (near->first.distance(vertices[v]) <= distance)
        first[v] = std::min(first[v], near->second);
    if (first[v] == v)
      tree.insert({vertices[v], v});
  }
  return first;
}

MendedSurface surface_of(const BlockMesh &block)
{
  MendedSurface mended;
  Surface &surface = mended.surface;
  surface.vertices = block.vertices;
  surface.faces = block.faces;
  surface.source.resize(block.faces.size());
  std::iota(surface.source.begin(), surface.source.end(), 0);
  if (surface.faces.size() == 0)
  {
    mended.defects.push_back({DefectKind::no_face});
    return mended;
  }
  ModelDefect bad_number = {DefectKind::bad_number};
  bad_number.count = 0;
  double largest = 0.;
  for (const Point<3> &p : surface.vertices)
    if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]))
      largest =
          std::max({largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
    else if (bad_number.count++ == 0)
      bad_number.place = p;
  if (bad_number.count > 0)
  {
    mended.defects.push_back(bad_number);
    return mended;
  }
  const double diagonal =
      largest < longest_length ? diagonal_of(surface.vertices) : longest_length;
  // Of coordinates that are too small the diagonal may be none.
  if (largest >= longest_length ||
      (diagonal > 0. && diagonal < shortest_length) ||
      (largest > 0. && largest < shortest_length))
    mended.defects.push_back({DefectKind::bad_scale, 0, 1,
                              dealii::numbers::invalid_unsigned_int, diagonal,
                              surface.vertices[0]});
  else if (surface.faces.size() < least_faces_of_polyhedron)
    mended.defects.push_back(
        {DefectKind::few_faces, 0, 1, dealii::numbers::invalid_unsigned_int,
         static_cast<double>(surface.faces.size()),
         surface.vertices.empty() ? Point<3>() : surface.vertices[0]});
  return mended;
}

void weld(MendedSurface &mended, const double distance)
{
  const Surface &surface = mended.surface;
  const std::vector<unsigned int> first =
      first_vertices_nearby(surface.vertices, distance);
  ModelDefect welded = {DefectKind::welded_vertex};
  welded.count = 0;
  for (unsigned int v = 0; v < first.size(); ++v)
    if (first[v] != v)
    {
      const double moved =
          surface.vertices[v].distance(surface.vertices[first[v]]);
      if (welded.count++ == 0 || moved > welded.size)
      {
        welded.size = moved;
        welded.place = surface.vertices[v];
      }
    }
  if (welded.count > 0)
    mended.defects.push_back(welded);

  Surface kept;
  std::optional<ModelDefect> degenerate, repeated;
  std::vector<unsigned int> loop;
  for (unsigned int f = 0; f < surface.faces.size(); ++f)
  {
    loop.clear();
    for (const unsigned int vertex : surface.faces[f])
      loop.push_back(first[vertex]);
    Point<3> place;
    if (!surface.vertices.empty())
      place = surface.vertices[loop.empty() ? 0 : loop[0]];
    const bool is_shorter = remove_repeated_vertices(loop);
    if (loop.size() < 3)
      count_face(degenerate, DefectKind::degenerate_face, surface.source[f],
                 place);
    else
    {
      if (is_shorter)
        count_face(repeated, DefectKind::repeated_vertex, surface.source[f],
                   place);
      kept.add(loop, surface.source[f]);
    }
  }
  kept.vertices = std::move(mended.surface.vertices);
  mended.surface = std::move(kept);
  for (const std::optional<ModelDefect> &defect : {repeated, degenerate})
    if (defect)
      mended.defects.push_back(*defect);
  remove_repeated_faces(mended);
  if (mended.surface.faces.size() == 0)
    mended.defects.push_back({DefectKind::no_face});
}
} // namespace Voussoir
