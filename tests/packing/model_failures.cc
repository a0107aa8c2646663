// SPDX-License-Identifier: LGPL-2.1-or-later

// Every kind of broken block is refused with its cell, its record, its place
// and what to do; one run names all of them. Every kind of file that is none is
// refused with its line.

#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/models/model.h>

#include "models.h"
#include "own_directory.h"
#include <limits>

namespace test_model_failures
{
using namespace Voussoir;
using dealii::Point;

/** A cube at x = 10 k, to be spoilt. */
Shape cube_number(const unsigned int k)
{
  return cube(10. * k);
}

Shape without_face(Shape shape, const unsigned int face)
{
  shape.faces.erase(shape.faces.begin() + face);
  return shape;
}

Shape with_face(Shape shape, const std::vector<unsigned int> &face)
{
  shape.faces.push_back(face);
  return shape;
}

Shape with_vertex(Shape shape, const unsigned int vertex, const Point<3> &p)
{
  shape.vertices[vertex] = p;
  return shape;
}

/** Eight triangles around two vertices, turned to a strip with one side. */
Shape one_sided()
{
  // The projective plane of six vertices: each edge has two faces.
  Shape shape;
  for (unsigned int v = 0; v < 6; ++v)
    shape.vertices.emplace_back(90. + std::cos(v), std::sin(v), 0.1 * v * v);
  shape.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                 {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
  return shape;
}

/** A box whose top is pushed through its bottom. */
Shape crossing_box()
{
  Shape shape = prism({{0., 0.}, {4., 0.}, {4., 4.}, {0., 4.}}, 1.);
  // A pyramid into the top, to below the bottom.
  shape.vertices.emplace_back(2., 2., -1.);
  shape.faces.erase(shape.faces.begin() + 1);
  for (unsigned int i = 0; i < 4; ++i)
    shape.faces.push_back({4 + i, 4 + (i + 1) % 4, 8});
  for (Point<3> &p : shape.vertices)
    p[0] += 100.;
  return shape;
}

void test_all_at_once()
{
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Shape bow_tie = [] {
    Shape shape = cube_number(9);
    for (std::vector<unsigned int> &face : shape.faces)
      for (unsigned int &v : face)
        v = v == 5 ? 7 : v == 7 ? 5 : v;
    return shape;
  }();
  std::string lines = obj_of("sound", cube());
  lines += obj_of("open", without_face(cube_number(1), 2));
  lines += obj_of("membrane", with_face(cube_number(2), {0, 3, 7, 4}));
  lines += obj_of("not_a_number", with_vertex(cube_number(3), 6, {30, nan, 1}));
  lines += obj_of("infinite", with_vertex(cube_number(4), 0, {inf, -inf, 0}));
  lines += obj_of("too_large", with_vertex(cube_number(5), 0, {1e60, 0., 0.}));
  lines += obj_of("flat", prism({{60., 0.}, {61., 0.}, {61., 1.}}, 0.));
  lines +=
      obj_of("pillow", {cube_number(7).vertices, {{0, 1, 3, 2}, {0, 2, 3, 1}}});
  lines += obj_of("lines", {cube_number(8).vertices, {{0, 1}, {1, 1, 2}}});
  lines += obj_of("twisted", bow_tie);
  lines += obj_of("one_sided", one_sided());
  lines += obj_of("crossing", crossing_box());
  lines += obj_of("warped",
                  with_vertex(with_vertex(cube_number(12), 7, {121., 1., 1.8}),
                              4, {120., 0., 1.8}));
  lines += obj_of("plate", prism({{130., 0.}, {131., 0.}, {131., 1.}}, 0.01));
  lines += obj_of("sound", cube_number(14));
  lines += obj_of("again", cube_number(14));
  lines += obj_of("far_flat", prism({{150., 0.}, {151., 0.}, {152., 0.}}, 1.));
  Shape keyhole = cube_number(16);
  keyhole.vertices.emplace_back(160.25, 0.25, 0.);
  keyhole.vertices.emplace_back(160.5, 0.25, 0.);
  keyhole.vertices.emplace_back(160.25, 0.5, 0.);
  keyhole.faces[0] = {0, 8, 10, 9, 8, 0, 2, 3, 1};
  keyhole.faces.push_back({8, 9, 10});
  lines += obj_of("keyhole", keyhole);
  for (unsigned int k = 17; k < 26; ++k)
    lines += obj_of("open", without_face(cube_number(k), k % 6));
  write_file("broken.obj", lines);
  show_refusal([] { cells_of_model(read_model("broken.obj"), {}); });
}

void refuse(const std::string &file, const std::string &content)
{
  write_file(file, content);
  show_refusal([&] { cells_of_model(read_model(file), {}); });
}

void test_off()
{
  refuse("a.off", "");
  refuse("a.off", "OFF\n0 0 0\n");
  refuse("a.off", "PLY\n8 6 12\n");
  refuse("a.off", "4OFF\n8 6 12\n");
  refuse("a.off", "OFF BINARY\n8 6 12\n");
  refuse("a.off", "OFF\n8\n");
  refuse("a.off", "OFF\n8 -6 12\n");
  refuse("a.off", "OFF\n99999999999 1 0\n0 0 0\n");
  refuse("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n");
  refuse("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 x\n3 0 1 2\n");
  refuse("a.off", "OFF\n3 1 0\n0 0 0\n1,5 0 0\n0 1 0\n3 0 1 2\n");
  refuse("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n");
  refuse("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n");
}

void test_obj()
{
  refuse("a.obj", "");
  refuse("a.obj", "# nothing\nv 0 0 0\n");
  refuse("a.obj", "v 0 0\nf 1 1 1\n");
  refuse("a.obj", "v 0 0 0\nf 1 2 3\n");
  refuse("a.obj", "v 0 0 0\nf 1 0 1\n");
  refuse("a.obj", "v 0 0 0\nf 1 -2 1\n");
  refuse("a.obj", "v 0 0 0\nf 1 a 1\n");
  refuse("a.obj", "v 0 0 0\nf 1 99999999999999999999 1\n");
  // One run names all lines, each with its block; vertex 9 is of no face.
  std::string lines = obj_of("zero", cube(0.)) + "f 1 0 3\n" +
                      obj_of("beyond", cube(10.)) + "f 1 2 99\n" +
                      obj_of("letter", cube(20.)) + "f 1 b 3\n" +
                      obj_of("sound", cube(30.)) + "v 1 2\n" +
                      obj_of("comma", cube(40.)) + "v 1,5 2 3\nf -1 -2 -3\n";
  refuse("lines.obj", lines);
  refuse("a.obj", std::string("o\0\0\0\0\0", 6));
}

void test_crossing_in_a_plane()
{
  // Triangles of one plane whose sides are nearly parallel where they cross.
  Shape shape;
  shape.vertices = {{0., 0.5, 0.5}, {0., -0.5, 0.5}, {0., 0., 0.},
                    {2., 0.5, 0.5}, {2., -0.5, 0.5}, {-0.5, 1., 0.5}};
  shape.faces = {
      {2, 1, 0}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
  refuse("a.obj", obj_of("flat", shape));
}

void test_slender_face()
{
  // It is within the tolerance of a plane, but has no triangles in it.
  Shape shape;
  shape.vertices = {{100., 0.5, 0.5}, {2., 0., 0.},       {0., 0., 0.},
                    {2., -0.5, 0.5},  {-0.5, -0.5, -0.5}, {-0.5, 2., 1.}};
  shape.faces = {{3, 4, 5}, {0, 1, 4, 3}, {1, 2, 4}, {2, 0, 3, 5}};
  refuse("a.obj", obj_of("slender", shape));
  // One edge of a prism is drawn out beyond the next face, by little for a
  // model of that size.
  shape.vertices = {{0., 0., 0.},      {0., 0.5, 0.5}, {0., -0.5, 0.5},
                    {2.00003, 0., 0.}, {2., 0.5, 0.5}, {2.00002, 0., 0.},
                    {1e5, 0., 0.},     {1e5, 1e4, 0.}, {1e5, 0., 1e4},
                    {1.1e5, 0., 0.}};
  shape.faces = {{2, 1, 0}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5},
                 {6, 8, 7}, {6, 7, 9}, {6, 9, 8},    {7, 8, 9}};
  refuse("a.obj", obj_of("drawn out", shape));
}

void test_ply()
{
  const std::string head = "ply\nformat ascii 1.0\nelement vertex 3\n"
                           "property float x\nproperty float y\n"
                           "property float z\nelement face 1\n"
                           "property list uchar int vertex_indices\n";
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  refuse("a.ply", "");
  refuse("a.ply", "ply\nformat ascii 1.0\n");
  refuse("a.ply", "ply\nformat ebcdic 1.0\nend_header\n");
  refuse("a.ply", "ply\nformat ascii 1.0\nproperty float x\nend_header\n");
  refuse("a.ply", "ply\nformat ascii 1.0\nelement face many\nend_header\n");
  refuse("a.ply", "ply\nformat ascii 1.0\nelement face 1\nproperty half x\n"
                  "end_header\n");
  refuse("a.ply", "ply\nformat ascii 1.0\nend_header\n");
  refuse("a.ply", head + "end_header\n" + vertices);
  refuse("a.ply", head + "end_header\n0 0 0\n1 b 0\n0 1 0\n3 0 1 2\n");
  refuse("a.ply", head + "end_header\n" + vertices + "3 0 1 3\n");
  refuse("a.ply", head + "end_header\n" + vertices + "3 0 1 -1\n");
  refuse("a.ply", head + "end_header\n" + vertices + "-3 0 1 2\n");
  refuse("a.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 2\n"
                  "property double x\nend_header\nabcdefgh");
  // A signalling NaN.
  std::string bytes("ply\nformat binary_little_endian 1.0\nelement vertex 3\n"
                    "property double x\nproperty double y\n"
                    "property double z\nelement face 1\n"
                    "property list uchar int vertex_indices\nend_header\n");
  bytes += std::string("\1\0\0\0\0\0\xf0\x7f", 8) + std::string(64, '\0');
  bytes += std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
  refuse("a.ply", bytes);
  for (const std::string faces : {"1\n", "4\n"})
    refuse("a.ply", "ply\nformat ascii 1.0\nelement face " + faces +
                        "property list uchar int vertex_indices\n"
                        "end_header\n0 0 0 0\n");
  std::string many = "ply\nformat ascii 1.0\n"; // to be counted, each, else
  for (unsigned int k = 0; k < 200000; ++k)
    many += "element a 3000000\n";
  refuse("a.ply", many + "end_header\n");
}

void test_stl()
{
  refuse("a.stl", "");
  refuse("a.stl", "OFF\n");
  refuse("a.stl", "solid a\nendsolid a\n");
  refuse("a.stl", "solid a\nfacet normal 0 0 1\n");
  refuse("a.stl", "solid a\nfacet normal 0 0 1\nvertex 0 0 0\nendfacet\n");
  refuse("a.stl", "solid a\nvertex 0 0 0\nvertex 0 0 0\nvertex 0 0 0\n"
                  "vertex 0 0 0\n");
  refuse("a.stl", "solid a\nvertex 0 zero 0\n");
  refuse("a.stl", "solid a\nnothing\n");
  refuse("a.stl", std::string(80, 's') + std::string("\1\0\0\0short", 9));
  refuse("a.stl", std::string(80, 's') + std::string(4, '\0'));
}

void test_compas()
{
  const std::string vertices = "\"vertex\": {\"0\": {\"x\": 0, \"y\": 0, "
                               "\"z\": 0}, \"1\": {\"x\": 1, \"y\": 0}}";
  refuse("a.json", "");
  refuse("a.json", "{\n \"data\": {\"x\": NaN}}");
  refuse("a.json", "[1, 2, 1e999]");
  refuse("a.json", "{}");
  refuse("a.json", "[[], {}, 3, null]");
  refuse("a.json", std::string(40, '[') + std::string(40, ']'));
  refuse("a.json", "{\"vertex\": [[" + std::string(100000, '[') +
                       std::string(100000, ']') +
                       ", 0, 0]], \"face\": [[0, 0, 0]]}");
  refuse("a.json", "{\"data\": {\"params\": {}}}");
  refuse("a.json", "{" + vertices + ", \"face\": {}}");
  refuse("a.json",
         "{\"dva\": {\"z\": \"high\"}, " + vertices + ", \"face\": {}}");
  refuse("a.json", "{\"dva\": {\"z\": 0}, " + vertices +
                       ", \"face\": {\"4\": [0, 1, 2]}}");
  refuse("a.json",
         "{\"dva\": {\"z\": 0}, " + vertices + ", \"face\": {\"4\": 7}}");
  refuse("a.json", "{\"dva\": {\"z\": 0}, " + vertices +
                       ", \"face\": {\"4\": {\"0\": \"1\", \"1\": \"1\"}}}");
  refuse("a.json", "{\"graph\": {\"node\": {\"a\": {\"x\": 0}}}}");
  refuse("a.json", "{\"graph\": {\"edge\": {}}}");
  refuse("a.json", "{\"elements\": {\"e\": {\"data\": {\"geometry\": "
                   "{\"dtype\": \"compas.geometry/Brep\", \"data\": {}}}}}}");
  refuse("a.json",
         "{\"elements\": {\"e\": {\"data\": {\"transformation\": {\"data\": "
         "{\"matrix\": [[1, 0], [0, 1]]}}, \"geometry\": {\"dva\": {\"z\": "
         "null}, " +
             vertices + ", \"face\": {}}}}}}");
  refuse("a.json", "{\"elements\": {}, \"transformation\": {\"matrix\": 3}}");
}

void test_tess()
{
  const std::string head =
      "***tess\n **format\n 3.4\n **general\n 3 standard\n";
  const std::string one = " **vertex\n 1\n 1 0 0 0 0\n";
  refuse("a.tess", "");
  refuse("a.tess", "***tesr\n");
  refuse("a.tess", "***tess\n **general\n 2 standard\n");
  refuse("a.tess", "***tess\n **general\n 3 periodic\n");
  refuse("a.tess", head + "**periodicity\n");
  refuse("a.tess", head + one + "***end\n");
  refuse("a.tess", head + " **vertex\n 2\n 1 0 0 0 0\n");
  refuse("a.tess", head + one + " **face\n 1\n 1 3 1 2 3\n");
  refuse("a.tess", head + one + " **face\n 1\n 1 3 1 1\n");
  refuse("a.tess", head + one + " **face\n 1\n 1 1 1\n 1 1\n 0 0 0 1\n");
  refuse("a.tess", head + one + " **polyhedron\n 1\n 1 2 1 -2\n");
  refuse("a.tess", head + one +
                       " **face\n 1\n 1 1 1\n 1 1\n 0 0 0 1\n 0\n"
                       " **polyhedron\n 1\n 1 3 1 1 -1\n");
}

/** A side that is too short for its length to be a number. */
void test_short_sides()
{
  auto block = cube();
  block.vertices.emplace_back(1e-300, 0., 0.);
  auto &face = block.faces.front();
  face.insert(std::find(face.begin(), face.end(), 0u) + 1, 8u);
  write_file("a.obj", obj_of("a", block));
  const ModelCells model = cells_of_model(read_model("a.obj"), {});
  std::cout << "A short side is "
            << (model.cells.n_cells() == 1 ? "closed" : "FAILED") << std::endl;
}

void test_generator()
{
  const auto refuse_setting = [](const std::string &entry,
                                 const std::string &value) {
    ModelGenerator generator;
    dealii::ParameterHandler prm;
    generator.add_parameters(prm);
    prm.set("File", "cube.obj");
    prm.set(entry, value);
    show_refusal([&] { generator.generate("", Terminal::silent()); });
  };
  write_file("cube.obj", obj_of("a", cube(1e6)));
  refuse_setting("File", "");
  refuse_setting("File", "none.obj");
  refuse_setting("File", "cube.dwg");
  refuse_setting("File", "cube");
  refuse_setting("Scale", "0");
  refuse_setting("Scale", "-1");
  refuse_setting("Scale", "1e-300");
  refuse_setting("Scale", "1e100");
  refuse_setting("Tolerance", "1e-12");
  refuse_setting("Tolerance", "0.5");
  std::filesystem::create_directory("folder.stl");
  refuse_setting("File", "folder.stl");
  std::filesystem::create_directory("folder.obj");
  refuse_setting("File", "folder.obj");
}

void run()
{
  work_in_own_directory();
  test_all_at_once();
  test_off();
  test_obj();
  test_crossing_in_a_plane();
  test_slender_face();
  test_ply();
  test_stl();
  test_compas();
  test_tess();
  test_short_sides();
  test_generator();
}

const RoomTest test("model_failures", run);
} // namespace test_model_failures
