// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/report/space/drawing_order.h>
#include <voussoir/output/report/space/isometric_view.h>
#include <voussoir/output/report/space/space_picture.h>
#include <voussoir/packing/polyhedra/space_polygons.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
using dealii::BoundingBox;
using dealii::Point;
using dealii::Tensor;

/**
 * The share of a face that must be free for it to be drawn: patches narrower
 * than the tolerance of contacts are missing.
 */
constexpr double least_free_share = 1e-3;

/** The cosine of a face to the view below which it is seen edge-on. */
constexpr double least_cosine = 1e-9;

/** The number of steps from the darkest to the lightest face. */
constexpr unsigned int n_lights = 9;

/** The brightness of a face that the light does not reach. */
constexpr double least_brightness = 0.68;

/** The area of each face that joints cover; L^2. */
std::vector<double> covered_areas(const CellFaces &cells,
                                  const FaceContacts *contacts)
{
  std::vector<double> areas(cells.n_faces());
  for (unsigned int j = 0; contacts && j < contacts->faces.size(); ++j)
  {
    const double area = moments_of(contacts->patches[j]).area();
    const auto &[one, other] = contacts->faces[j];
    areas[one] += area;
    if (other != one)
      areas[other] += area;
  }
  return areas;
}

/** The class of a face by the light on it, which falls from the upper left. */
std::string light_class(const Tensor<1, 3> &normal, const IsometricView &view)
{
  const double light = -0.45 * (normal * view.right) +
                       0.65 * (normal * view.up) +
                       0.61 * (normal * view.towards);
  return text('l', std::lround(std::clamp(light, 0., 1.) * (n_lights - 1)));
}

/** The classes of a block, by its values. */
std::string cell_classes(const SpaceReport &report,
                         const unsigned int cell,
                         const std::vector<ColourScale> &scales)
{
  std::string classes = "cell";
  if (cell >= report.cells->n_cells() - report.cells->n_fixed)
    return classes + " fixed";
  for (std::size_t k = 0; k < scales.size(); ++k)
    classes += ' ' + scales[k].class_of(report.cell_fields[k].values[cell]);
  return classes;
}

/** A face that is drawn. */
struct DrawnFace
{
  /** Of its centroid, in units of the view. */
  double nearness;
  /** Its number. */
  unsigned int face;
  /** The unit outer normal. */
  Tensor<1, 3> normal;
};

/** The faces of a cell among some, which are ascending; the farthest first. */
std::vector<DrawnFace> faces_of(const CellFaces &cells,
                                const unsigned int cell,
                                const std::vector<unsigned int> &faces,
                                const IsometricView &view)
{
  std::vector<DrawnFace> drawn;
  for (auto f =
           std::lower_bound(faces.begin(), faces.end(), cells.first_face[cell]);
       f != faces.end() && *f < cells.first_face[cell + 1]; ++f)
  {
    const PolygonMoments moments = moments_of_face(cells, *f);
    drawn.push_back({view.nearness(moments.centroid), *f, moments.normal()});
  }
  std::stable_sort(drawn.begin(), drawn.end(),
                   [](const DrawnFace &a, const DrawnFace &b) {
                     return a.nearness < b.nearness;
                   });
  return drawn;
}

std::vector<Point<2>> places_of(const CellFaces &cells,
                                const unsigned int face,
                                const IsometricView &view)
{
  std::vector<Point<2>> places;
  for (const unsigned int v : cells.corners(face))
    places.push_back(view.place(cells.vertices[v]));
  return places;
}
} // namespace

std::vector<unsigned int> faces_in_picture(const CellFaces &cells,
                                           const FaceContacts *contacts)
{
  const IsometricView view;
  const std::vector<double> covered = covered_areas(cells, contacts);
  std::vector<unsigned int> faces;
  for (unsigned int f = 0; f < cells.n_faces(); ++f)
  {
    const PolygonMoments moments = moments_of_face(cells, f);
    const double area = moments.area();
    if (moments.vector_area * view.towards > least_cosine * area &&
        covered[f] <= (1. - least_free_share) * area)
      faces.push_back(f);
  }
  return faces;
}

Drawing space_picture(const SpaceReport &report,
                      const std::vector<unsigned int> &faces,
                      const std::vector<ColourScale> &scales)
{
  const CellFaces &cells = *report.cells;
  IsometricView view;
  const BoundingBox<3> box = box_of(cells);
  view.centre = box.center();
  view.unit =
      std::max({box.side_length(0), box.side_length(1), box.side_length(2)});
  std::vector<Point<2>> places;
  std::vector<unsigned int> drawn;
  for (const unsigned int f : faces)
  {
    const unsigned int cell = cells.cell_of_face(f);
    if (drawn.empty() || drawn.back() != cell)
      drawn.push_back(cell);
    for (const Point<2> &p : places_of(cells, f, view))
      places.push_back(p);
  }
  Drawing drawing{BoundingBox<2>(places)};
  for (const unsigned int cell : drawing_order(cells, drawn, view))
  {
    drawing.open(text("data-cell=\"", cell, "\" class=\"",
                      cell_classes(report, cell, scales), '"'));
    for (const DrawnFace &face : faces_of(cells, cell, faces, view))
      drawing.polygon(places_of(cells, face.face, view),
                      light_class(face.normal, view));
    drawing.close();
  }
  return drawing;
}

std::string light_rules()
{
  std::string css = "#drawing .cell>*{fill:var(--colour,var(--stone))}\n"
                    "@supports (color:color-mix(in srgb,red 50%,black)){\n";
  for (unsigned int k = 0; k < n_lights; ++k)
    css += text("#drawing .l", k,
                "{fill:color-mix(in srgb,var(--colour,var(--stone)) ",
                100. * (least_brightness +
                        (1. - least_brightness) * k / (n_lights - 1)),
                "%,black)}\n");
  return css + "}\n";
}
} // namespace Voussoir
