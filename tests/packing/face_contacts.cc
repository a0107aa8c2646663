// SPDX-License-Identifier: LGPL-2.1-or-later

// Contacts of faces of polyhedra against closed forms: blocks that are shifted,
// T-junctions, notched blocks, drums, open joints, tolerances.

#include "cell_faces.h"
#include "tests.h"
#include <limits>

namespace test_face_contacts
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

constexpr double tolerance = 1e-9;

/** True if a place is among the vertices to the last bit. */
bool is_vertex(const CellFaces &cells, const Point<3> &place)
{
  return std::find(cells.vertices.begin(), cells.vertices.end(), place) !=
         cells.vertices.end();
}

void check_shifted_cubes()
{
  std::cout << "Two cubes, the upper one shifted" << std::endl;
  CellFaces cells;
  add_box(cells, {0., 0., 0.}, {1., 1., 1.});
  add_box(cells, {0.3, 0.45, 1.}, {1.3, 1.45, 2.});
  const FaceContacts contacts = face_contacts(cells, {tolerance});
  check("  one patch, of the top and the bottom",
        contacts.faces.size() == 1 && contacts.faces[0][0] == 1 &&
            contacts.faces[0][1] == 6);
  const PolygonMoments patch = moments_of(contacts.patches[0]);
  check_error("  vector area out of the lower cell",
              (patch.vector_area - Tensor<1, 3>({0., 0., 0.7 * 0.55})).norm(),
              1e-15);
  check_error("  centroid", patch.centroid.distance({0.65, 0.725, 1.}), 1e-15);
  check("  two corners are vertices",
        std::count_if(contacts.patches[0].begin(), contacts.patches[0].end(),
                      [&](const Point<3> &p) { return is_vertex(cells, p); }) ==
            2);
  check_error("  free area",
              std::abs(total_area(contacts.free_parts) - 12. + 2. * 0.385),
              1e-14);
  check_error("  faces are covered", uncovered(cells, contacts), 1e-14);
  check("  the top is left in two parts, the bottom too",
        contacts.free_faces.size() == 14 &&
            std::is_sorted(contacts.free_faces.begin(),
                           contacts.free_faces.end()));

  cells.n_fixed = 1;
  check("  also if the upper one is fixed",
        face_contacts(cells, {tolerance}).faces.size() == 1);
  cells.n_fixed = 2;
  check("  two fixed cells touch nowhere",
        face_contacts(cells, {tolerance}).faces.empty());
  check("  no cells, no contacts",
        face_contacts(CellFaces(), {tolerance}).faces.empty() &&
            count_contacts(CellFaces(), {tolerance}).patches == 0);
}

void check_matching_bricks()
{
  std::cout << "Bricks that match, with T-junctions" << std::endl;
  const CellFaces cells = brick_wall(4, 2, 5);
  const FaceContacts contacts = face_contacts(cells, {tolerance});
  // Of n bricks a course and leaf, beds of 2n-1 halves.
  const unsigned int in_courses = 5 * (2 * 3 + 4), beds = 4 * 2 * 7;
  check("  number of patches", contacts.faces.size() == in_courses + beds);
  unsigned int n_exact = 0;
  for (const Point<3> &p : contacts.patches.vertices)
    n_exact += is_vertex(cells, p);
  check("  corners are vertices to the last bit",
        n_exact == contacts.patches.vertices.size());
  check_error(
      "  area",
      std::abs(total_area(contacts.patches) - 5. * (6. * 0.5 + 4.) - beds),
      1e-13);
  check_error("  faces are covered", uncovered(cells, contacts), 1e-14);
  check("  the order is that of faces",
        std::is_sorted(contacts.faces.begin(), contacts.faces.end()));
  const ContactCount count = count_contacts(cells, {tolerance});
  check("  so many are counted", count.patches == contacts.faces.size() &&
                                     count.pairs_of_cells == count.patches);
}

void check_notched_blocks()
{
  std::cout << "A notched block on a plate, with a block in its notch"
            << std::endl;
  CellFaces cells;
  add_box(cells, {-1., -1., -1.}, {4., 4., 0.});
  add_prism(cells, {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, 0., 1.);
  add_box(cells, {1., 1., 0.}, {2., 2., 1.});
  const FaceContacts contacts = face_contacts(cells, {tolerance});
  std::vector<std::array<unsigned int, 2>> faces = contacts.faces;
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  check("  four pairs of faces", faces.size() == 4);
  check("  several patches of the notched one", contacts.faces.size() > 4);
  check_error("  area",
              std::abs(total_area(contacts.patches) - 5. - 1. - 1. - 1.),
              1e-14);
  check_error("  faces are covered", uncovered(cells, contacts), 1e-14);
  const ContactCount count = count_contacts(cells, {tolerance});
  check("  three pairs of cells",
        count.pairs_of_cells == 3 && count.patches == contacts.faces.size());
}

/** A regular polygon of inradius 1, turned. */
std::vector<Point<2>> regular_polygon(const unsigned int n, const double turn)
{
  std::vector<Point<2>> ring;
  for (unsigned int i = 0; i < n; ++i)
  {
    const double angle = turn + 2. * dealii::numbers::PI * i / n;
    ring.emplace_back(std::cos(angle) / std::cos(dealii::numbers::PI / n),
                      std::sin(angle) / std::cos(dealii::numbers::PI / n));
  }
  return ring;
}

void check_drums()
{
  std::cout << "Drums of n sides, turned by half a side" << std::endl;
  double error = 0., open = 0.;
  for (unsigned int n = 3; n <= 96; n += 3)
  {
    CellFaces cells;
    const double half = dealii::numbers::PI / n;
    add_prism(cells, regular_polygon(n, 0.1), 0., 1.);
    add_prism(cells, regular_polygon(n, 0.1 + half), 1., 2.);
    const FaceContacts contacts = face_contacts(cells, {tolerance});
    // A polygon of 2n sides with the same inradius.
    const double exact = 2. * n * std::tan(0.5 * half);
    error =
        std::max(error, std::abs(total_area(contacts.patches) / exact - 1.));
    open = std::max(open, uncovered(cells, contacts));
    if (contacts.patches.vertices.size() != 2 * n)
      std::cout << "FAILED: corners for " << n << std::endl;
  }
  check_error("  area", error, 1e-14);
  check_error("  faces are covered", open, 1e-13);
}

void check_tolerance()
{
  std::cout << "What the tolerance decides" << std::endl;
  const auto cubes = [](const Point<3> &shift) {
    CellFaces cells;
    add_box(cells, {0., 0., 0.}, {1., 1., 1.});
    add_box(cells, shift, {shift[0] + 1., shift[1] + 1., shift[2] + 1.});
    return cells;
  };
  const double d = 1e-3;
  const CellFaces apart = cubes({0., 0., 1. + 0.9 * d});
  const FaceContacts found = face_contacts(apart, {d});
  check("  a distance below it is none", found.faces.size() == 1);
  check_error(
      "  the patch is midway",
      std::abs(moments_of(found.patches[0]).centroid[2] - 1. - 0.45 * d),
      1e-15);
  check("  nor is an overlap",
        face_contacts(cubes({0., 0., 1. - 0.9 * d}), {d}).faces.size() == 1);
  check("  one above it is",
        face_contacts(cubes({0., 0., 1. + 1.1 * d}), {d}).faces.empty() &&
            face_contacts(cubes({0., 0., 1. - 1.1 * d}), {d}).faces.empty());

  const FaceContacts aligned =
      face_contacts(cubes({0.9 * d, -0.7 * d, 1.}), {d});
  check("  corners as near are the same: four, and no slivers",
        aligned.patches.vertices.size() == 4 &&
            aligned.free_faces.size() == 10);
  check("  a patch as narrow is none",
        face_contacts(cubes({1. - 0.9 * d, 0., 1.}), {d}).faces.empty());
  check("  a wider one is",
        face_contacts(cubes({1. - 1.1 * d, 0., 1.}), {d}).faces.size() == 1);
}

/** A cube on another one, its bottom turned about x = @p axis. */
CellFaces wedge(const double slope, const double axis)
{
  CellFaces cells;
  add_box(cells, {0., 0., 0.}, {1., 1., 1.});
  const unsigned int n = cells.vertices.size();
  add_box(cells, {0., 0., 1.}, {1., 1., 2.});
  for (unsigned int v = n; v < cells.vertices.size(); ++v)
    cells.vertices[v][2] += slope * (cells.vertices[v][0] - axis);
  return cells;
}

void check_angles()
{
  std::cout << "A block that rises by some of the tolerance" << std::endl;
  const double d = 1e-3;
  for (const double rise : {0.9, 1.1, 2., 5., 9., 11.})
  {
    const FaceContacts found = face_contacts(wedge(rise * d, 0.), {d});
    check(text("  ", rise, (rise < 10.) ? ": touches" : ": along an edge only"),
          found.faces.size() == (rise < 10. ? 1 : 0));
    if (found.faces.empty())
      continue;
    const PolygonMoments patch = moments_of(found.patches[0]);
    const double half_angle = 0.5 * std::atan(rise * d);
    check_error("  on the plane between them",
                std::abs(patch.normal()[0] + std::sin(half_angle)), 1e-15);
    if (rise > 1.) // up to the distance d
      check_error("  area",
                  std::abs(patch.area() - 0.5 * d / std::tan(half_angle)),
                  1e-13);
  }
  const FaceContacts found = face_contacts(wedge(8. * d, 0.5), {d});
  check("  that is turned about its middle: touches", found.faces.size() == 1);
  const PolygonMoments patch = moments_of(found.patches[0]);
  check_error("  area",
              std::abs(patch.area() - d / std::tan(0.5 * std::atan(8. * d))),
              1e-13);
  check_error("  centroid", patch.centroid.distance({0.5, 0.5, 1.}), 1e-13);
}

void check_joints()
{
  std::cout << "Open joints" << std::endl;
  CellFaces bricks;
  add_box(bricks, {0., 0., 0.}, {2., 1., 1.});
  add_box(bricks, {0.5, 0., 1.1}, {2.5, 1., 2.1});
  const FaceContacts joint = face_contacts(bricks, {tolerance, 0.1});
  check("  one joint as wide as they are apart", joint.faces.size() == 1);
  check_error(
      "  of the area that both have",
      (moments_of(joint.patches[0]).vector_area - Tensor<1, 3>({0., 0., 1.5}))
          .norm(),
      1e-14);
  check_error("  midway",
              moments_of(joint.patches[0]).centroid.distance({1.25, 0.5, 1.05}),
              1e-15);
  check_error("  faces are covered", uncovered(bricks, joint), 1e-14);
  check("  none if the width is less",
        face_contacts(bricks, {tolerance, 0.099}).faces.empty());

  std::cout << "A thin stone between two, that is half as long" << std::endl;
  CellFaces thin;
  add_box(thin, {0., 0., 0.}, {2., 1., 1.});
  add_box(thin, {0., 0., 1.02}, {1., 1., 1.07});
  add_box(thin, {0., 0., 1.1}, {2., 1., 2.});
  const FaceContacts seen = face_contacts(thin, {tolerance, 0.2});
  check("  three joints", seen.faces.size() == 3);
  check_error("  each half as long", std::abs(total_area(seen.patches) - 3.),
              1e-14);
  check_error("  the two outer ones see each other beside it",
              moments_of(seen.patches[1]).centroid.distance({1.5, 0.5, 1.05}),
              1e-14);
  thin.vertices[9][0] = thin.vertices[10][0] = 1.95;
  thin.vertices[13][0] = thin.vertices[14][0] = 1.95;
  check("  not through a slot that is narrower than wide",
        face_contacts(thin, {tolerance, 0.2}).faces.size() == 2);

  std::cout << "A roof between two, its ridge across" << std::endl;
  CellFaces roof;
  add_box(roof, {0., 0., 0.}, {4., 1., 1.});
  add_box(roof, {0., 0., 1.5}, {4., 1., 2.});
  const unsigned int first = roof.vertices.size();
  add_box(roof, {1., 0., 1.1}, {2., 1., 1.4});
  for (const unsigned int v : {4, 5, 6, 7})
    roof.vertices[first + v][0] = 1.5 + 1e-3 * (v == 5 || v == 6 ? 1. : -1.);
  const FaceContacts beside = face_contacts(roof, {tolerance, 0.6});
  double between = 0.;
  for (unsigned int k = 0; k < beside.faces.size(); ++k)
    if (beside.faces[k] == std::array<unsigned int, 2>{{1, 6}})
      between += moments_of(beside.patches[k]).area();
  check_error("  covers its shadow", std::abs(between - 3.), 1e-14);
}

void check_shared_faces()
{
  std::cout << "Faces that are shared are taken as they are" << std::endl;
  CellFaces cells;
  for (unsigned int k = 0; k < 3; ++k)
    for (const Point<2> &p : {Point<2>(0., 0.), Point<2>(1., 0.),
                              Point<2>(1., 1.), Point<2>(0., 1.)})
      cells.vertices.emplace_back(p[0], p[1], k);
  for (unsigned int k = 0; k < 2; ++k)
  {
    const unsigned int v = 4 * k;
    using Loop = std::vector<unsigned int>;
    cells.add_face(Loop{v + 3, v + 2, v + 1, v});
    cells.add_face(Loop{v + 4, v + 5, v + 6, v + 7});
    for (unsigned int i = 0; i < 4; ++i)
      cells.add_face(
          Loop{v + i, v + (i + 1) % 4, v + 4 + (i + 1) % 4, v + 4 + i});
    cells.end_cell();
  }
  cells.shared = {{{6, 1}}};
  const FaceContacts contacts = face_contacts(cells, {0.});
  check("  the lower cell comes first", contacts.faces.size() == 1 &&
                                            contacts.faces[0][0] == 1 &&
                                            contacts.faces[0][1] == 6);
  check_error(
      "  its normal is out of that",
      (moments_of(contacts.patches[0]).vector_area - Tensor<1, 3>({0., 0., 1.}))
          .norm(),
      0.);
  check("  all others are free", contacts.free_faces.size() == 10);
  check_error("  faces are covered", uncovered(cells, contacts), 0.);
  check("  one is counted",
        count_contacts(cells, {0.}).patches == 1 &&
            count_contacts(cells, {0.}).pairs_of_cells == 1);
}

void check_short_sides()
{
  std::cout << "A side as short as rounding, with any direction" << std::endl;
  CellFaces cells;
  const std::vector<Point<2>> ring = {
      {0., 0.}, {1., 0.}, {1. - 1.2e-16, 1e-16}, {1., 1.}, {0., 1.}};
  add_prism(cells, ring, 0., 1.);
  add_prism(cells, ring, 1., 2.);
  const FaceContacts found = face_contacts(cells, {0.});
  check("  does not cut the patch", found.faces.size() == 1);
  check_error("  area", std::abs(total_area(found.patches) - 1.), 1e-15);
  cells.shared = {{{1, 7}}};
  check("  nor a face that is shared",
        face_contacts(cells, {0.}).patches.vertices.size() == 5);
}

void check_refusals()
{
  CellFaces cells;
  add_box(cells, {0., 0., 0.}, {1., 1., 1.});
  show_refusal([&] { face_contacts(cells, {-1.}); });
  show_refusal([&] {
    face_contacts(cells, {std::numeric_limits<double>::quiet_NaN()});
  });
  show_refusal([&] {
    count_contacts(cells, {1., std::numeric_limits<double>::infinity()});
  });
  cells.vertices[5][1] = std::numeric_limits<double>::quiet_NaN();
  cells.file = "blocks.obj";
  cells.record_name = "object";
  cells.records = {17};
  show_refusal([&] { face_contacts(cells, {tolerance}); });
  cells.vertices[5][1] = std::numeric_limits<double>::infinity();
  show_refusal([&] { count_contacts(cells, {tolerance}); });
  CellFaces crossed;
  add_prism(crossed, {{0, 0}, {2, 0}, {2, 2}, {1, -1}, {0, 2}}, 0., 1.);
  show_refusal([&] { face_contacts(crossed, {tolerance}); });
}

void run()
{
  check_shifted_cubes();
  check_matching_bricks();
  check_notched_blocks();
  check_drums();
  check_tolerance();
  check_angles();
  check_joints();
  check_shared_faces();
  check_short_sides();
  check_refusals();
}

const RoomTest test("face_contacts", run);
} // namespace test_face_contacts
