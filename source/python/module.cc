// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/blas.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/output/fields/polyhedra.h>
#include <voussoir/output/fields/tables.h>
#include <voussoir/parallel/begin_mpi.h>
#include <voussoir/python/arrays.h>
#include <voussoir/python/field_arrays.h>
#include <voussoir/python/plane_scene.h>
#include <voussoir/python/space_scene.h>
#include <voussoir/run/make_run.h>
#include <voussoir/version.h>

#include <memory>
#include <optional>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace Voussoir
{
namespace
{
namespace py = pybind11;

// The number of elements of a packing, of data that have one.
const auto n_links = [](const auto &data) {
  return part_of<Scene>(data).links.size();
};
const auto n_interfaces = [](const auto &data) {
  return part_of<Packing<2>>(data).interfaces().size();
};
const auto n_cells = [](const auto &data) -> std::size_t {
  return part_of<Packing<2>>(data).n_cells();
};
const auto n_faces = [](const auto &data) {
  return part_of<Packing<3>>(data).interfaces().size();
};
const auto n_polyhedra = [](const auto &data) -> std::size_t {
  return part_of<Packing<3>>(data).polyhedra().n_cells();
};
const auto n_boundary_edges = [](const Scene &scene) {
  return scene.packing.boundary_edges().size();
};
const auto n_boundary_faces = [](const SpaceResults &answer) {
  return answer.scene.packing().boundary_faces().size();
};
const auto n_positions = [](const CapacityCurve &curve) {
  return curve.points.size();
};
const auto n_points = [](const ForcePoints &data) { return data.list.size(); };

/** A function of an object and of a name that needs no name. */
template <typename Class, typename Get>
auto without_name(const Get &get)
{
  return [get](typename Class::type &self, const std::string &) {
    return get(self);
  };
}

/** The numbers of joints and of blocks, which arrays of a user must have. */
template <typename Class, typename Get>
void add_numbers(Class &of, const Get &packing)
{
  of.def_property_readonly(
        "n_joints",
        [packing](typename Class::type &self) {
          return packing(self)->interfaces().size();
        },
        "The number of joints, supports among them: the length of arrays of "
        "strengths.")
      .def_property_readonly(
          "n_blocks",
          [packing](typename Class::type &self) {
            return packing(self)->n_cells();
          },
          "The number of blocks that move: the length of arrays of loads.");
}

/**
 * All that a packing in the plane has, and what follows from it alone.
 *
 * @param packing of an object, which the pointer keeps.
 */
template <typename Class, typename Get>
void add_packing(Class &of, const Get &packing)
{
  add_numbers(of, packing);
  of.def_property_readonly(
      "polygons",
      [packing](typename Class::type &self) {
        return polygons_of(*packing(self));
      },
      "The corners of each block, arrays of shape (n, 2); L.");
  const auto get = without_name<Class>(packing);
  add_fields(of, packing_interface_fields(), get, n_interfaces);
  add_fields(of, packing_cell_fields(), get, n_cells);
}

/** All that a packing in space has; see add_packing(). */
template <typename Class, typename Get>
void add_space_packing(Class &of, const Get &packing)
{
  add_numbers(of, packing);
  of.def_property_readonly(
        "polyhedra",
        [packing](typename Class::type &self) {
          return polyhedra_of(*packing(self));
        },
        "Each block, and behind those that move the fixed ones, as a pair: an "
        "array of its vertices, of shape (n, 3), and its faces, lists of the "
        "numbers of vertices, counterclockwise as seen from outside; L.")
      .def_property_readonly(
          "interface_polygons",
          [packing](typename Class::type &self) {
            return interface_polygons_of(*packing(self));
          },
          "The vertices of each interface, arrays of shape (n, 3), "
          "counterclockwise as seen from c+; L.");
  const auto get = without_name<Class>(packing);
  add_fields(of, packing_face_fields(), get, n_faces);
  add_fields(of, packing_polyhedron_fields(), get, n_polyhedra);
}

/** All other quantities of the results: those of any motion come first. */
template <typename Class>
void add_results(Class &of)
{
  const auto moving = [](const PyPlaneResults &self, const std::string &) {
    return self.moving();
  };
  const auto state = [](const PyPlaneResults &self, const std::string &name) {
    return self.state(name);
  };
  add_fields(of, mechanism_joint_fields(), moving, n_interfaces);
  add_fields(of, mechanism_fields(), moving, n_cells);
  add_fields(of, mechanism_link_fields(), moving, n_links);
  add_fields(of, interface_fields(), state, n_interfaces);
  add_fields(of, cell_fields(), state, n_cells);
  add_fields(of, link_fields(), state, n_links);
  add_fields(of, boundary_fields(),
             without_name<Class>(
                 [](const PyPlaneResults &self) { return self.scene(); }),
             n_boundary_edges);
  add_fields(
      of, capacity_fields(),
      [](const PyPlaneResults &self, const std::string &name) {
        return self.curve(name);
      },
      n_positions);
}

/** All other quantities of the results in space. */
template <typename Class>
void add_space_results(Class &of)
{
  const auto answer = without_name<Class>(
      [](const PySpaceResults &self) { return self.answer(); });
  const auto points = without_name<Class>(
      [](const PySpaceResults &self) { return self.points(); });
  add_fields(of, face_interface_fields(), answer, n_faces);
  add_fields(of, polyhedron_fields(), answer, n_polyhedra);
  add_fields(of, force_point_fields(), points, n_points);
  add_fields(of, boundary_face_fields(), answer, n_boundary_faces);
}

using Path = std::optional<std::filesystem::path>;
using Arrays = std::vector<py::array_t<double>>;

/**
 * An object for Scene(...), whose __init__() is still to be called: of the
 * class for the dimension of the sources, or of @p type itself if that is
 * derived from Scene.
 */
py::object new_scene(const py::object &type,
                     const Path &file,
                     const std::string &text,
                     const py::sequence &polygons,
                     const py::sequence &polyhedra,
                     const py::dict &settings)
{
  const py::object scene = py::type::of<PyScene>();
  // What all classes of pybind11 have, and Scene had before this one.
  const py::object make = scene.attr("__base__").attr("__new__");
  if (!type.is(scene))
    return make(type);
  std::vector<std::string> of_blocks;
  if (!polyhedra.empty())
    of_blocks.push_back(dimension_entry + "=3");
  const bool in_space =
      dimension_of(
          PySources{file, text, settings}.before_dimension(of_blocks)) == 3;
  if (in_space && !polygons.empty())
    throw InputError("'polygons' are blocks in the plane, and 'Dimension' is "
                     "3; give 'polyhedra'.");
  if (!in_space && !polyhedra.empty())
    throw InputError("'polyhedra' are blocks in space, and 'Dimension' is 2; "
                     "give 'polygons'.");
  return make(in_space ? py::type::of<PySpaceScene>()
                       : py::type::of<PyPlaneScene>());
}

/** Scene, which makes one of the classes that are derived from it. */
void add_scene_class(py::module_ &module)
{
  py::class_<PyScene>(
      module, "Scene",
      "A packing with its supports, loads and strengths: a SceneInPlane or, "
      "with 'Dimension' = 3 or polyhedra, a SceneInSpace, which both have "
      "solve(). The packing is made when it is first needed, and again only if "
      "an entry that it is made from is changed: 'Rotations' in the plane, or "
      "one of 'Packing' or 'Supports'.")
      .def_static(
          "__new__", &new_scene, py::arg("type"), py::arg("file") = py::none(),
          py::kw_only(), py::arg("text") = "", py::arg("polygons") = py::list(),
          py::arg("polyhedra") = py::list(), py::arg("settings") = py::dict(),
          "From a file of parameters, the text of a .prm file, or "
          "blocks: polygons, arrays of shape (n, 2), or polyhedra, "
          "pairs of an array of vertices, of shape (n, 3), and the "
          "faces, lists of the numbers of vertices; settings are "
          "entries by their names, as in {'Friction/Strength': 0.5}. See "
          "set() for arrays.")
      .def("set", &PyScene::set, py::arg("name"), py::arg("value"),
           "Change an entry, such as 'Loads/Body force'. Strengths may be "
           "arrays "
           "with a number for each of the n_joints, and 'Body force' and "
           "'Cell forces' arrays with a row for each of the n_blocks.")
      .def("__setitem__", &PyScene::set)
      .def("__getitem__", &PyScene::get, py::arg("name"),
           "The text of an entry.");
}

void add_plane_scene_class(py::module_ &module)
{
  py::class_<PyPlaneScene, PyScene> scene(module, "SceneInPlane",
                                          "A scene of polygons.");
  scene
      .def(py::init([](const Path &file, const std::string &text,
                       const Arrays &polygons, const py::dict &settings) {
             return std::make_unique<PyPlaneScene>(
                 PySources{file, text, settings}, polygons);
           }),
           py::arg("file") = py::none(), py::kw_only(), py::arg("text") = "",
           py::arg("polygons") = Arrays(), py::arg("settings") = py::dict(),
           "See Scene.")
      .def("solve", &PyPlaneScene::solve, "Find what the parameters ask for.");
  add_packing(scene, [](PyPlaneScene &self) { return self.get_packing(); });
}

void add_space_scene_class(py::module_ &module)
{
  py::class_<PySpaceScene, PyScene> scene(module, "SceneInSpace",
                                          "A scene of polyhedra.");
  scene
      .def(
          py::init([](const Path &file, const std::string &text,
                      const py::sequence &polyhedra, const py::dict &settings) {
            return std::make_unique<PySpaceScene>(
                PySources{file, text, settings}, polyhedra);
          }),
          py::arg("file") = py::none(), py::kw_only(), py::arg("text") = "",
          py::arg("polyhedra") = py::list(), py::arg("settings") = py::dict(),
          "See Scene.")
      .def("solve", &PySpaceScene::solve, "Find what the parameters ask for.");
  add_space_packing(scene,
                    [](PySpaceScene &self) { return self.get_packing(); });
}

void add_results_classes(py::module_ &module)
{
  py::class_<PyResults>(module, "Results",
                        "What was found: ResultsInPlane or ResultsInSpace. "
                        "Arrays are views of its memory, which they keep, and "
                        "cannot be written to.")
      .def_property_readonly("status", &PyResults::status,
                             "'solved', 'carried to within' or 'collapse'; in "
                             "space without loads 'packing'.")
      .def_property_readonly("summary", &PyResults::summary,
                             "What summary.json has, as a dict: certificate, "
                             "load_factor, ground, ranges, samples and "
                             "others; None "
                             "stands for what is not finite, such as a load "
                             "factor without bound.")
      .def_property_readonly("warnings", &PyResults::warnings,
                             "Sentences: what the program would print.")
      .def("write", &PyResults::write, py::arg("directory"),
           "Write the files that the program writes, into a directory; what is "
           "written is by 'Output' and 'Accuracy', as they were when this was "
           "solved.")
      .def("report", &PyResults::write_page, py::arg("file"),
           "Write the page with pictures and numbers, report.html, to a file.")
      .def("_repr_html_", &PyResults::view_in_notebook,
           "The page, for notebooks.");
  py::class_<PyPlaneResults, PyResults> in_plane(
      module, "ResultsInPlane", "What was found of a SceneInPlane.");
  add_packing(in_plane,
              [](const PyPlaneResults &self) { return self.packing(); });
  add_results(in_plane);
  py::class_<PySpaceResults, PyResults> in_space(
      module, "ResultsInSpace", "What was found of a SceneInSpace.");
  add_space_packing(in_space,
                    [](const PySpaceResults &self) { return self.packing(); });
  add_space_results(in_space);
}
} // namespace
} // namespace Voussoir

PYBIND11_MODULE(_voussoir, module)
{
  using namespace Voussoir;
  module.attr("__name__") = "voussoir"; // where users find the classes
  module.doc() =
      "Contact forces between, and stresses inside, the rigid blocks of a "
      "packing. Numbers are in the user's units: L is a length, S a stress, "
      "and a force in the plane is per unit thickness, S L. Tension is "
      "positive.";
  module.attr("__version__") = VOUSSOIR_VERSION;
  // Of several processes all must begin it.
  if (started_by_mpirun())
    begin_mpi();
  prepare_blas();
  py::register_exception<InputError>(module, "InputError", PyExc_ValueError);
  py::register_exception<SolverError>(module, "SolverError",
                                      PyExc_RuntimeError);

  add_scene_class(module);
  add_plane_scene_class(module);
  add_space_scene_class(module);
  add_results_classes(module);
}
