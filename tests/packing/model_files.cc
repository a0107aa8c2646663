// SPDX-License-Identifier: LGPL-2.1-or-later

// Files of other programs become cells that are closed, of the volume that the
// triangles of the file enclose, and come back from the files that are written
// of them to the last bit. Two cubes in every form of every format are the same
// two cubes.

#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/models/model.h>

#include <nlohmann/json.hpp>

#include "models.h"
#include "own_directory.h"
#include <cstring>
#include <fstream>

namespace test_model_files
{
using namespace Voussoir;
using dealii::Point;

/** The volume that oriented faces enclose, by tetrahedra to one place. */
double volume_in_file(const BlockMesh &block)
{
  double volume = 0.;
  for (unsigned int f = 0; f < block.faces.size(); ++f)
  {
    const auto loop = block.faces[f];
    const auto edge = [&](const unsigned int i) {
      return block.vertices[loop[i]] - block.vertices[0];
    };
    for (unsigned int i = 1; i + 1 < loop.size(); ++i)
      volume += edge(0) * cross_product_3d(edge(i), edge(i + 1)) / 6.;
  }
  return std::abs(volume);
}

bool are_same(const CellFaces &a, const CellFaces &b)
{
  return a.vertices == b.vertices && a.loops == b.loops &&
         a.first_corner == b.first_corner && a.first_face == b.first_face;
}

void check_round_trips(const CellFaces &cells)
{
  const ModelOptions options;
  std::ofstream json("again.json"), obj("again.obj"), off("again.off");
  write_compas_assembly(json, cells);
  write_obj_model(obj, cells);
  write_off_model(off, cells);
  json.close();
  obj.close();
  off.close();
  const CellFaces from_json =
      cells_of_model(read_model("again.json"), options).cells;
  const CellFaces from_obj =
      cells_of_model(read_model("again.obj"), options).cells;
  const CellFaces from_off =
      cells_of_model(read_model("again.off"), options).cells;
  check("  again from an Assembly",
        are_same(from_json, cells) && from_json.group == cells.group &&
            from_json.group_names == cells.group_names &&
            from_json.n_fixed == cells.n_fixed);
  std::vector<std::string> names, names_again;
  for (unsigned int cell = 0; cell < cells.n_cells() && !cells.group.empty();
       ++cell)
  {
    names.push_back(cells.group_names[cells.group[cell]]);
    names_again.push_back(from_obj.group_names[from_obj.group[cell]]);
  }
  check("  again from OBJ", are_same(from_obj, cells) && names == names_again);
  check("  again from OFF", are_same(from_off, cells));
}

void check_file(const std::string &name, const bool has_copies = false)
{
  const BlockMeshes meshes =
      read_model(std::filesystem::path(SOURCE_DIR) / "models" / name);
  double volume = 0.;
  std::size_t n_faces = 0;
  for (const BlockMesh &block : meshes.blocks)
  {
    volume += volume_in_file(block) / (has_copies ? 2. : 1.);
    n_faces += block.faces.size();
  }
  const ModelCells model = cells_of_model(meshes, {});
  const CellFaces &cells = model.cells;
  std::cout << name << ": " << meshes.blocks.size() << " blocks, " << n_faces
            << " faces; " << cells.n_cells() << " cells, " << cells.n_fixed
            << " fixed, " << cells.n_faces() << " faces" << std::endl;
  for (const std::string &notice : cells.notices)
    std::cout << "  " << notice.substr(0, notice.find(';')) << std::endl;
  check("  closed", are_sound(cells));
  check("  size of the tolerance",
        std::abs(cells.tolerance / (meshes.is_computed ? 1e-9 : 1e-2) /
                     std::cbrt(volume_of(cells) / cells.n_cells()) -
                 1.) < 0.1);
  // Joined faces are flat within a tenth of the tolerance.
  check_error("  volume", std::abs(volume_of(cells) / volume - 1.), 1e-3);
  check_round_trips(cells);
}

/** Two cubes, the first a support, on each other in the direction x. */
void check_cubes(const std::string &name,
                 const std::string &content,
                 const unsigned int n_fixed = 0)
{
  write_file(name, content);
  const CellFaces cells = cells_of_model(read_model(name), {}).cells;
  bool are = cells.n_cells() == 2 && cells.n_faces() == 12 &&
             cells.vertices.size() == 16 && are_sound(cells) &&
             cells.n_fixed == n_fixed;
  std::vector<double> places;
  for (unsigned int cell = 0; cell < cells.n_cells(); ++cell)
  {
    const CellMoments moments = moments_of(cells, cell);
    are &= std::abs(moments.volume - 1.) < 1e-12;
    places.push_back(0.5 * std::round(2. * moments.centroid[0]));
    are &= std::abs(moments.centroid[0] - places.back()) < 1e-12;
  }
  // What is fixed goes to the end.
  are &= places == (n_fixed == 1 ? std::vector<double>{1.5, 0.5}
                                 : std::vector<double>{0.5, 1.5});
  check(name, are);
}

std::string off_object(const Shape &shape)
{
  std::string lines = text("OFF\n# an object\n", shape.vertices.size(), ' ',
                           shape.faces.size(), " 0\n");
  for (const Point<3> &p : shape.vertices)
    lines += text(p[0], ' ', p[1], "\t", p[2], " 0.5 0.5 0.5\n");
  for (const std::vector<unsigned int> &face : shape.faces)
  {
    lines += text(face.size());
    for (const unsigned int vertex : face)
      lines += text(' ', vertex);
    lines += " 255 0 0\n\n";
  }
  return lines;
}

/** Both cubes with one list of vertices. */
Shape both_cubes()
{
  Shape shape = cube();
  const Shape other = cube(1.);
  shape.vertices.insert(shape.vertices.end(), other.vertices.begin(),
                        other.vertices.end());
  for (std::vector<unsigned int> face : other.faces)
  {
    for (unsigned int &vertex : face)
      vertex += 8;
    shape.faces.push_back(face);
  }
  return shape;
}

void test_off_and_obj()
{
  check_cubes("objects.off", off_object(cube()) + off_object(cube(1.)));
  check_cubes("parts.off", off_object(both_cubes()));
  check_cubes("soup.off", off_object(unwelded(triangulated(both_cubes()))));
  check_cubes("objects.obj", obj_of("a", cube()) + obj_of("b", cube(1.)));
  check_cubes("windows.obj", "\xEF\xBB\xBF# first\r\nvt 0 0\r\nvn 0 0 1\r\n" +
                                 obj_of("a", cube()) + obj_of("b", cube(1.)) +
                                 "\r\n");
  std::string grouped = "mtllib none.mtl\n";
  for (const Shape &shape : {cube(), cube(1.)})
    for (const Point<3> &p : shape.vertices)
      grouped += text("v ", p[0], ' ', p[1], ' ', p[2], " 0.1 0.2 0.3\n");
  unsigned int k = 0;
  for (const std::vector<unsigned int> &face : both_cubes().faces)
  {
    if (k++ % 6 == 0)
      grouped += "g stone layer\nusemtl grey\ns off\n";
    grouped += "f";
    for (const unsigned int vertex : face)
      grouped += text(" \\\n ", vertex + 1, "/1/1");
    grouped += "\n";
  }
  check_cubes("groups.obj", grouped);
  // One group of two stones; and triangles, each with vertices of its own.
  check_cubes("one_group.obj", obj_of("pier", both_cubes()));
  check_cubes("soup.obj", obj_of("", unwelded(triangulated(both_cubes()))));
}

/** The bytes of numbers, in the order of this machine or the other one. */
template <typename Number>
void append(std::string &bytes, const Number value, const bool is_swapped)
{
  char all[sizeof(Number)];
  std::memcpy(all, &value, sizeof(Number));
  if (is_swapped)
    std::reverse(all, all + sizeof(Number));
  bytes.append(all, sizeof(Number));
}

void test_ply()
{
  const Shape shape = both_cubes();
  const auto head = [&](const std::string &format) {
    return "ply\nformat " + format +
           " 1.0\ncomment two cubes\nelement vertex 16\nproperty double x\n"
           "property float y\nproperty double z\nproperty uchar red\n"
           "element face 12\nproperty list uchar int vertex_indices\n"
           "property short flags\nelement edge 1\nproperty int vertex1\n"
           "end_header\n";
  };
  std::string words = head("ascii");
  for (const Point<3> &p : shape.vertices)
    words += text(p[0], ' ', p[1], ' ', p[2], " 255\n");
  for (const std::vector<unsigned int> &face : shape.faces)
    words +=
        text("4 ", face[0], ' ', face[1], ' ', face[2], ' ', face[3], " -1\n");
  check_cubes("ascii.ply", words + "0\n");
  const std::uint16_t one = 1;
  const bool is_little = *reinterpret_cast<const unsigned char *>(&one) == 1;
  for (const bool little : {true, false})
  {
    const bool swapped = little != is_little;
    std::string bytes =
        head(little ? "binary_little_endian" : "binary_big_endian");
    for (const Point<3> &p : shape.vertices)
    {
      append<double>(bytes, p[0], swapped);
      append<float>(bytes, p[1], swapped);
      append<double>(bytes, p[2], swapped);
      append<unsigned char>(bytes, 255, swapped);
    }
    for (const std::vector<unsigned int> &face : shape.faces)
    {
      append<unsigned char>(bytes, 4, swapped);
      for (const unsigned int vertex : face)
        append<std::int32_t>(bytes, vertex, swapped);
      append<std::int16_t>(bytes, -1, swapped);
    }
    append<std::int32_t>(bytes, 0, swapped);
    check_cubes(little ? "little.ply" : "big.ply", bytes);
  }
}

void test_stl()
{
  std::string words, one_solid = "solid\n";
  std::string bytes(80, 's');
  append<std::uint32_t>(bytes, 24, false);
  for (const Shape &shape : {triangulated(cube()), triangulated(cube(1.))})
  {
    std::string facets;
    for (const std::vector<unsigned int> &face : shape.faces)
    {
      facets += "facet normal 0 0 0\n outer loop\n";
      for (unsigned int k = 0; k < 3; ++k)
        append<float>(bytes, 0., false);
      for (const unsigned int vertex : face)
      {
        const Point<3> &p = shape.vertices[vertex];
        facets += text("  vertex ", p[0], ' ', p[1], " +", p[2], "e0\n");
        for (unsigned int d = 0; d < 3; ++d)
          append<float>(bytes, p[d], false);
      }
      facets += " endloop\nendfacet\n";
      append<std::uint16_t>(bytes, 0, false);
    }
    words += "solid stone\n" + facets + "endsolid stone\n";
    one_solid += facets;
  }
  check_cubes("solids.stl", words);
  // The two cubes have a face in common, vertices and all.
  check_cubes("one_solid.STL", one_solid + "endsolid\n");
  check_cubes("binary.stl", bytes);
}

/** A mesh of COMPAS as JSON; coordinates y that are zero are left out. */
std::string compas_mesh_of(const Shape &shape,
                           const std::string &defaults,
                           const bool has_half_edges = false)
{
  std::string vertices, faces;
  for (unsigned int v = 0; v < 8; ++v)
  {
    const Point<3> &p = shape.vertices[v];
    vertices +=
        text(v > 0 ? ", " : "", "\"", 10 * v, "\": {\"z\": ", p[2],
             ", \"x\": ", p[0], p[1] == 0. ? "" : text(", \"y\": ", p[1]), "}");
  }
  for (unsigned int f = 0; f < 6; ++f)
  {
    faces +=
        text(f > 0 ? ", " : "", "\"", f, "\": ", has_half_edges ? "{" : "[");
    for (unsigned int i = 0; i < 4; ++i)
      faces += has_half_edges
                   ? text(i > 0 ? ", " : "", "\"", 10 * shape.faces[f][i],
                          "\": \"", 10 * shape.faces[f][(i + 1) % 4], "\"")
                   : text(i > 0 ? ", " : "", 10 * shape.faces[f][i]);
    faces += has_half_edges ? "}" : "]";
  }
  return "{\"attributes\": {\"name\": \"Mesh\"}, \"" + defaults +
         "\": {\"x\": 0.0, \"y\": 0.0, \"z\": 0.0}, \"vertex\": {" + vertices +
         "}, \"face\": {" + faces + "}}";
}

std::string data(const std::string &type, const std::string &inside)
{
  return "{\"dtype\": \"" + type + "\", \"data\": " + inside + "}";
}

void test_compas()
{
  const std::string a = compas_mesh_of(cube(), "default_vertex_attributes");
  const std::string b = compas_mesh_of(cube(1.), "dva");
  const std::string c = compas_mesh_of(cube(1.), "dva", true);
  const std::string mesh = "compas.datastructures/Mesh";
  check_cubes("list.json", "[" + a + ", " + b + "]");
  check_cubes("wrapped.json",
              data("list", "[[" + data(mesh, a) + "], [{\"dtype\": \"" + mesh +
                               "\", \"value\": " + data(mesh, c) + "}]]"));
  const std::string nodes =
      "{\"node\": {\"7\": {\"block\": " + data(mesh, a) +
      ", \"is_support\": true}, \"3\": {\"block\": " + data(mesh, b) + "}}}";
  check_cubes("assembly.json",
              data("compas_assembly.datastructures/Assembly",
                   "{\"attributes\": {}, \"graph\": " +
                       data("compas.datastructures/Graph", nodes) + "}"),
              1);
  check("records are keys",
        cells_of_model(read_model("assembly.json"), {}).cells.records ==
            std::vector<unsigned int>({3, 7}));
  check("supports not from the file",
        cells_of_model(read_model("assembly.json"), {1., 0., false})
                .cells.records == std::vector<unsigned int>({7, 3}));
  check_cubes("old.json",
              "{\"blocks\": {\"0\": " + a + ", \"1\": " + c +
                  "}, \"assembly\": {\"dva\": {\"is_support\": false}, "
                  "\"vertex\": {\"0\": {\"is_support\": true}, \"1\": {}}}}",
              1);
  const std::string turn =
      data("compas.geometry/Transformation",
           "{\"matrix\": [[0.0, -1.0, 0.0, 1.0], [1.0, 0.0, 0.0, 0.0], "
           "[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]]}");
  const std::string shift =
      data("compas.geometry/Translation",
           "{\"matrix\": [[1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 0.0], "
           "[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]]}");
  // Before that turn, -y is what x is after it.
  const std::string down =
      data("compas.geometry/Translation",
           "{\"matrix\": [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, -1.0], "
           "[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]]}");
  const auto element = [&](const std::string &transformation,
                           const std::string &more) {
    return data("compas_dem.elements/Block",
                "{\"transformation\": " + transformation +
                    ", \"name\": \"Block\", \"geometry\": " + data(mesh, a) +
                    more + "}");
  };
  check_cubes("block_model.json",
              data("compas_dem.models/BlockModel",
                   "{\"transformation\": null, \"elements\": {\"p\": " +
                       element("null", ", \"is_support\": true") +
                       ", \"q\": " + element(shift, "") + "}}"),
              1);
  // A quarter turn about z in the model, after the shift by the group.
  check_cubes(
      "hierarchy.json",
      data("compas_model.models/Model",
           "{\"transformation\": " + turn + ", \"elements\": {\"g\": " +
               data("compas_model.elements/Group",
                    "{\"transformation\": " + down + "}") +
               ", \"p\": " + element("null", "") +
               ", \"q\": " + element("null", "") +
               "}, \"tree\": {\"root\": {\"children\": [{\"element\": \"p\"}, "
               "{\"element\": \"g\", \"children\": [{\"element\": "
               "\"q\"}]}]}}}"));
}

void test_tess()
{
  std::string lines = "***tess\n **format\n   3.4\n **general\n   3 standard\n"
                      " **vertex\n  12\n";
  for (unsigned int v = 0; v < 12; ++v)
    lines += text(v + 1, ' ', v % 3, ' ', v / 3 % 2, ' ', v / 6, " 0\n");
  const std::vector<std::vector<unsigned int>> faces = {
      {1, 7, 10, 4},  {1, 2, 8, 7},   {4, 10, 11, 5},
      {1, 4, 5, 2},   {7, 8, 11, 10}, {2, 5, 11, 8}, // between the two
      {2, 3, 9, 8},   {5, 11, 12, 6}, {2, 5, 6, 3},
      {8, 9, 12, 11}, {3, 6, 12, 9}};
  lines += " **face\n  11\n";
  for (unsigned int f = 0; f < faces.size(); ++f)
  {
    lines += text(f + 1, " 4");
    for (const unsigned int vertex : faces[f])
      lines += text(' ', vertex);
    lines += "\n 4 1 2 3 4\n 0 0 0 1\n 0 0 0 0 0\n";
  }
  lines += " **polyhedron\n  2\n 1 6 1 2 3 4 5 6\n 2 6 -6 7 8 9 10 11\n"
           "***end\n";
  check_cubes("two.tess", lines);
}

/** Interfaces in an Assembly, read as what they are. */
void test_interfaces()
{
  const CellFaces cells =
      cells_of_model(meshes_of({block_of(cube()), block_of(cube(1.))}), {})
          .cells;
  FaceContacts contacts;
  contacts.faces.push_back({{5, 10}}); // x = 1 of both
  contacts.patches.add(cells.polygon(5));
  std::ostringstream out;
  write_compas_assembly(out, cells, &contacts);
  const nlohmann::json tree = nlohmann::json::parse(out.str());
  const nlohmann::json &graph = tree["data"]["graph"]["data"];
  check("is_support is there",
        graph["node"]["0"]["is_support"] == false &&
            graph["edge"]["1"] == nlohmann::json::object());
  const nlohmann::json &interfaces = graph["edge"]["0"]["1"]["interfaces"];
  check("one interface", interfaces.size() == 1);
  const nlohmann::json &interface = interfaces[0]["data"];
  check("its area and places", interface["size"] == 1. &&
                                   interface["points"].size() == 4 &&
                                   interface["forces"].is_null());
  const auto vector_of = [&](const std::string &name) {
    const nlohmann::json &x = interface["frame"]["data"][name];
    return dealii::Tensor<1, 3>({x[0], x[1], x[2]});
  };
  const dealii::Tensor<1, 3> normal =
      cross_product_3d(vector_of("xaxis"), vector_of("yaxis"));
  check_error("its normal points to the second cell",
              (normal - dealii::Tensor<1, 3>({1., 0., 0.})).norm(), 1e-15);
  check_error(
      "its centroid",
      (vector_of("point") - dealii::Tensor<1, 3>({1., 0.5, 0.5})).norm(),
      1e-15);
}

/** The generator, with the entries of its section. */
void test_generator()
{
  ModelGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.set("File", "assembly.json");
  prm.set("Scale", 1e-3);
  prm.set("Tolerance", 0.02);
  const CellFaces cells = generator.generate("", Terminal::silent());
  check("the generator's name and file",
        generator.name() == "model" &&
            generator.input_files("there") ==
                std::vector<std::filesystem::path>{"there/assembly.json"});
  check_error("its scale", std::abs(volume_of(cells) / 2e-9 - 1.), 1e-14);
  check_error("its tolerance", std::abs(cells.tolerance / 2e-5 - 1.), 1e-14);
  check("its supports", cells.n_fixed == 1);
  prm.set("Supports from file", false);
  check("without supports",
        generator.generate("", Terminal::silent()).n_fixed == 0);
}

void run()
{
  work_in_own_directory();
  for (const std::string name :
       {"assembly_arch.json", "cra_A.json", "cra_bridge.json",
        "cra_cube_curve_short.json", "cra_cubes.json", "cra_snake.json",
        "dem_block_model.json", "dem_wall.obj", "model_arch_pi.obj",
        "model_wall_curved.obj", "neper_n100.tess"})
    check_file(name);
  check_file("dem_dome.obj", true);
  const double tessellated =
      volume_of(cells_of_model(read_model(std::filesystem::path(SOURCE_DIR) /
                                          "models/neper_n100.tess"),
                               {})
                    .cells);
  check_error("the tessellation fills its cube", std::abs(tessellated - 1.),
              1e-10);
  test_off_and_obj();
  test_ply();
  test_stl();
  test_compas();
  test_tess();
  test_interfaces();
  test_generator();
}

const RoomTest test("model_files", run);
} // namespace test_model_files
