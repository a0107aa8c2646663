// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/base/geometry.h>
#include <voussoir/base/invalid_index.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/packing.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/**
 * The distance, relative to the size of its cell, that a vertex may lie inside
 * the chord of its neighbours and still count as convex: room for the rounding
 * of the coordinates, far below anything that a force could notice.
 */
constexpr double tolerance_of_chords = 1e-12;

/** The area of a cell with whose powers one can compute. */
constexpr double smallest_area = 1e-140, largest_area = 1e140;

/** One side of a cell, keyed by its two vertex numbers in ascending order. */
struct Halfedge
{
  unsigned int low, high, cell, side;

  bool operator<(const Halfedge &other) const
  {
    return std::tie(low, high, cell) <
           std::tie(other.low, other.high, other.cell);
  }
};
} // namespace

Tensor<1, 2> Packing<2>::Interface::tangent() const
{
  Tensor<1, 2> t;
  t[0] = 0. - normal[1]; // not -0
  t[1] = normal[0];
  return t;
}

Packing<2>::Packing(CellLoops cells) : mesh(std::move(cells))
{
  const bool take_centroids = mesh.centres.empty();
  mesh.centres.resize(n_cells());
  areas.resize(n_cells());
  mesh.name_groups();
  for (unsigned int c = 0; c < n_cells(); ++c)
  {
    measure(c, take_centroids);
    check_shape(c);
  }
  find_edges();
}

void Packing<2>::measure(const unsigned int c, const bool take_centroid)
{
  const unsigned int n = n_sides(c);
  if (n < 3)
    throw InputError(text("Cell ", c, " has ", n,
                          " vertices; a polygon has at least three."));
  const Point<2> &origin = vertex(c, 0);

  // Area and first moments by triangles from the first vertex, in coordinates
  // relative to it, so that a distant origin cancels nothing. If they are too
  // large to compute with, the area is not a number, which is refused below.
  const InvalidOperationsAllowed allowed;
  double area = 0.;
  Tensor<1, 2> moment;
  for (unsigned int i = 1; i + 1 < n; ++i)
  {
    const Tensor<1, 2> a = vertex(c, i) - origin;
    const Tensor<1, 2> b = vertex(c, i + 1) - origin;
    area += 0.5 * cross(a, b);
    moment += cross(a, b) / 6. * (a + b);
  }
  if (!std::isfinite(area) || area <= 0.)
    refuse(c, origin,
           text("has the area ", text_of_number(area),
                "; its vertices must be finite and run counterclockwise "
                "around a positive area."));
  if (!(area > smallest_area) || !(area < largest_area))
    refuse(c, origin,
           text("has the area ", area,
                ", too large or too small to compute with; choose a unit of "
                "length in which it is between 1e-140 and 1e140."));
  areas[c] = area;
  if (take_centroid)
    mesh.centres[c] = origin + moment / area;
}

void Packing<2>::check_shape(const unsigned int c)
{
  const double size = std::sqrt(areas[c]);
  const double tolerance = tolerance_of_chords * size + mesh.tolerance;
  bool convex = true;
  double turning = 0.;
  for (unsigned int i = 0; i < n_sides(c); ++i)
  {
    const Tensor<1, 2> a = vertex(c, i + 1) - vertex(c, i);
    const Tensor<1, 2> b = vertex(c, i + 2) - vertex(c, i + 1);
    if (!(a.norm() > 0.))
      refuse(c, vertex(c, i), "repeats a vertex; give each once.");
    convex &= cross(a, b) >= -tolerance * std::max(a.norm(), b.norm());
    turning += std::atan2(cross(a, b), a * b);
  }
  // A positive area still allows a loop that winds twice.
  if (turning > 3. * dealii::numbers::PI)
    refuse(
        c, vertex(c, 0),
        "crosses itself: its loop winds more than once; draw it as one simple "
        "loop.");

  const Point<2> &centre = mesh.centres[c];
  bool is_seen = true;
  for (unsigned int i = 0; i < n_sides(c); ++i)
  {
    const Tensor<1, 2> side = vertex(c, i + 1) - vertex(c, i);
    is_seen &= cross(side, centre - vertex(c, i)) > 0.;
  }
  if (!is_seen && convex)
    refuse(c, centre,
           "does not have its centre inside; move the point or line of "
           "'Points file' or 'Centres file' that it is from.");
  if (!convex)
    concave.push_back(c);
  if (!is_seen)
    hiding.push_back(c);
}

bool Packing<2>::is_seen_whole(const unsigned int cell) const
{
  return !std::binary_search(hiding.begin(), hiding.end(), cell);
}

std::vector<unsigned int> Packing<2>::find_opposite_sides() const
{
  std::vector<unsigned int> opposite = find_shared_sides();
  for (const auto &[one, other] : mesh.facing)
  {
    Assert(opposite[one] == invalid_index && opposite[other] == invalid_index,
           dealii::ExcMessage("A side faces one other at most."));
    opposite[one] = other;
    opposite[other] = one;
  }
  return opposite;
}

std::vector<unsigned int> Packing<2>::find_shared_sides() const
{
  std::vector<Halfedge> halfedges;
  halfedges.reserve(mesh.loops.size());
  for (unsigned int c = 0; c < n_cells(); ++c)
    for (unsigned int i = 0; i < n_sides(c); ++i)
    {
      const unsigned int a = mesh.corner(c, i), b = mesh.corner(c, i + 1);
      halfedges.push_back({std::min(a, b), std::max(a, b), c, i});
    }
  std::sort(halfedges.begin(), halfedges.end());

  std::vector<unsigned int> opposite(halfedges.size(), invalid_index);
  for (std::size_t k = 0; k + 1 < halfedges.size(); ++k)
  {
    const Halfedge &one = halfedges[k], &other = halfedges[k + 1];
    if (one.low != other.low || one.high != other.high)
      continue;
    const unsigned int first = mesh.first[one.cell] + one.side;
    const unsigned int second = mesh.first[other.cell] + other.side;
    const bool same_side = mesh.loops[first] == mesh.loops[second];
    if (opposite[first] != invalid_index || one.cell == other.cell || same_side)
      refuse(other.cell, vertex(other.cell, other.side),
             text("shares an edge with ", describe(one.cell),
                  " on the same side of it; cells must not overlap."));
    opposite[first] = second;
    opposite[second] = first;
  }
  return opposite;
}

void Packing<2>::find_edges()
{
  const std::vector<unsigned int> opposite = find_opposite_sides();
  std::vector<unsigned int> cell_of_side(mesh.loops.size());
  for (unsigned int c = 0; c < n_cells(); ++c)
    std::fill_n(cell_of_side.begin() + mesh.first[c], n_sides(c), c);

  const unsigned int n_on_boundary =
      std::count(opposite.begin(), opposite.end(), invalid_index);
  boundary_list.reserve(n_on_boundary);
  interface_list.reserve((opposite.size() - n_on_boundary) / 2);
  side_list.resize(mesh.loops.size());
  for (unsigned int s = 0; s < side_list.size(); ++s)
  {
    const unsigned int c = cell_of_side[s];
    if (opposite[s] < s) // numbered from the cell c- of the interface
    {
      side_list[s] = side_list[opposite[s]];
      continue;
    }
    const unsigned int i = s - mesh.first[c];
    Point<2> a = vertex(c, i), b = vertex(c, i + 1);
    if (opposite[s] != invalid_index)
    {
      const unsigned int other = cell_of_side[opposite[s]];
      const unsigned int j = opposite[s] - mesh.first[other];
      a += 0.5 * (vertex(other, j + 1) - a);
      b += 0.5 * (vertex(other, j) - b);
    }
    const Tensor<1, 2> edge = b - a;
    const double length = edge.norm();
    Tensor<1, 2> normal;
    normal[0] = edge[1] / length;
    normal[1] = 0. - edge[0] / length; // not -0
    if (opposite[s] == invalid_index)
    {
      side_list[s] = {true, static_cast<unsigned int>(boundary_list.size())};
      boundary_list.push_back({c, a, b, normal, length});
    }
    else
    {
      side_list[s] = {false, static_cast<unsigned int>(interface_list.size())};
      interface_list.push_back(
          {c, cell_of_side[opposite[s]], a, b, normal, length});
    }
  }
}

void Packing<2>::support(const std::vector<bool> &is_support)
{
  AssertDimension(is_support.size(), boundary_list.size());
  std::vector<unsigned int> number(boundary_list.size());
  std::vector<BoundaryEdge> free;
  for (unsigned int b = 0; b < boundary_list.size(); ++b)
  {
    const BoundaryEdge &edge = boundary_list[b];
    if (is_support[b])
    {
      number[b] = interface_list.size();
      interface_list.push_back({edge.cell, ground(), edge.start, edge.end,
                                edge.normal, edge.length});
      ++support_count;
    }
    else
    {
      number[b] = free.size();
      free.push_back(edge);
    }
  }
  for (Side &side : side_list)
    if (side.on_boundary)
      side = {!is_support[side.index], number[side.index]};
  boundary_list = std::move(free);
}

Packing<2> Packing<2>::moved(
    const std::function<Point<2>(unsigned int, const Point<2> &)> &place,
    const std::function<Point<2>(unsigned int, const Point<2> &)>
        &place_of_ground) const
{
  Packing other = *this;
  // Cells that move apart share no vertices.
  other.mesh.vertices.clear();
  other.mesh.facing.clear();
  for (unsigned int c = 0; c < n_cells(); ++c)
  {
    for (unsigned int i = 0; i < n_sides(c); ++i)
    {
      other.mesh.loops[mesh.first[c] + i] = other.mesh.vertices.size();
      other.mesh.vertices.push_back(place(c, vertex(c, i)));
    }
    other.mesh.centres[c] = place(c, centre(c));
  }
  const auto lay = [](auto &edge, const Point<2> &start, const Point<2> &end) {
    edge.start = start;
    edge.end = end;
    const Tensor<1, 2> along = end - start;
    edge.length = along.norm();
    edge.normal = Tensor<1, 2>({along[1], 0. - along[0]}) / edge.length;
  };
  for (unsigned int e = 0; e < interface_list.size(); ++e)
  {
    const Interface &i = interface_list[e];
    const auto between = [&](const Point<2> &x) {
      const Point<2> one = place(i.cell_minus, x);
      const Point<2> two = i.cell_plus == ground() ? place_of_ground(e, x)
                                                   : place(i.cell_plus, x);
      return one + 0.5 * (two - one);
    };
    lay(other.interface_list[e], between(i.start), between(i.end));
  }
  for (unsigned int b = 0; b < boundary_list.size(); ++b)
  {
    const BoundaryEdge &edge = boundary_list[b];
    lay(other.boundary_list[b], place(edge.cell, edge.start),
        place(edge.cell, edge.end));
  }
  return other;
}

void Packing<2>::refuse(const unsigned int cell,
                        const Point<2> &place,
                        const std::string &fault) const
{
  std::string name = describe(cell);
  name.front() = 'C';
  throw InputError(text(name, " at ", text_of_point(place), " ", fault));
}

dealii::BoundingBox<2> Packing<2>::box() const
{
  std::pair<dealii::Point<2>, dealii::Point<2>> corners = {vertex(0, 0),
                                                           vertex(0, 0)};
  for (unsigned int c = 0; c < n_cells(); ++c)
    for (unsigned int i = 0; i < n_sides(c); ++i)
      for (unsigned int d = 0; d < 2; ++d)
      {
        const double x = vertex(c, i)[d];
        corners.first[d] = std::min(corners.first[d], x);
        corners.second[d] = std::max(corners.second[d], x);
      }
  return dealii::BoundingBox<2>(corners);
}

double Packing<2>::area() const
{
  return std::accumulate(areas.begin(), areas.end(), 0.);
}

double Packing<2>::distance(const Interface &interface) const
{
  const unsigned int minus = interface.cell_minus, plus = interface.cell_plus;
  if (!is_seen_whole(minus) || !is_seen_whole(plus))
    return half_distance(minus, interface) + half_distance(plus, interface);
  const Point<2> far = plus == ground() ? interface.midpoint() : centre(plus);
  return (far - centre(minus)) * interface.normal;
}

/** The part of d_e that lies in a cell. */
double Packing<2>::half_distance(const unsigned int cell,
                                 const Interface &interface) const
{
  if (cell == ground())
    return 0.;
  if (is_seen_whole(cell))
    return std::abs((interface.midpoint() - centre(cell)) * interface.normal);
  double perimeter = 0.;
  for (unsigned int i = 0; i < n_sides(cell); ++i)
    perimeter += vertex(cell, i).distance(vertex(cell, i + 1));
  return 2. * area(cell) / perimeter;
}

std::string Packing<2>::describe(const unsigned int cell) const
{
  return cell == ground() ? "the ground" : mesh.describe(cell);
}
} // namespace Voussoir
