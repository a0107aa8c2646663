// SPDX-License-Identifier: LGPL-2.1-or-later

// One file with more than thirty kinds of faults, those of its notation and
// those of shapes: one run names each of them, writes nothing, and ends with
// status 2. Of many faults of a kind the first five are named. What can be
// mended is no fault.

#include "models.h"
#include "own_directory.h"
#include "run_program.h"
#include <cmath>
#include <filesystem>

namespace test_model_thirty_faults
{
using dealii::Point;

/** A shape as a mesh of COMPAS; keys of vertices are their numbers. */
std::string mesh_of(const Shape &shape,
                    const std::string &name,
                    const std::string &more = "")
{
  std::string json = "{\"attributes\": {\"name\": \"" + name + "\"}, " + more +
                     "\"vertex\": {";
  for (std::size_t v = 0; v < shape.vertices.size(); ++v)
  {
    const Point<3> &p = shape.vertices[v];
    json += (v > 0 ? ", \"" : "\"") + std::to_string(v) +
            "\": {\"x\": " + digits(p[0]) + ", \"y\": " + digits(p[1]) +
            ", \"z\": " + digits(p[2]) + "}";
  }
  json += "}, \"face\": {";
  for (std::size_t f = 0; f < shape.faces.size(); ++f)
  {
    json += (f > 0 ? ", \"" : "\"") + std::to_string(f) + "\": [";
    for (std::size_t i = 0; i < shape.faces[f].size(); ++i)
      json += (i > 0 ? ", " : "") + std::to_string(shape.faces[f][i]);
    json += "]";
  }
  return json + "}}";
}

/** A text with one word for another, the first time that it is there. */
std::string
changed(std::string text, const std::string &from, const std::string &to)
{
  return text.replace(text.find(from), from.size(), to);
}

/** A cube at x = 10 k. */
Shape cube_at(const unsigned int k)
{
  return cube(10. * k);
}

Shape moved(Shape shape, const double x)
{
  for (Point<3> &p : shape.vertices)
    p[0] += x;
  return shape;
}

/** The projective plane of six vertices: each edge has two faces. */
Shape one_sided()
{
  Shape shape;
  for (unsigned int v = 0; v < 6; ++v)
    shape.vertices.emplace_back(std::cos(v), std::sin(v), 0.1 * v * v);
  shape.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                 {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
  return shape;
}

/** A box with a pyramid pushed into its top, through its bottom. */
Shape crossing_box()
{
  Shape shape = prism({{0., 0.}, {4., 0.}, {4., 4.}, {0., 4.}}, 1.);
  shape.vertices.emplace_back(2., 2., -1.);
  shape.faces.erase(shape.faces.begin() + 1);
  for (unsigned int i = 0; i < 4; ++i)
    shape.faces.push_back({4 + i, 4 + (i + 1) % 4, 8});
  return shape;
}

/** A cube with a hole drawn into its bottom, joined to the outline. */
Shape keyhole()
{
  Shape shape = cube();
  shape.vertices.emplace_back(0.25, 0.25, 0.);
  shape.vertices.emplace_back(0.5, 0.25, 0.);
  shape.vertices.emplace_back(0.25, 0.5, 0.);
  shape.faces[0] = {0, 8, 10, 9, 8, 0, 2, 3, 1};
  shape.faces.push_back({8, 9, 10});
  return shape;
}

/** A cube whose two tops are swapped: they have no area, its sides cross. */
Shape twisted()
{
  Shape shape = cube();
  for (std::vector<unsigned int> &face : shape.faces)
    for (unsigned int &v : face)
      v = v == 5 ? 7 : v == 7 ? 5 : v;
  return shape;
}

/** A prism over a pentagon that crosses itself, but has an area. */
Shape star()
{
  return prism({{0, 0}, {2, 0}, {2, 2}, {1, -1}, {0, 2}}, 1.);
}

/** A cube with its top further up than its sides reach. */
Shape with_gap()
{
  Shape shape = cube();
  for (unsigned int v = 4; v < 8; ++v)
  {
    shape.vertices.push_back(shape.vertices[v] + Point<3>(0., 0., 0.1));
    for (unsigned int &corner : shape.faces[1])
      corner = corner == v ? v + 4 : corner;
  }
  return shape;
}

/** A cube, with one top higher by much. */
Shape warped()
{
  Shape shape = cube();
  shape.vertices[7][2] = shape.vertices[4][2] = 1.8;
  return shape;
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

/** Meshes whose shapes are wrong, or their numbers. */
std::string meshes()
{
  Shape far = cube(90.);
  far.vertices[0][0] = 1e60;
  const std::string sound = mesh_of(cube(-10.), "sound");
  std::vector<std::string> list = {
      sound, mesh_of(without_face(cube_at(1), 2), "open"),
      mesh_of(moved(with_gap(), 20.), "gap"),
      mesh_of(with_face(cube_at(3), {0, 3, 7, 4}), "membrane"),
      mesh_of({cube_at(4).vertices, {{0, 2, 3, 1}, {0, 1, 5}}}, "two faces"),
      mesh_of(prism({{50., 0.}, {51., 0.}, {51., 1.}}, 0.), "flat"),
      mesh_of({cube_at(6).vertices, {{0, 1}, {1, 1, 2}, {2, 3}, {3}}}, "lines"),
      mesh_of(moved(twisted(), 70.), "twisted"),
      mesh_of(moved(star(), 80.), "star"), mesh_of(far, "far"),
      mesh_of(moved(one_sided(), 100.), "one-sided"),
      mesh_of(moved(crossing_box(), 110.), "crossing"),
      mesh_of(moved(warped(), 120.), "warped"),
      mesh_of(prism({{130., 0.}, {131., 0.}, {131., 1.}}, 0.01), "plate"),
      mesh_of(cube(-10.), "again"),
      mesh_of(box({-9.7, 0.3, 0.3}, {-9.3, 0.7, 0.7}), "hollow"),
      mesh_of(moved(keyhole(), 140.), "keyhole"),
      changed(mesh_of(cube_at(15), "null"), "\"x\": 151", "\"x\": null"),
      changed(mesh_of(cube_at(16), "words"), "\"x\": 161", "\"x\": \"far\""),
      changed(mesh_of(cube_at(17), "lacking"), "\"x\": 171, ", ""),
      changed(mesh_of(cube_at(18), "unknown"), "[0, 2, 3, 1]", "[0, 2, 9, 1]"),
      changed(mesh_of(cube_at(19), "no list"), "[0, 2, 3, 1]", "7"),
      changed(mesh_of(cube_at(20), "half"), "[0, 2, 3, 1]",
              "{\"0\": \"2\", \"2\": \"0\", \"3\": \"1\", \"1\": \"3\"}"),
      changed(mesh_of(cube_at(21), "flag"), "\"name\"",
              "\"is_support\": \"perhaps\", \"name\""),
      changed(mesh_of(cube_at(22), "twice"), "\"0\": {\"x\"",
              "\"0\": {}, \"0\": {\"x\""),
      // Several faults that do not depend on each other.
      changed(changed(mesh_of(cube_at(23), "many"), "[0, 2, 3, 1]", "[9]"),
              "\"x\": 231", "\"x\": \"far\""),
      mesh_of(without_face(with_face(moved(warped(), 240.), {0, 3, 7, 4}), 2),
              "many shapes"),
      "3", "{\"dtype\": \"compas.geometry/Frame\", \"data\": {}}"};
  for (unsigned int k = 25; k < 33; ++k)
    list.push_back(mesh_of(without_face(cube_at(k), k % 6), "open"));
  // Mended: a vertex within an edge of one face alone.
  Shape hanging = cube_at(34);
  hanging.vertices.emplace_back(340.5, 0., 0.);
  hanging.faces[0] = {0, 2, 3, 1, 8};
  list.push_back(mesh_of(hanging, "hanging"));
  std::string json;
  for (const std::string &mesh : list)
    json += (json.empty() ? "" : ",\n") + mesh;
  return json;
}

std::string element(const std::string &key,
                    const std::string &geometry,
                    const std::string &rows)
{
  return "\"" + key + "\": {\"data\": {" +
         (rows.empty() ? ""
                       : "\"transformation\": {\"matrix\": " + rows + "}, ") +
         "\"geometry\": " + geometry + "}}";
}

/** A model of elements in groups. */
std::string elements()
{
  const auto shape = [](const unsigned int k) {
    return mesh_of(cube_at(k), "element");
  };
  return "{\"elements\": {" + element("a1", shape(50), "[[1, 0], [0, 1]]") +
         ",\n" +
         element("a2", shape(51),
                 "[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0.5,1]]") +
         ",\n" +
         element("a3", shape(52), "[[1,0,0,0],[0,1,0,0],[0,1,0,0],[0,0,0,1]]") +
         ",\n" +
         element("a4", "{\"dtype\": \"compas.geometry/Brep\", \"data\": {}}",
                 "") +
         ",\n" + element("a5", "null", "") + ",\n" +
         element("a6", shape(53), "") +
         "},\n\"tree\": {\"root\": {\"children\": [{\"element\": \"a6\"}, "
         "{\"element\": \"a7\"}, {\"element\": \"a6\"}]}}}";
}

void show_run()
{
  write_file("scene.prm",
             "set Dimension = 3\nsubsection Packing\n set Generator = model\n"
             " subsection model\n  set File = broken.json\n end\nend\n");
  const Ended ended = run_program({"scene.prm"});
  std::cout << "status " << ended.status
            << (std::filesystem::exists("output") ? " FILES " : " ")
            << ended.error;
}

void run()
{
  work_in_own_directory();
  write_file("broken.json", "[" + meshes() + ",\n" + elements() + "]\n");
  show_run();

  std::cout << "What is mended" << std::endl;
  Shape hanging = cube();
  hanging.vertices.emplace_back(0.5, 0.001, 0.);
  hanging.faces[0] = {0, 2, 3, 1, 8};
  const Voussoir::ModelCells mended = cells_of(hanging);
  check("  a vertex within an edge of one face",
        count_of(mended, Voussoir::ModelDefect::Kind::hanging_vertex) == 1);
  check("  the block is closed", are_sound(mended.cells));
  check_error("  its volume is that of its vertices",
              std::abs(volume_of(mended.cells) - 1.), 1e-3);
}

const RoomTest test("model_thirty_faults", run);
} // namespace test_model_thirty_faults
