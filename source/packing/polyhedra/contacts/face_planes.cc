// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/contacts/face_planes.h>
#include <voussoir/packing/polyhedra/space_polygons.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
namespace
{
using dealii::Point;

/** The number of units of rounding by which a computed place may be wrong. */
constexpr double units_of_rounding = 16.;

bool is_finite_place(const Point<3> &place)
{
  return std::isfinite(place[0]) && std::isfinite(place[1]) &&
         std::isfinite(place[2]);
}

/**
 * The plane of a face with these vertices. Where they are in no plane the
 * height of the centroid would depend on the vertex at which the face begins.
 */
FacePlane plane_of(const std::vector<Point<3>> &polygon)
{
  const PolygonMoments moments =
      moments_of(dealii::ArrayView<const Point<3>>(polygon));
  FacePlane plane;
  plane.area = moments.area();
  plane.centre = moments.centroid;
  if (plane.area > 0.)
  {
    plane.normal = moments.normal();
    double height = 0.;
    for (const Point<3> &place : polygon)
      height += plane.normal * (place - plane.centre) / polygon.size();
    plane.centre += height * plane.normal;
  }
  double square = 0.;
  for (const Point<3> &place : polygon)
    square = std::max(square, plane.centre.distance_square(place));
  plane.radius = std::sqrt(square);
  return plane;
}
} // namespace

std::vector<FacePlane> face_planes(const CellFaces &cells)
{
  std::vector<FacePlane> planes;
  planes.reserve(cells.n_faces());
  std::vector<Point<3>> polygon;
  for (unsigned int f = 0; f < cells.n_faces(); ++f)
  {
    polygon.clear();
    for (const unsigned int v : cells.corners(f))
    {
      const Point<3> &place = cells.vertices[v];
      if (!is_finite_place(place))
        throw InputError(text("A vertex of ", describe_face(cells, f),
                              " is at ", text_of_point(place),
                              "; all coordinates must be finite."));
      polygon.push_back(place);
    }
    planes.push_back(plane_of(polygon));
  }
  return planes;
}

double coordinate_rounding(const CellFaces &cells)
{
  double largest = 0.;
  for (const unsigned int v : cells.loops)
    for (unsigned int d = 0; d < 3; ++d)
      largest = std::max(largest, std::abs(cells.vertices[v][d]));
  return units_of_rounding * std::numeric_limits<double>::epsilon() * largest;
}

std::string describe_face(const CellFaces &cells, const unsigned int face)
{
  const unsigned int cell = cells.cell_of_face(face);
  return text("face ", face - cells.first_face[cell], " of ",
              cells.describe(cell));
}
} // namespace Voussoir
