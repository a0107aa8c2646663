// SPDX-License-Identifier: LGPL-2.1-or-later

// Joints where polyhedra touch with an edge or a vertex only: where they are,
// their normals and sizes, in any place, size and order of the cells; none
// where there is no normal, beside what touches with faces, and unless they are
// asked for. Free boundaries stay whole.

#include <voussoir/packing/polyhedra/fixed_cells.h>
#include <voussoir/packing/polyhedra/packing.h>

#include "cell_faces.h"
#include "tests.h"

namespace test_edge_contacts
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

constexpr double tolerance = 1e-9;
/** The width of joints, over the shortest edge around. */
constexpr double width = 1e-6;

FaceContacts contacts_of(const CellFaces &cells, const double unit = 1.)
{
  return face_contacts(cells, {unit * tolerance, 0., true});
}

/** The joints that are expected: their normals, centroids and areas. */
struct Expected
{
  Tensor<1, 3> normal;
  Point<3> place;
  double area;
};

/** The largest deviation of what is found, in any order. */
double deviation(const FaceContacts &contacts,
                 const std::vector<Expected> &expected,
                 const double unit)
{
  if (contacts.at_edges.size() != expected.size())
    return 1e9;
  double largest = 0.;
  for (const Expected &e : expected)
  {
    double least = 1e9;
    for (const EdgeContact &joint : contacts.at_edges)
    {
      const PolygonMoments of =
          moments_of(dealii::ArrayView<const Point<3>>(joint.polygon));
      // The normal has all digits; the cells may be numbered the other way.
      const double turned = joint.normal * e.normal < 0. ? -1. : 1.;
      Tensor<1, 3> middle;
      for (const Point<3> &corner : joint.polygon)
        middle += (corner - e.place) / double(joint.polygon.size());
      const double place = middle.norm() / unit;
      const double area = std::abs(of.area() / e.area - 1.);
      least =
          std::min(least, std::max({(turned * joint.normal - e.normal).norm(),
                                    place, 1e-5 * area}));
      if (!(of.vector_area * joint.normal > 0.))
        return 1e8;
    }
    largest = std::max(largest, least);
  }
  return largest;
}

/** The joints here; turned, scaled, moved and in another order. */
void check_joints(const std::string &name,
                  const CellFaces &cells,
                  const std::vector<Expected> &expected)
{
  std::cout << name << std::endl;
  const FaceContacts contacts = contacts_of(cells);
  check_error("  joints", deviation(contacts, expected, 1.), 1e-12);
  if (!contacts.notice.empty())
    std::cout << "  " << contacts.notice << std::endl;
  const FaceContacts of_faces = face_contacts(cells, {tolerance});
  check("  none unless asked for",
        of_faces.at_edges.empty() && of_faces.notice.empty());
  check("  patches and free parts are the same",
        contacts.faces == of_faces.faces &&
            contacts.free_faces == of_faces.free_faces &&
            contacts.free_parts.vertices == of_faces.free_parts.vertices);
  check_error("  faces are covered", uncovered(cells, contacts), 1e-13);
  Random random(1);
  double largest = 0.;
  for (const double unit : {1e-9, 1., 1e9})
  {
    const Tensor<2, 3> R = random_rotation(random);
    const Tensor<1, 3> shift({2., -3., 5.});
    const auto place = [&](const Point<3> &x) {
      return Point<3>(unit * (R * x + shift));
    };
    std::vector<Expected> there;
    for (const Expected &e : expected)
      there.push_back({R * e.normal, place(e.place), unit * unit * e.area});
    const CellFaces others = renumbered(
        mapped(cells, place), random_order(cells.n_cells(), random), random);
    largest =
        std::max(largest, deviation(contacts_of(others, unit), there, unit));
  }
  check_error("  turned, scaled and in another order", largest, 1e-12);
}

/** A floor of 4 x 4 x 1 below z = 0. */
CellFaces on_floor()
{
  CellFaces cells;
  add_box(cells, {-2., -2., -1.}, {2., 2., 0.});
  return cells;
}

void joints()
{
  const Tensor<1, 3> up({0., 0., 1.});
  CellFaces cells = on_floor();
  add_bar(cells, {{0., 0.}, {1., 1.}, {0., 2.}, {-1., 1.}}, -1., 1.);
  check_joints("A cube on its edge", cells,
               {{up, {0., 0., 0.}, 2. * width * std::sqrt(2.)}});

  cells = on_floor();
  add_bar(cells, {{0., 0.}, {1., 1.}, {0., 2.}, {-1., 1.}}, -1., 3.);
  check_joints("beyond the side of the floor", cells,
               {{up, {0., 0.5, 0.}, 3. * width * std::sqrt(2.)}});

  cells = on_floor();
  add_pyramid(cells, {{1., 0.}, {0., 1.}, {-1., -1.}}, 1., {0., 0., 0.});
  check_joints(
      "A tetrahedron on its tip", cells,
      {{up, {0., 0., 0.}, 0.75 * std::sqrt(3.) * 0.25 * width * width * 2.}});

  cells = on_floor();
  add_pyramid(cells, {{1., 1.}, {-1., 1.}, {-1., -1.}, {1., -1.}}, 1.,
              {0.5, 0., 0.});
  check_joints("A leaning pyramid on its tip", cells,
               {{up, {0.5, 0., 0.}, 2. * 0.25 * width * width * 2.25}});

  CellFaces bars, upper;
  add_bar(bars, {{0., -2.}, {1., -1.}, {0., 0.}, {-1., -1.}}, -3., 3.);
  add_bar(upper, {{0., 0.}, {1., 1.}, {0., 2.}, {-1., 1.}}, -3., 3.);
  const double c = std::cos(0.5), s = std::sin(0.5);
  add_cells(bars, mapped(upper, [&](const Point<3> &p) {
              return Point<3>(c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]);
            }));
  check_joints("Two bars that cross", bars,
               {{up, {0., 0., 0.}, width * width * s}});

  cells = on_floor();
  add_pyramid(cells, {{-1., -1.}, {-0.5, -1.}, {-1., -0.5}}, 1.,
              {-1., -1., 0.});
  add_pyramid(cells, {{1., 1.}, {0.5, 1.}, {1., 0.5}}, 1., {1., 1., 0.});
  add_pyramid(cells, {{1., -1.}, {1., -0.5}, {0.5, -1.}}, 1., {1., -1., 0.});
  std::cout << "Three tips" << std::endl;
  check("  three joints", contacts_of(cells).at_edges.size() == 3);
  std::cout << "  " << contacts_of(cells).notice << std::endl;
}

/** What touches where there is no normal, or with faces, gets no joint. */
void no_joints()
{
  std::cout << "No joints" << std::endl;
  const auto has_none = [&](const std::string &name, const CellFaces &cells) {
    check("  " + name, contacts_of(cells).at_edges.empty() &&
                           contacts_of(cells).notice.empty());
  };
  CellFaces cells;
  add_box(cells, {0., 0., 0.}, {1., 1., 1.});
  add_box(cells, {1., 0.3, 1.}, {2., 1.3, 2.});
  has_none("edge on edge", cells);
  cells = CellFaces();
  add_box(cells, {0., 0., 0.}, {1., 1., 1.});
  add_box(cells, {1., 1., 1.}, {2., 2., 2.});
  has_none("corner on corner", cells);
  cells = on_floor();
  add_pyramid(cells, {{3., 0.}, {2., 1.}, {1., -1.}}, 1., {2., 0., 0.});
  has_none("a tip on an edge", cells);
  cells = on_floor();
  add_box(cells, {-0.5, -0.5, 0.}, {0.5, 0.5, 1.});
  add_box(cells, {-0.5, -0.5, 1.}, {0.7, 0.3, 2.});
  has_none("face on face", cells);
  has_none("two leaves in running bond", brick_wall(4, 2, 4));
  has_none("three leaves in running bond", brick_wall(4, 3, 4));
  cells = on_floor();
  add_bar(cells, {{0., -0.1}, {1., 1.}, {0., 2.}, {-1., 1.}}, -1., 1.);
  has_none("an edge within the floor", cells);
  cells = on_floor();
  add_bar(cells, {{0., 1e-6}, {1., 1.}, {0., 2.}, {-1., 1.}}, -1., 1.);
  has_none("an edge above it", cells);
  cells = on_floor();
  add_bar(cells, {{0., 0.}, {1., 1.}, {0., 2.}, {-1., 1.}}, -1., 1.);
  cells.n_fixed = 2;
  has_none("of fixed cells", cells);
}

/** A block with a flat foot and an edge that stands beside it. */
void feet()
{
  CellFaces cells = on_floor();
  add_bar(cells,
          {{-1., 0.},
           {-0.5, 0.},
           {-0.5, 0.5},
           {0.25, 0.5},
           {0.5, 0.},
           {0.75, 0.5},
           {1., 0.5},
           {1., 1.},
           {-1., 1.}},
          -1., 1.);
  check_joints("A foot and an edge", cells,
               {{Tensor<1, 3>({0., 0., 1.}),
                 {0.5, 0., 0.},
                 2. * width * std::sqrt(0.3125)}});
}

/** An edge at a small angle touches where it is within the tolerance. */
void angles()
{
  std::cout << "An edge at an angle" << std::endl;
  const double d = 0.01;
  for (const double rise : {0.5 * d, 4. * d, 40. * d})
  {
    CellFaces cells = on_floor();
    add_bar(cells, {{0., 0.}, {1., 1.}, {0., 2.}, {-1., 1.}}, -1., 1.);
    cells = mapped(cells, [&](const Point<3> &p) {
      return p[2] < 0. || std::abs(p[0]) > 1.5
                 ? p
                 : Point<3>(p[0], p[1], p[2] + rise * 0.5 * (p[1] + 1.));
    });
    const FaceContacts found = face_contacts(cells, {d, 0., true});
    check("  a joint", found.at_edges.size() == 1);
    for (const EdgeContact &joint : found.at_edges)
      std::cout << "  rises by " << rise / d << " tolerances: "
                << (joint.is_in_point
                        ? std::string("in a point")
                        : text("along ",
                               joint.polygon[0].distance(joint.polygon[1])))
                << std::endl;
  }
}

void packing()
{
  std::cout << "A packing" << std::endl;
  CellFaces cells = on_floor();
  add_bar(cells, {{0., 0.}, {1., 1.}, {0., 2.}, {-1., 1.}}, -1., 1.);
  add_pyramid(cells, {{2., 1.}, {1., 2.}, {1., 1.}}, 1., {1.5, 1.5, 0.});
  cells.tolerance = tolerance;
  cells.joins_edges = true;
  const Packing<3> moving(cells);
  check("  two interfaces, in order",
        moving.interfaces().size() == 2 &&
            moving.interfaces()[0].cell_plus == 1 &&
            moving.interfaces()[1].cell_plus == 2);
  const auto &joint = moving.interfaces()[0];
  check("  with their distances",
        moving.distance(joint) == std::sqrt(joint.area));
  check("  one notice", moving.notices().size() == 1);
  const Packing<3> standing(
      with_fixed_cells(moving.polyhedra(), {true, false, false}));
  check("  two supports on the fixed floor", standing.n_supports() == 2);
  check("  one notice, with its number",
        standing.notices().size() == 1 &&
            standing.notices()[0].find("cell 0 and cell 2") !=
                std::string::npos);
  const ContactCount count =
      count_contacts(moving.polyhedra(), {tolerance, 0., true});
  check("  counted", count.pairs_of_cells == 2 && count.patches == 2 &&
                         count_found(cells, moving.contacts()).patches == 2);
}

void run()
{
  joints();
  no_joints();
  feet();
  angles();
  packing();
}

const RoomTest test("edge_contacts", run);
} // namespace test_edge_contacts
