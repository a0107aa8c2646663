// SPDX-License-Identifier: LGPL-2.1-or-later

// The triangles of a face cover it: there are two less than corners, all look
// the way of the face, and their areas add up to its own, wherever it lies and
// however large it is.

#include <voussoir/packing/polyhedra/face_triangles.h>
#include <voussoir/packing/polyhedra/space_polygons.h>

#include "tests.h"

namespace test_face_triangles
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

/** A face with corners in a plane that is turned about all axes. */
CellFaces face_of(const std::vector<Point<2>> &polygon,
                  const double size = 1.,
                  const Tensor<1, 3> &shift = Tensor<1, 3>())
{
  const Tensor<1, 3> u({2. / 3., 2. / 3., 1. / 3.});
  const Tensor<1, 3> v({-2. / 3., 1. / 3., 2. / 3.});
  CellFaces cells;
  std::vector<unsigned int> corners;
  for (const Point<2> &p : polygon)
  {
    corners.push_back(cells.vertices.size());
    cells.vertices.push_back(Point<3>(shift + size * (p[0] * u + p[1] * v)));
  }
  cells.add_face(corners);
  cells.end_cell();
  return cells;
}

/** The double vector area of a triangle of the face; L^2. */
Tensor<1, 3> double_area(const CellFaces &cells,
                         const std::array<unsigned int, 3> &triangle)
{
  const Point<3> &a = cells.vertex(0, triangle[0]);
  return cross_product_3d(cells.vertex(0, triangle[1]) - a,
                          cells.vertex(0, triangle[2]) - a);
}

/** The error of the area, over it; one if a triangle looks the other way. */
double error_of(const CellFaces &cells)
{
  const PolygonMoments moments = moments_of(cells.polygon(0));
  double area = 0.;
  for (const auto &triangle : triangles_of(cells, 0))
  {
    const Tensor<1, 3> a = double_area(cells, triangle);
    area += 0.5 * a.norm();
    if (a * moments.vector_area < -1e-12 * moments.area() * moments.area())
      return 1.;
  }
  return std::abs(area - moments.area()) / moments.area();
}

void check_face(const std::string &name,
                const std::vector<Point<2>> &polygon,
                const bool is_convex)
{
  bool all = true;
  double error = 0.;
  for (const double size : {1e-6, 1., 1e9})
    for (const double shift : {0., 1e3})
    {
      const CellFaces cells =
          face_of(polygon, size, shift * size * Tensor<1, 3>({1., -2., 3.}));
      all = all && triangles_of(cells, 0).size() == polygon.size() - 2 &&
            is_convex_face(cells, 0) == is_convex;
      error = std::max(error, error_of(cells));
    }
  check(name, all);
  check_error("  area", error, 1e-9);
}

void run()
{
  check_face("triangle", {{0., 0.}, {1., 0.}, {0., 1.}}, true);
  check_face("square", {{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}}, true);
  check_face("L", {{0., 0.}, {3., 0.}, {3., 1.}, {1., 1.}, {1., 3.}, {0., 3.}},
             false);
  check_face("arrow, whose first corner sees least",
             {{4., 1.}, {0., 4.}, {1., 0.}, {0., -4.}}, false);
  // Teeth of a comb.
  std::vector<Point<2>> comb = {{0., -1.}, {40., -1.}};
  for (int k = 40; k >= 0; --k)
    comb.emplace_back(k, k % 2 == 0 ? 5. : 0.);
  check_face("comb", comb, false);
  check_face("corners within sides",
             {{0., 0.}, {2., 0.}, {2., 1.}, {1., 1.}, {1., 0.5}, {0., 0.5}},
             false);

  // What has no inside is not cut, nor does it end the program.
  const CellFaces bow = face_of({{0., 0.}, {2., 2.}, {2., 0.}, {0., 1.}});
  check("a face that crosses itself", triangles_of(bow, 0).size() == 2);
  const CellFaces line = face_of({{0., 0.}, {1., 0.}, {2., 0.}, {1., 0.}});
  check("a face without area", triangles_of(line, 0).size() == 2);
  const CellFaces point = face_of({{1., 1.}, {1., 1.}, {1., 1.}, {1., 1.}});
  check("a point", triangles_of(point, 0).size() == 2);
  check("two corners", triangles_of(face_of({{0., 0.}, {1., 0.}}), 0).empty());
}

const RoomTest test("face_triangles", run);
} // namespace test_face_triangles
