// SPDX-License-Identifier: LGPL-2.1-or-later

// Blocks that were spoilt on purpose are mended: what was planted is counted,
// the volume and the number of faces are those of the block, wherever it is and
// in whatever unit. Faces are joined without holes, and surfaces are cut where
// blocks touch.

#include <voussoir/base/text.h>

#include "models.h"
#include <numeric>
#include <random>

namespace test_model_cleaning
{
using namespace Voussoir;
using dealii::Point;
using Kind = ModelDefect::Kind;

/** The shape times a factor, turned about an axis and moved. */
Shape placed(Shape shape, const double factor, const Point<3> &origin)
{
  const double c = std::cos(0.3), s = std::sin(0.3);
  for (Point<3> &p : shape.vertices)
  {
    const double x = c * p[0] - s * p[1], y = s * p[0] + c * p[1];
    p = Point<3>(factor * x + origin[0],
                 factor * (0.8 * y - 0.6 * p[2]) + origin[1],
                 factor * (0.6 * y + 0.8 * p[2]) + origin[2]);
  }
  return shape;
}

/**
 * Triangles, each with vertices of its own that are off by a rounding, in any
 * order and orientation, some of them twice.
 */
Shape spoilt(const Shape &shape, const double rounding, const unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  Shape result = unwelded(triangulated(shape));
  for (unsigned int f = 0; f < 3; ++f)
    result.faces.push_back(result.faces[f]);
  std::shuffle(result.faces.begin(), result.faces.end(), random);
  for (std::vector<unsigned int> &face : result.faces)
    if (random() % 2 == 0)
      std::reverse(face.begin(), face.end());
  for (Point<3> &p : result.vertices)
    for (unsigned int d = 0; d < 3; ++d)
      p[d] += rounding * uniform(random);
  return result;
}

void check_spoilt(const std::string &name,
                  const double factor,
                  const Point<3> &origin,
                  const double relative_rounding)
{
  const Shape shape = placed(cube(), factor, origin);
  const Shape bad = spoilt(shape, relative_rounding * factor, 7);
  const ModelCells model = cells_of(bad);
  const CellFaces &cells = model.cells;
  std::cout << name << std::endl;
  check("  one closed cell of six squares",
        cells.n_cells() == 1 && cells.n_faces() == 6 &&
            cells.vertices.size() == 8 && are_sound(cells));
  check("  triangles listed twice", count_of(model, Kind::repeated_face) == 3);
  check("  welded vertices", count_of(model, Kind::welded_vertex) == 28);
  check("  joined triangles", count_of(model, Kind::joined_face) == 6);
  check("  turned faces", count_of(model, Kind::turned_face) > 0);
  const double rounding =
      10. * relative_rounding +
      1e-14 * (1. + origin.norm() / factor); // of the coordinates
  check_error("  volume over that of the rounding",
              std::abs(volume_of(cells) / std::pow(factor, 3.) - 1.) / rounding,
              1.);
  bool kept = true;
  for (const Point<3> &p : cells.vertices)
    kept &= std::find(bad.vertices.begin(), bad.vertices.end(), p) !=
            bad.vertices.end();
  check("  vertices are where they were", kept);
}

/** The numbers of vertices of the faces, ascending. */
std::vector<unsigned int> sizes_of_faces(const CellFaces &cells)
{
  std::vector<unsigned int> sizes;
  for (unsigned int f = 0; f < cells.n_faces(); ++f)
    sizes.push_back(cells.n_corners(f));
  std::sort(sizes.begin(), sizes.end());
  return sizes;
}

void test_joining()
{
  // From the corner in the notch, from which triangles reach everywhere.
  const Shape notched =
      prism({{2., 1.}, {0., 1.}, {0., 0.}, {3., 0.}, {3., 2.}, {2., 2.}}, 1.);
  for (const Shape &shape : {notched, spoilt(notched, 0., 3)})
  {
    const CellFaces cells = cells_of(shape).cells;
    check("notched block: two hexagons and six rectangles",
          sizes_of_faces(cells) ==
              std::vector<unsigned int>({4, 4, 4, 4, 4, 4, 6, 6}));
    check_error("notched block: volume", std::abs(volume_of(cells) - 4.),
                1e-14);
  }
  std::vector<Point<2>> circle;
  for (unsigned int k = 0; k < 64; ++k)
    circle.emplace_back(std::cos(k * dealii::numbers::PI / 32),
                        std::sin(k * dealii::numbers::PI / 32));
  const CellFaces drum = cells_of(triangulated(prism(circle, 1.))).cells;
  std::vector<unsigned int> sizes(64, 4);
  sizes.insert(sizes.end(), {64, 64});
  check("drum: all its sides stay", sizes_of_faces(drum) == sizes);
  check_error(
      "drum: volume",
      std::abs(volume_of(drum) - 32. * std::sin(dealii::numbers::PI / 32)),
      1e-13);
}

/** A block of 3 x 3 x 1 with a hole of 1 x 1 through it, in squares. */
Shape block_with_hole()
{
  Shape shape;
  for (unsigned int z = 0; z < 2; ++z)
    for (unsigned int y = 0; y < 4; ++y)
      for (unsigned int x = 0; x < 4; ++x)
        shape.vertices.emplace_back(x, y, z);
  const auto at = [](unsigned int x, unsigned int y, unsigned int z) {
    return x + 4 * y + 16 * z;
  };
  for (unsigned int y = 0; y < 3; ++y)
    for (unsigned int x = 0; x < 3; ++x)
      if (x != 1 || y != 1)
      {
        shape.faces.push_back({at(x, y, 1), at(x + 1, y, 1),
                               at(x + 1, y + 1, 1), at(x, y + 1, 1)});
        shape.faces.push_back({at(x, y, 0), at(x, y + 1, 0),
                               at(x + 1, y + 1, 0), at(x + 1, y, 0)});
      }
  const auto wall = [&](unsigned int x, unsigned int y, unsigned int x2,
                        unsigned int y2) {
    shape.faces.push_back(
        {at(x, y, 0), at(x2, y2, 0), at(x2, y2, 1), at(x, y, 1)});
  };
  for (unsigned int k = 0; k < 3; ++k)
  {
    wall(k, 0, k + 1, 0);
    wall(3, k, 3, k + 1);
    wall(k + 1, 3, k, 3);
    wall(0, k + 1, 0, k);
  }
  wall(1, 1, 1, 2);
  wall(1, 2, 2, 2);
  wall(2, 2, 2, 1);
  wall(2, 1, 1, 1);
  return shape;
}

void test_holes()
{
  const ModelCells model = cells_of(block_with_hole());
  const CellFaces &cells = model.cells;
  check("block with a hole: closed, and no face touches itself",
        are_sound(cells));
  check_error("block with a hole: volume", std::abs(volume_of(cells) - 8.),
              1e-13);
  // Four sides outside and four within, and two faces of two pieces at least.
  check("block with a hole: faces around it are cut",
        cells.n_faces() >= 12 && cells.n_faces() <= 14);
  double area = 0.;
  for (unsigned int f = 0; f < cells.n_faces(); ++f)
  {
    const auto polygon = cells.polygon(f);
    area += moments_of({polygon.data(), polygon.size()}).area();
  }
  check_error("block with a hole: area", std::abs(area - 16. - 12. - 4.),
              1e-13);
}

void test_straight_vertices()
{
  // A vertex in the middle of an edge, in both faces that have it.
  Shape shape = cube();
  shape.vertices.emplace_back(0.5, 0., 0.);
  shape.faces[0] = {0, 2, 3, 1, 8};
  shape.faces[2] = {0, 8, 1, 5, 4};
  const ModelCells model = cells_of(shape);
  check("a vertex within an edge is left out",
        count_of(model, Kind::straight_vertex) == 1 &&
            model.cells.vertices.size() == 8 && are_sound(model.cells));
  shape.vertices[8][1] = -0.01;
  check("one beside it is not", cells_of(shape).cells.vertices.size() == 9);
  Shape repeated = cube();
  repeated.faces[0] = {0, 0, 2, 3, 1, 3, 1};
  repeated.faces.push_back({4, 5, 4});
  const ModelCells mended = cells_of(repeated);
  check("repeated vertices, spikes and faces of two are left out",
        count_of(mended, Kind::repeated_vertex) == 1 &&
            count_of(mended, Kind::degenerate_face) == 1 &&
            mended.cells.n_faces() == 6 && are_sound(mended.cells));
}

/** Vertices further apart than single precision, but within the tolerance. */
void test_coarse_welding()
{
  const Shape bad = spoilt(cube(), 2e-4, 5);
  check("an open block is welded within the tolerance",
        cells_of(bad).cells.vertices.size() == 8);
  // Where nothing is open short edges stay.
  const CellFaces cells =
      cells_of(
          prism({{0., 0.}, {1., 0.}, {1., 1.}, {0.005, 1.}, {0., 0.995}}, 1.))
          .cells;
  check("a closed one keeps its short edges", cells.vertices.size() == 10);
}

void test_parts_and_groups()
{
  // Two stones of one name, which touch, one of them with fewer vertices.
  Shape both = unwelded(triangulated(cube()));
  const Shape other = unwelded(triangulated(cube(1.)));
  for (std::vector<unsigned int> face : other.faces)
  {
    for (unsigned int &vertex : face)
      vertex += both.vertices.size();
    both.faces.push_back(face);
  }
  both.vertices.insert(both.vertices.end(), other.vertices.begin(),
                       other.vertices.end());
  BlockMesh pier = block_of(both, "pier");
  pier.is_support = true;
  const ModelCells model = cells_of_model(
      meshes_of({block_of(cube(5.), "a;b"), pier, block_of(cube(7.), "arch"),
                 block_of(cube(9.))}),
      {});
  const CellFaces &cells = model.cells;
  check("parts of a block are cells", cells.n_cells() == 5);
  check("what is fixed is at the end",
        cells.n_fixed == 2 &&
            cells.records == std::vector<unsigned int>({0, 2, 3, 1, 1}));
  check("groups have the names in the file",
        cells.group_names ==
                std::vector<std::string>({"block", "arch", "pier"}) &&
            cells.group == std::vector<unsigned int>({0, 1, 0, 2, 2}));
  for (const std::string &notice : cells.notices)
    std::cout << "  " << notice << std::endl;
}

/** Faces off their plane are told of, the worst with its place. */
void test_bent_faces()
{
  Shape shape = cube();
  shape.vertices[7][2] = 1.04; // z of a corner of the upper face
  const ModelCells model = cells_of(shape);
  check("one bent face", count_of(model, Kind::bent_face) == 1);
  for (const ModelDefect &defect : model.defects)
    check("  it is the upper one", defect.face == 1);
  // The plane across the diagonals' vector product is 0.01 from each corner.
  check_error("  its deviation", std::abs(model.defects[0].size - 0.01) / 0.01,
              1e-3);
}

void run()
{
  check_spoilt("a cube", 1., {}, 1e-8);
  check_spoilt("in millimetres", 1e3, {1e3, -5e3, 2e3}, 1e-8);
  check_spoilt("in kilometres", 1e-3, {}, 1e-8);
  check_spoilt("far away", 1., {1e6, -1e6, 1e5}, 1e-8);
  check_spoilt("in single precision", 1., {}, 1e-7);
  check_spoilt("with three decimals", 1., {}, 3e-4);
  test_joining();
  test_holes();
  test_straight_vertices();
  test_coarse_welding();
  test_parts_and_groups();
  test_bent_faces();
}

const RoomTest test("model_cleaning", run);
} // namespace test_model_cleaning
