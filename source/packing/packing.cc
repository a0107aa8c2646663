// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/packing.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/**
 * How far, relative to the size of its cell, a vertex may lie inside the chord
 * of its neighbours and still count as convex: room for the rounding of the
 * coordinates, far below anything that a force could notice.
 */
constexpr double convexity_tolerance = 1e-12;

double cross(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
{
  return a[0] * b[1] - a[1] * b[0];
}

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

[[noreturn]] void
refuse_cell(unsigned int cell, const Point<2> &place, const std::string &fault)
{
  throw InputError(
      text("Cell ", cell, " at ", text_of_point(place), " ", fault));
}
} // namespace

Tensor<1, 2> Packing::Interface::tangent() const
{
  Tensor<1, 2> t;
  t[0] = 0. - normal[1]; // not -0
  t[1] = normal[0];
  return t;
}

Point<2> Packing::Interface::midpoint() const
{
  return start + 0.5 * (end - start);
}

Point<2> Packing::BoundaryEdge::midpoint() const
{
  return start + 0.5 * (end - start);
}

Packing::Packing(CellLoops cells) : mesh(std::move(cells))
{
  measure_and_check();
  find_edges();
}

void Packing::measure_and_check()
{
  const bool take_centroids = mesh.centres.empty();
  mesh.centres.resize(n_cells());
  areas.resize(n_cells());

  for (unsigned int c = 0; c < n_cells(); ++c)
  {
    const unsigned int n = n_sides(c);
    if (n < 3)
      throw InputError(text("Cell ", c, " has ", n,
                            " vertices; a polygon has at least three."));
    const Point<2> &origin = vertex(c, 0);

    // Area and first moments by triangles from the first vertex, in
    // coordinates relative to it, so that a distant origin cancels nothing.
    double area = 0.;
    Tensor<1, 2> moment;
    for (unsigned int i = 1; i + 1 < n; ++i)
    {
      const Tensor<1, 2> a = vertex(c, i) - origin;
      const Tensor<1, 2> b = vertex(c, i + 1) - origin;
      area += 0.5 * cross(a, b);
      moment += cross(a, b) / 6. * (a + b);
    }
    if (!(area > 0.) || !std::isfinite(area))
      refuse_cell(c, origin,
                  text("has the area ", text_of_number(area),
                       "; its vertices must be finite and run "
                       "counterclockwise around a positive area."));
    areas[c] = area;
    if (take_centroids)
      mesh.centres[c] = origin + moment / area;

    const double size = std::sqrt(area);
    double turning = 0.;
    for (unsigned int i = 0; i < n; ++i)
    {
      const Tensor<1, 2> a = vertex(c, i + 1) - vertex(c, i);
      const Tensor<1, 2> b = vertex(c, i + 2) - vertex(c, i + 1);
      if (!(a.norm() > 0.))
        refuse_cell(c, vertex(c, i), "repeats a vertex; give each once.");
      if (cross(a, b) <
          -convexity_tolerance * size * std::max(a.norm(), b.norm()))
        refuse_cell(c, vertex(c, i + 1),
                    "is not convex there; cut it into convex cells.");
      turning += std::atan2(cross(a, b), a * b);
      if (!(cross(a, mesh.centres[c] - vertex(c, i)) > 0.))
        refuse_cell(c, mesh.centres[c],
                    "does not have its centre inside; move the centre.");
    }
    // A convex corner everywhere still allows a loop that winds twice.
    if (turning > 3. * dealii::numbers::PI)
      refuse_cell(c, origin, "crosses itself; its loop winds more than once.");
  }
}

void Packing::find_edges()
{
  std::vector<Halfedge> halfedges;
  halfedges.reserve(mesh.loops.size());
  for (unsigned int c = 0; c < n_cells(); ++c)
    for (unsigned int i = 0; i < n_sides(c); ++i)
    {
      const unsigned int a = mesh.loops[mesh.first[c] + i];
      const unsigned int b = mesh.loops[mesh.first[c] + (i + 1) % n_sides(c)];
      halfedges.push_back({std::min(a, b), std::max(a, b), c, i});
    }
  std::sort(halfedges.begin(), halfedges.end());

  const unsigned int none = dealii::numbers::invalid_unsigned_int;
  std::vector<unsigned int> neighbour(halfedges.size(), none);
  for (std::size_t k = 0; k + 1 < halfedges.size(); ++k)
  {
    const Halfedge &one = halfedges[k], &other = halfedges[k + 1];
    if (one.low != other.low || one.high != other.high)
      continue;
    unsigned int &first = neighbour[mesh.first[one.cell] + one.side];
    unsigned int &second = neighbour[mesh.first[other.cell] + other.side];
    const bool opposite = mesh.loops[mesh.first[one.cell] + one.side] !=
                          mesh.loops[mesh.first[other.cell] + other.side];
    if (first != none || one.cell == other.cell || !opposite)
      refuse_cell(other.cell, vertex(other.cell, other.side),
                  text("shares an edge with cell ", one.cell,
                       " on the same side of it; cells must not overlap."));
    first = other.cell;
    second = one.cell;
  }

  side_list.resize(mesh.loops.size());
  for (unsigned int c = 0; c < n_cells(); ++c)
    for (unsigned int i = 0; i < n_sides(c); ++i)
    {
      const unsigned int other = neighbour[mesh.first[c] + i];
      if (other < c)
        continue; // numbered below, from the cell c- of the interface
      const Point<2> &a = vertex(c, i), &b = vertex(c, i + 1);
      const Tensor<1, 2> edge = b - a;
      const double length = edge.norm();
      Tensor<1, 2> normal;
      normal[0] = edge[1] / length;
      normal[1] = 0. - edge[0] / length;

      Side &side = side_list[mesh.first[c] + i];
      if (other == none)
      {
        side = {true, static_cast<unsigned int>(boundary_list.size())};
        boundary_list.push_back({c, a, b, normal, length});
      }
      else
      {
        side = {false, static_cast<unsigned int>(interface_list.size())};
        interface_list.push_back({c, other, a, b, normal, length});
      }
    }

  // The other side of each interface: halfedges come in pairs, c- first.
  for (std::size_t k = 0; k + 1 < halfedges.size(); ++k)
  {
    const Halfedge &one = halfedges[k], &other = halfedges[k + 1];
    if (one.low == other.low && one.high == other.high)
      side_list[mesh.first[other.cell] + other.side] =
          side_list[mesh.first[one.cell] + one.side];
  }
}

unsigned int Packing::n_cells() const
{
  return mesh.first.size() - 1;
}

const std::vector<Packing::Interface> &Packing::interfaces() const
{
  return interface_list;
}

const std::vector<Packing::BoundaryEdge> &Packing::boundary_edges() const
{
  return boundary_list;
}

const Point<2> &Packing::centre(const unsigned int cell) const
{
  return mesh.centres[cell];
}

double Packing::area(const unsigned int cell) const
{
  return areas[cell];
}

double Packing::area() const
{
  return std::accumulate(areas.begin(), areas.end(), 0.);
}

unsigned int Packing::n_sides(const unsigned int cell) const
{
  return mesh.first[cell + 1] - mesh.first[cell];
}

unsigned int Packing::first_side(const unsigned int cell) const
{
  return mesh.first[cell];
}

dealii::ArrayView<const Packing::Side>
Packing::sides(const unsigned int cell) const
{
  return {side_list.data() + mesh.first[cell], n_sides(cell)};
}

const Point<2> &Packing::vertex(const unsigned int cell,
                                const unsigned int i) const
{
  return mesh.vertices[mesh.loops[mesh.first[cell] + i % n_sides(cell)]];
}

unsigned int Packing::static_indeterminacy() const
{
  const std::vector<unsigned int> group = connected_groups(*this);
  unsigned int n_groups = 0;
  for (unsigned int c = 0; c < n_cells(); ++c)
    n_groups += (group[c] == c);
  return 2 * interface_list.size() - 2 * (n_cells() - n_groups);
}

std::vector<unsigned int> connected_groups(const Packing &packing)
{
  const unsigned int n = packing.n_cells();
  std::vector<unsigned int> rank(n, 0), parent(n);
  boost::disjoint_sets<unsigned int *, unsigned int *> sets(rank.data(),
                                                            parent.data());
  for (unsigned int c = 0; c < n; ++c)
    sets.make_set(c);
  for (const Packing::Interface &interface : packing.interfaces())
    sets.union_set(interface.cell_minus, interface.cell_plus);

  std::vector<unsigned int> lowest(n, n), group(n);
  for (unsigned int c = 0; c < n; ++c)
  {
    unsigned int &first = lowest[sets.find_set(c)];
    first = std::min(first, c);
    group[c] = first;
  }
  return group;
}
} // namespace Voussoir
