// SPDX-License-Identifier: LGPL-2.1-or-later

// Faces that are in no plane touch wherever the lists of their corners begin.

#include <voussoir/packing/polyhedra/face_contacts.h>
#include <voussoir/packing/polyhedra/space_polygons.h>

#include "cell_faces.h"
#include "tests.h"

namespace test_warped_faces
{
using namespace Voussoir;
using dealii::Point;

constexpr double tolerance = 1e-9;

/** The corners of all faces of a cell begin @p n places later. */
void roll_faces(CellFaces &cells, const unsigned int cell, const unsigned int n)
{
  for (unsigned int f = cells.first_face[cell]; f < cells.first_face[cell + 1];
       ++f)
  {
    const auto first = cells.loops.begin() + cells.first_corner[f];
    std::rotate(first, first + n % cells.corners(f).size(),
                cells.loops.begin() + cells.first_corner[f + 1]);
  }
}

void run()
{
  const double warp = 0.05;
  CellFaces cells;
  add_box(cells, {0., 0., 0.}, {1., 1., 1.});
  add_box(cells, {0., 0., 1.}, {1., 1., 2.});
  for (Point<3> &vertex : cells.vertices)
    if (vertex == Point<3>(1., 1., 1.))
      vertex[2] += warp;
  bool touch = true;
  double difference = 0.;
  const double area =
      moments_of(face_contacts(cells, {tolerance}).patches[0]).area();
  for (unsigned int k = 0; k < 16; ++k)
  {
    CellFaces rolled = cells;
    roll_faces(rolled, 0, k % 4);
    roll_faces(rolled, 1, k / 4);
    const FaceContacts contacts = face_contacts(rolled, {tolerance});
    touch = touch && contacts.faces.size() == 1;
    if (touch)
      difference = std::max(
          difference, std::abs(moments_of(contacts.patches[0]).area() - area));
  }
  check("they touch wherever faces begin", touch);
  check_error("in the same area", difference, 1e-12);
}

const RoomTest test("warped_faces", run);
} // namespace test_warped_faces
