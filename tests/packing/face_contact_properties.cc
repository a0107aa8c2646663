// SPDX-License-Identifier: LGPL-2.1-or-later

// Contacts of faces of polyhedra: what they do not depend on, what they add up
// to, and areas against exact arithmetic.

#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/convex_hull_2.h>

#include "cell_faces.h"
#include "tests.h"
#include <iterator>
#include <map>

namespace test_face_contact_properties
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

constexpr double tolerance = 1e-9;

/** For each pair of cells that touch the area of their patches. */
using Pairs = std::map<std::array<unsigned int, 2>, double>;

/** @param names what the cells are called. */
Pairs pairs_of(const CellFaces &cells,
               const FaceContacts &contacts,
               const std::vector<unsigned int> &names)
{
  Pairs pairs;
  for (unsigned int k = 0; k < contacts.faces.size(); ++k)
  {
    const auto [a, b] =
        std::minmax({names[cells.cell_of_face(contacts.faces[k][0])],
                     names[cells.cell_of_face(contacts.faces[k][1])]});
    pairs[{{a, b}}] += moments_of(contacts.patches[k]).area();
  }
  return pairs;
}

/** The largest relative difference of areas; huge if other pairs touch. */
double difference(const Pairs &one, const Pairs &other, const double factor)
{
  constexpr double huge = 1e300;
  if (one.size() != other.size())
    return huge;
  double largest = 0.;
  for (const auto &[cells, area] : one)
  {
    const auto found = other.find(cells);
    if (found == other.end())
      return huge;
    largest = std::max(largest, std::abs(factor * found->second / area - 1.));
  }
  return largest;
}

/** Bricks, a block with a notch that bears some of them, and a drum. */
CellFaces mixed_blocks()
{
  CellFaces cells = brick_wall(3, 2, 4);
  add_prism(cells,
            {{0, 0}, {6, 0}, {6, 2}, {3, 2}, {3, 1}, {1, 1}, {1, 2}, {0, 2}},
            -1., 0.);
  std::vector<Point<2>> ring;
  for (unsigned int i = 0; i < 9; ++i)
    ring.emplace_back(4. + std::cos(0.7 * i), 1. + std::sin(0.7 * i));
  add_prism(cells, ring, 2., 3.);
  return cells;
}

/** A place turned about another by @p turn, an angle about its direction. */
Point<3> turned_about(const Point<3> &middle,
                      const Tensor<1, 3> &turn,
                      const Point<3> &place)
{
  // Cayley's formula: by the angle 2 atan(|turn| / 2).
  const Tensor<1, 3> across = cross_product_3d(turn, place - middle);
  return place + (across + 0.5 * cross_product_3d(turn, across)) /
                     (1. + 0.25 * turn.norm_square());
}

/** Blocks on larger ones, on an edge, a corner, or a line within their bottom.
 */
CellFaces wedges(const unsigned int n, Random &random)
{
  CellFaces cells;
  for (unsigned int k = 0; k < n; ++k)
  {
    const double x = 3. * (k % 7), y = 3. * (k / 7);
    add_box(cells, {x, y, 0.}, {x + 2., y + 2., 1.});
    const unsigned int first = cells.vertices.size();
    add_box(cells, {x + 0.4, y + 0.5, 1.}, {x + 1.5, y + 1.4, 2.});
    const double middle = 0.4 + 1.1 * random();
    Tensor<1, 3> turn;
    for (unsigned int d = 0; d < 3; ++d)
      turn[d] = 0.1 * (random() - 0.5);
    for (unsigned int v = first; v < cells.vertices.size(); ++v)
      cells.vertices[v] =
          turned_about({x + middle, y + 1., 1.}, turn, cells.vertices[v]);
  }
  return cells;
}

void check_wedges()
{
  std::cout << "Blocks with wedges between them, turned, scaled, shuffled"
            << std::endl;
  Random random(5);
  const double d = 0.01;
  const CellFaces cells = wedges(40, random);
  std::vector<unsigned int> same(cells.n_cells());
  std::iota(same.begin(), same.end(), 0);
  const FaceContacts contacts = face_contacts(cells, {d});
  const Pairs pairs = pairs_of(cells, contacts, same);
  const double bottoms = 40. * 1.1 * 0.9, area = total_area(contacts.patches);
  check("  most touch, in a part of their bottom",
        pairs.size() > 30 && area > 0.2 * bottoms && area < 0.8 * bottoms);
  double error = 0., off = 0.;
  for (unsigned int k = 0; k < 40; ++k)
  {
    const Tensor<2, 3> R = random_rotation(random);
    const double scale = std::pow(10., -3. + 9. * random());
    const std::vector<unsigned int> order =
        random_order(cells.n_cells(), random);
    const CellFaces turned =
        mapped(renumbered(cells, order, random), [&](const Point<3> &p) {
          return Point<3>(scale * (R * Tensor<1, 3>(p)));
        });
    const FaceContacts found = face_contacts(turned, {scale * d});
    error = std::max(error, difference(pairs, pairs_of(turned, found, order),
                                       1. / (scale * scale)));
  }
  for (unsigned int k = 0; k < contacts.faces.size(); ++k)
    for (const unsigned int face : contacts.faces[k])
    {
      const PolygonMoments plane = moments_of_face(cells, face);
      for (const Point<3> &p : contacts.patches[k])
        off = std::max(off, std::abs((p - plane.centroid) * plane.normal()));
    }
  check_error("  areas of patches", error, 1e-12);
  check_error("  patches are within half the tolerance of both faces",
              std::max(0., off / (0.5 * d) - 1.), 1e-10);
}

void check_invariance()
{
  std::cout << "Blocks that are turned, scaled, shuffled, and moved"
            << std::endl;
  const CellFaces cells = mixed_blocks();
  std::vector<unsigned int> same(cells.n_cells());
  std::iota(same.begin(), same.end(), 0);
  const FaceContacts contacts = face_contacts(cells, {tolerance});
  const Pairs pairs = pairs_of(cells, contacts, same);
  const double free_area = total_area(contacts.free_parts);

  Random random(3);
  double error = 0., free_error = 0., open = 0., moved_error = 0.;
  for (unsigned int k = 0; k < 40; ++k)
  {
    const Tensor<2, 3> R = random_rotation(random);
    const double scale = std::pow(10., -3. + 9. * random());
    const std::vector<unsigned int> order =
        random_order(cells.n_cells(), random);
    const CellFaces others = renumbered(cells, order, random);
    const CellFaces turned = mapped(others, [&](const Point<3> &p) {
      return Point<3>(scale * (R * Tensor<1, 3>(p)));
    });
    const FaceContacts found = face_contacts(turned, {scale * tolerance});
    error = std::max(error, difference(pairs, pairs_of(turned, found, order),
                                       1. / (scale * scale)));
    free_error = std::max(free_error, std::abs(total_area(found.free_parts) /
                                                   (scale * scale * free_area) -
                                               1.));
    open = std::max(open, uncovered(turned, found));

    const CellFaces moved = mapped(turned, [&](const Point<3> &p) {
      return p + 1e4 * scale * Tensor<1, 3>({1., -1., 1.});
    });
    moved_error = std::max(
        moved_error,
        difference(
            pairs,
            pairs_of(moved, face_contacts(moved, {scale * tolerance}), order),
            1. / (scale * scale)));
  }
  check_error("  areas of patches", error, 1e-12);
  check_error("  free area", free_error, 1e-12);
  check_error("  faces are covered", open, 1e-12);
  // The coordinates are rounded to 1e-12.
  check_error("  areas of patches far away", moved_error, 2e-11);

  const CellFaces far = mapped(brick_wall(3, 2, 4), [](const Point<3> &p) {
    return p + 16384. * Tensor<1, 3>({1., -1., 1.});
  });
  const FaceContacts found = face_contacts(far, {tolerance});
  unsigned int n_vertices = 0;
  for (const Point<3> &p : found.patches.vertices)
    n_vertices += std::find(far.vertices.begin(), far.vertices.end(), p) !=
                  far.vertices.end();
  check("  corners far away are vertices to the last bit",
        n_vertices == found.patches.vertices.size());
}

void check_closed_cells()
{
  std::cout << "Patches and free parts of a cell close it" << std::endl;
  Random random(5);
  const Tensor<2, 3> R = random_rotation(random);
  const CellFaces cells = mapped(mixed_blocks(), [&](const Point<3> &p) {
    return Point<3>(R * Tensor<1, 3>(p));
  });
  const FaceContacts contacts = face_contacts(cells, {tolerance});
  std::vector<Tensor<1, 3>> sums(cells.n_cells());
  for (unsigned int k = 0; k < contacts.faces.size(); ++k)
  {
    const Tensor<1, 3> area = moments_of(contacts.patches[k]).vector_area;
    sums[cells.cell_of_face(contacts.faces[k][0])] += area;
    sums[cells.cell_of_face(contacts.faces[k][1])] -= area;
  }
  for (unsigned int k = 0; k < contacts.free_faces.size(); ++k)
    sums[cells.cell_of_face(contacts.free_faces[k])] +=
        moments_of(contacts.free_parts[k]).vector_area;
  double largest = 0.;
  for (const Tensor<1, 3> &sum : sums)
    largest = std::max(largest, sum.norm());
  check_error("  sum of vector areas", largest, 1e-13);
}

using Exact = CGAL::Gmpq;
using Kernel = CGAL::Simple_cartesian<Exact>;
using ExactRing = std::vector<Kernel::Point_2>;

/** The convex hull of some points, counterclockwise. */
ExactRing hull_of(const ExactRing &points)
{
  ExactRing hull;
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
  return hull;
}

/** The convex hull of some random points around the origin. */
ExactRing random_hull(Random &random)
{
  ExactRing points;
  const unsigned int n = 3 + static_cast<unsigned int>(12. * random());
  for (unsigned int i = 0; i < n; ++i)
  {
    const double x = 2. * random() - 1.; // in this order
    points.emplace_back(x, 2. * random() - 1.);
  }
  return hull_of(points);
}

/** Twice the area of a triangle, negative if it runs clockwise. */
Exact turn(const Kernel::Point_2 &a,
           const Kernel::Point_2 &b,
           const Kernel::Point_2 &c)
{
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/** Add the corners of one polygon in another, and where its sides enter. */
void add_common_points(ExactRing &points,
                       const ExactRing &one,
                       const ExactRing &other)
{
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    const Kernel::Point_2 &p = one[i], &q = one[(i + 1) % one.size()];
    bool is_inside = true;
    for (std::size_t j = 0; j < other.size(); ++j)
    {
      const Kernel::Point_2 &a = other[j], &b = other[(j + 1) % other.size()];
      const Exact at_p = turn(a, b, p), at_q = turn(a, b, q);
      is_inside = is_inside && at_p >= 0;
      if (at_p * at_q < 0 && turn(p, q, a) * turn(p, q, b) < 0)
        points.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
    if (is_inside)
      points.push_back(p);
  }
}

/** The area that two convex polygons have in common: that of a hull. */
double exact_common_area(const ExactRing &one, const ExactRing &other)
{
  ExactRing points;
  add_common_points(points, one, other);
  add_common_points(points, other, one);
  const ExactRing hull = hull_of(points);
  Exact twice = 0;
  for (std::size_t i = 1; i + 1 < hull.size(); ++i)
    twice += turn(hull[0], hull[i], hull[i + 1]);
  return 0.5 * CGAL::to_double(twice);
}

std::vector<Point<2>> rounded(const ExactRing &polygon)
{
  std::vector<Point<2>> ring;
  for (const Kernel::Point_2 &p : polygon)
    ring.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
  return ring;
}

void check_exact_areas()
{
  std::cout << "Random convex faces, against exact arithmetic" << std::endl;
  Random random(7);
  double error = 0., open = 0.;
  unsigned int n_touching = 0;
  for (unsigned int k = 0; k < 500; ++k)
  {
    const ExactRing below = random_hull(random), above = random_hull(random);
    const double exact = exact_common_area(below, above);
    CellFaces cells;
    add_prism(cells, rounded(below), 0., 1.);
    add_prism(cells, rounded(above), 1., 2.);
    const FaceContacts contacts = face_contacts(cells, {1e-13});
    n_touching += !contacts.faces.empty();
    error = std::max(error, std::abs(total_area(contacts.patches) - exact));
    open = std::max(open, uncovered(cells, contacts));
  }
  check("  most touch", n_touching > 400);
  check_error("  area", error, 1e-12);
  check_error("  faces are covered", open, 1e-11);
}

/** How many of some polygons have a point of their plane z = 0 inside. */
unsigned int n_with(const SpacePolygons &polygons, const Point<3> &p)
{
  unsigned int n = 0;
  for (unsigned int k = 0; k < polygons.size(); ++k)
  {
    const auto ring = polygons[k];
    double least = ring[0][2] == 0. ? 1. : -1.;
    for (unsigned int i = 0; i < ring.size(); ++i)
      least = std::min(least,
                       cross_product_3d(ring[(i + 1) % ring.size()] - ring[i],
                                        p - ring[i])[2]);
    n += least > 0.;
  }
  return n;
}

void check_plate()
{
  std::cout << "A plate under many blocks" << std::endl;
  Random random(11);
  CellFaces cells;
  for (unsigned int i = 0; i < 12; ++i)
    for (unsigned int j = 0; j < 12; ++j)
    {
      std::vector<Point<2>> ring;
      const double turn = random();
      const unsigned int n = 3 + (i + j) % 5;
      for (unsigned int k = 0; k < n; ++k)
        ring.emplace_back(
            i + 0.5 + 0.45 * std::cos(turn + 2. * dealii::numbers::PI * k / n),
            j + 0.5 + 0.45 * std::sin(turn + 2. * dealii::numbers::PI * k / n));
      add_prism(cells, ring, 0., 1.);
    }
  add_box(cells, {0., 0., -1.}, {11.5, 12., 0.});
  cells.n_fixed = 1;
  const FaceContacts contacts = face_contacts(cells, {tolerance});
  check("  each touches it", contacts.faces.size() == 144);
  check_error("  faces are covered", uncovered(cells, contacts), 1e-12);
  SpacePolygons top; // of the plate
  for (unsigned int k = 0; k < contacts.free_faces.size(); ++k)
    if (contacts.free_faces[k] == cells.first_face[144] + 1)
      top.add(contacts.free_parts[k]);
  SpacePolygons patches; // seen from above
  for (unsigned int k = 0; k < contacts.patches.size(); ++k)
  {
    const auto ring = contacts.patches[k];
    patches.add(
        std::vector<Point<3>>(std::make_reverse_iterator(ring.end()),
                              std::make_reverse_iterator(ring.begin())));
  }
  bool is_partition = true;
  for (unsigned int k = 0; k < 2000; ++k)
  {
    const double x = 11.5 * random(); // in this order
    const Point<3> p(x, 12. * random(), 0.);
    is_partition = is_partition && n_with(top, p) + n_with(patches, p) == 1;
  }
  check("  each point of it is in one patch or free part", is_partition);
}

void check_rough_blocks()
{
  std::cout << "Blocks with vertices moved at random" << std::endl;
  const double noise = 1e-3;
  const CellFaces cells = mixed_blocks();
  std::vector<unsigned int> same(cells.n_cells());
  std::iota(same.begin(), same.end(), 0);
  const Pairs smooth = pairs_of(cells, face_contacts(cells, {tolerance}), same);
  Random random(13);
  double order_error = 0., area_error = 0.;
  bool are_same = true, are_as_many = true;
  for (unsigned int k = 0; k < 20; ++k)
  {
    CellFaces rough = cells;
    for (Point<3> &vertex : rough.vertices)
      for (unsigned int d = 0; d < 3; ++d)
        vertex[d] += noise * (2. * random() - 1.);
    const FaceContacts contacts = face_contacts(rough, {10. * noise});
    const Pairs pairs = pairs_of(rough, contacts, same);
    are_same = are_same && pairs.size() == smooth.size();
    for (const auto &[pair, area] : smooth)
    {
      const auto found = pairs.find(pair);
      if (found == pairs.end())
        are_same = false;
      else
        area_error = std::max(area_error, std::abs(found->second - area));
    }
    const std::vector<unsigned int> order =
        random_order(cells.n_cells(), random);
    const CellFaces others = renumbered(rough, order, random);
    const FaceContacts found = face_contacts(others, {10. * noise});
    are_as_many = are_as_many && found.faces.size() == contacts.faces.size() &&
                  found.free_faces.size() == contacts.free_faces.size();
    order_error = std::max(
        order_error, difference(pairs, pairs_of(others, found, order), 1.));
  }
  check("  the same pairs touch", are_same);
  check_error("  areas differ by the noise", area_error, 10. * noise);
  check("  there are as many patches and free parts in any order", are_as_many);
  check_error("  of the same areas", order_error, 1e-12);
}

void run()
{
  check_invariance();
  check_wedges();
  check_closed_cells();
  check_exact_areas();
  check_plate();
  check_rough_blocks();
}

const RoomTest test("face_contact_properties", run);
} // namespace test_face_contact_properties
