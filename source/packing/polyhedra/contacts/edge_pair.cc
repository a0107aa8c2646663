// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/contacts/edge_pair.h>
#include <voussoir/packing/polyhedra/space_polygons.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
namespace
{
using dealii::Point;
using dealii::Tensor;
using Segment = std::array<Point<3>, 2>;

/** The width of a joint over that of the shortest side around; over that of the
 * longest, at least; over what rounding moves, so that it is a polygon. */
constexpr double joint_over_shortest = 1e-6, joint_over_longest = 1e-9,
                 joint_over_rounding = 64.;

/** The share of an edge over a face that is within the tolerance, at least, of
 * a joint along it, as of faces at an angle. */
constexpr double least_share_of_edge = 0.1;

/** The cosine between normals of faces that may be each other's patch. */
constexpr double least_cosine = 0.866;

/** The sine of edges that are parallel whatever their length. */
constexpr double sine_of_parallels = 1e-9;

/** What is as near to a patch or joint as this, over the tolerance, belongs to
 * it: both lie midway in a gap, and may be moved along it by as much. */
constexpr double near_joint = 2.;

/** The least and the most vertices of a joint in a point. */
constexpr unsigned int fewest_corners = 3, most_corners = 8;

Point<3> point_at(const Segment &segment, const double t)
{
  return segment[0] + t * (segment[1] - segment[0]);
}

/** The places on two segments where their lines are nearest to each other. */
struct Nearest
{
  Nearest(const Segment &one, const Segment &other)
  {
    const Tensor<1, 3> a = one[1] - one[0], b = other[1] - other[0],
                       arm = other[0] - one[0];
    lengths = {{a.norm(), b.norm()}};
    const Tensor<1, 3> across = cross_product_3d(a, b);
    const double square = across.norm_square();
    sine = std::sqrt(square) / (lengths[0] * lengths[1]);
    if (!(sine > sine_of_parallels))
      return;
    normal = across / std::sqrt(square);
    at = {{cross_product_3d(arm, b) * across / square,
           cross_product_3d(arm, a) * across / square}};
    distance = std::abs(arm * normal);
  }

  std::array<double, 2> lengths;
  double sine;
  /** The unit vector across both; where on each; how far apart; unless they
   * are parallel. */
  Tensor<1, 3> normal;
  std::array<double, 2> at;
  double distance;
};

/** The distance of a place from a segment. */
double distance_from(const Segment &segment, const Point<3> &place)
{
  const Tensor<1, 3> along = segment[1] - segment[0];
  const double t =
      std::clamp((place - segment[0]) * along / along.norm_square(), 0., 1.);
  return place.distance(point_at(segment, t));
}
} // namespace

EdgePair::EdgePair(const FaceGeometry &geometry,
                   const std::array<unsigned int, 2> &cells)
    : geometry(geometry), boxes{{geometry.boxes.of_cell(cells[0]),
                                 geometry.boxes.of_cell(cells[1])}}
{
  for (unsigned int k = 0; k < 2; ++k)
  {
    for (unsigned int f = geometry.cells.first_face[cells[k]];
         f < geometry.cells.first_face[cells[k] + 1]; ++f)
      if (geometry.planes[f].area > 0. &&
          common_extent(geometry.boxes.of_face(f), boxes[1 - k]) >=
              -geometry.tolerance)
        faces[k].push_back(f);
    edges[k] = edges_near(geometry, faces[k], boxes[1 - k]);
  }
}

void EdgePair::add_patch(const dealii::ArrayView<const Point<3>> &polygon)
{
  taken.push_back(
      {{polygon.begin(), polygon.end()}, moments_of(polygon).normal()});
}

std::vector<EdgeContact> EdgePair::joints()
{
  for (unsigned int k = 0; k < 2; ++k)
    for (const CellEdge &edge : edges[k])
      for (const unsigned int f : faces[1 - k])
        add_along(k, edge, f);
  for (unsigned int k = 0; k < 2; ++k)
    add_vertices(k);
  for (const CellEdge &one : edges[0])
    for (const CellEdge &other : edges[1])
      add_crossing(one, other);
  return std::move(found);
}

std::array<Point<3>, 2> EdgePair::segment(const CellEdge &edge) const
{
  return {{geometry.cells.vertices[edge.ends[0]],
           geometry.cells.vertices[edge.ends[1]]}};
}

/** Joints of an edge of one cell with a face of the other. */
void EdgePair::add_along(const unsigned int k,
                         const CellEdge &edge,
                         const unsigned int face)
{
  const FacePlane &plane = geometry.planes[face];
  const double tolerance = geometry.tolerance;
  const Segment ends = segment(edge);
  const std::array<double, 2> height = {
      {plane.normal * (ends[0] - plane.centre),
       plane.normal * (ends[1] - plane.centre)}};
  if (std::min(height[0], height[1]) > tolerance ||
      std::max(height[0], height[1]) < -tolerance ||
      !edge.rises(plane.normal) || !edge.is_convex(geometry))
    return;
  const FaceOutline outline(geometry, face);
  for (const SegmentPart &part : outline.parts_inside(ends[0], ends[1]))
  {
    // Of an edge at an angle, what is within the tolerance.
    const double rise = height[1] - height[0];
    SegmentPart near = part;
    if (rise != 0.)
    {
      const double one = (-tolerance - height[0]) / rise,
                   other = (tolerance - height[0]) / rise;
      near = {{std::max(part[0], std::min(one, other)),
               std::min(part[1], std::max(one, other))}};
    }
    const double length = ends[0].distance(ends[1]);
    if (!(near[1] - near[0] >= least_share_of_edge * (part[1] - part[0])))
      continue;
    for (const SegmentPart &rest : free_parts(ends, near, plane.normal))
      if ((rest[1] - rest[0]) * length > tolerance)
        add_strip(k, edge, outline, face, rest);
  }
}

void EdgePair::add_strip(const unsigned int k,
                         const CellEdge &edge,
                         const FaceOutline &outline,
                         const unsigned int face,
                         const SegmentPart &part)
{
  const Normal &normal = geometry.planes[face].normal;
  const Segment ends = segment(edge);
  Segment middle;
  for (unsigned int i = 0; i < 2; ++i)
  {
    const Point<3> place = point_at(ends, part[i]);
    middle[i] = place - 0.5 * outline.height(place) * normal;
  }
  const Tensor<1, 3> along = middle[1] - middle[0];
  const double width = std::min(
      joint_width({face, edge.faces[0], edge.faces[1]}), 0.1 * along.norm());
  const Tensor<1, 3> across =
      0.5 * width * cross_product_3d(normal, along / along.norm());
  std::array<unsigned int, 2> pair;
  pair[k] = edge.faces[0];
  pair[1 - k] = face;
  add(pair, k == 0 ? -normal : normal,
      {middle[0] - across, middle[1] - across, middle[1] + across,
       middle[0] + across},
      false);
}

/** Joints of the vertices of one cell with faces of the other. */
void EdgePair::add_vertices(const unsigned int k)
{
  std::vector<std::pair<unsigned int, const CellEdge *>> at;
  for (const CellEdge &edge : edges[k])
    for (const unsigned int v : edge.ends)
      at.emplace_back(v, &edge);
  std::sort(at.begin(), at.end());
  for (std::size_t i = 0, end; i < at.size(); i = end)
  {
    std::vector<const CellEdge *> of_vertex;
    for (end = i; end < at.size() && at[end].first == at[i].first; ++end)
      of_vertex.push_back(at[end].second);
    for (const unsigned int f : faces[1 - k])
      add_vertex(k, of_vertex, at[i].first, f);
  }
}

void EdgePair::add_vertex(const unsigned int k,
                          const std::vector<const CellEdge *> &edges,
                          const unsigned int vertex,
                          const unsigned int face)
{
  const FacePlane &plane = geometry.planes[face];
  const Point<3> &place = geometry.cells.vertices[vertex];
  const double height = plane.normal * (place - plane.centre);
  if (edges.size() < fewest_corners || std::abs(height) > geometry.tolerance ||
      is_taken(place))
    return;
  // The flattest edge is on the hull of the cone; if the cell is convex there,
  // all of the cone is above the face.
  double least = std::numeric_limits<double>::max();
  Tensor<1, 3> flattest;
  bool is_convex = false;
  std::vector<unsigned int> around = {face};
  for (const CellEdge *const edge : edges)
  {
    const Segment ends = segment(*edge);
    Tensor<1, 3> along = ends[1] - ends[0];
    along *= (edge->ends[0] == vertex ? 1. : -1.) / along.norm();
    around.insert(around.end(), edge->faces.begin(), edge->faces.end());
    if (along * plane.normal < least)
    {
      least = along * plane.normal;
      flattest = along;
      is_convex = edge->is_convex(geometry);
    }
  }
  const FaceOutline outline(geometry, face);
  if (!(least > sine_of_parallels) || !is_convex ||
      !(outline.depth(place) > geometry.tolerance))
    return;
  const Point<3> middle = place - 0.5 * height * plane.normal;
  const double radius = 0.5 * joint_width(around);
  // If all are upright, any direction does.
  Tensor<1, 3> first = flattest - least * plane.normal;
  if (!(first.norm() > sine_of_parallels))
    first = PlaneFrame(middle, plane.normal).axis(0);
  first /= first.norm();
  const Tensor<1, 3> second = cross_product_3d(plane.normal, first);
  const unsigned int n = std::min<std::size_t>(edges.size(), most_corners);
  std::vector<Point<3>> polygon;
  for (unsigned int i = 0; i < n; ++i)
  {
    const double angle = 2. * dealii::numbers::PI * i / n;
    polygon.push_back(
        middle + radius * (std::cos(angle) * first + std::sin(angle) * second));
  }
  std::array<unsigned int, 2> pair;
  pair[k] = edges.front()->faces[0];
  pair[1 - k] = face;
  add(pair, k == 0 ? -plane.normal : plane.normal, std::move(polygon), true);
}

/** The joint of two edges that cross, if each cell is on its side of them. */
void EdgePair::add_crossing(const CellEdge &one, const CellEdge &other)
{
  const std::array<Segment, 2> ends = {{segment(one), segment(other)}};
  const Nearest nearest(ends[0], ends[1]);
  const double tolerance = geometry.tolerance;
  if (!(nearest.sine > sine_of_parallels) ||
      !(nearest.sine * std::min(nearest.lengths[0], nearest.lengths[1]) >
        near_joint * tolerance) ||
      nearest.distance > tolerance)
    return;
  for (unsigned int k = 0; k < 2; ++k)
    if (!(std::min(nearest.at[k], 1. - nearest.at[k]) * nearest.lengths[k] >
          tolerance))
      return;
  const bool is_above =
      one.rises(-nearest.normal) && other.rises(nearest.normal);
  const bool is_below =
      one.rises(nearest.normal) && other.rises(-nearest.normal);
  const Point<3> place = point_at(ends[0], nearest.at[0]);
  const Point<3> middle =
      place + 0.5 * (point_at(ends[1], nearest.at[1]) - place);
  if (is_above == is_below || !one.is_convex(geometry) ||
      !other.is_convex(geometry) || is_taken(middle))
    return;
  const Normal normal = (is_above ? 1. : -1.) * nearest.normal;
  const double half = 0.5 * joint_width({one.faces[0], one.faces[1],
                                         other.faces[0], other.faces[1]});
  const Tensor<1, 3> first =
      half / nearest.lengths[0] * (ends[0][1] - ends[0][0]);
  Tensor<1, 3> second = half / nearest.lengths[1] * (ends[1][1] - ends[1][0]);
  if (cross_product_3d(first, second) * normal < 0.)
    second *= -1.;
  add({{one.faces[0], other.faces[0]}}, normal,
      {middle + first, middle + second, middle - first, middle - second}, true);
}

/** @param polygon counterclockwise about the outward normal of the face. */
void EdgePair::add(const std::array<unsigned int, 2> &faces,
                   const Normal &normal,
                   std::vector<Point<3>> polygon,
                   const bool is_in_point)
{
  const auto vector_area =
      moments_of(dealii::ArrayView<const Point<3>>(polygon)).vector_area;
  if (vector_area * normal < 0.)
    std::reverse(polygon.begin(), polygon.end());
  taken.push_back({polygon, normal});
  found.push_back({faces, normal, std::move(polygon), is_in_point});
}

std::vector<SegmentPart> EdgePair::free_parts(const Segment &segment,
                                              const SegmentPart &part,
                                              const Normal &normal) const
{
  std::vector<SegmentPart> rest = {part};
  for (const Taken &of : taken)
  {
    if (std::abs(of.normal * normal) < least_cosine)
      continue;
    const SegmentPart near =
        part_near(dealii::ArrayView<const Point<3>>(of.polygon), of.normal,
                  segment, near_joint * geometry.tolerance);
    if (!(near[0] < near[1]))
      continue;
    std::vector<SegmentPart> left;
    for (const SegmentPart &p : rest)
    {
      if (near[0] > p[0])
        left.push_back({{p[0], std::min(p[1], near[0])}});
      if (near[1] < p[1])
        left.push_back({{std::max(p[0], near[1]), p[1]}});
    }
    rest = std::move(left);
  }
  return rest;
}

bool EdgePair::is_taken(const Point<3> &place) const
{
  return std::any_of(taken.begin(), taken.end(), [&](const Taken &of) {
    const SegmentPart near =
        part_near(dealii::ArrayView<const Point<3>>(of.polygon), of.normal,
                  {{place, place}}, near_joint * geometry.tolerance);
    return near[0] < near[1];
  });
}

double EdgePair::joint_width(const std::vector<unsigned int> &faces) const
{
  double shortest = std::numeric_limits<double>::max(), longest = 0.;
  for (const unsigned int f : faces)
    for (unsigned int i = 0; i < geometry.cells.n_corners(f); ++i)
    {
      const double length =
          geometry.cells.vertex(f, i).distance(geometry.cells.vertex(f, i + 1));
      longest = std::max(longest, length);
      if (length > 0.)
        shortest = std::min(shortest, length);
    }
  return std::max({joint_over_shortest * shortest, joint_over_longest * longest,
                   joint_over_rounding * geometry.rounding});
}

bool EdgePair::meets_without_normal() const
{
  const double tolerance = geometry.tolerance;
  for (const CellEdge &one : edges[0])
    for (const CellEdge &other : edges[1])
    {
      const Segment a = segment(one), b = segment(other);
      for (unsigned int i = 0; i < 2; ++i)
        if (distance_from(a, b[i]) <= tolerance ||
            distance_from(b, a[i]) <= tolerance)
          return true;
    }
  return false;
}
} // namespace Voussoir
