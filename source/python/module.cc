// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/blas.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/output/fields/tables.h>
#include <voussoir/parallel/begin_mpi.h>
#include <voussoir/python/field_arrays.h>
#include <voussoir/python/scene.h>
#include <voussoir/version.h>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace Voussoir
{
namespace
{
namespace py = pybind11;

/** @{ */
/** The number of elements of a packing. */
std::size_t n_interfaces(const Packing<2> &packing)
{
  return packing.interfaces().size();
}
std::size_t n_cells(const Packing<2> &packing)
{
  return packing.n_cells();
}
/** @} */

/** The polygons of a packing as arrays. */
std::vector<py::array_t<double>> polygons_of(const Packing<2> &packing)
{
  std::vector<py::array_t<double>> polygons;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    py::array_t<double> corners({int(packing.n_sides(c)), 2});
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
      for (unsigned int d = 0; d < 2; ++d)
        corners.mutable_at(i, d) = packing.vertex(c, i)[d];
    polygons.push_back(std::move(corners));
  }
  return polygons;
}

/**
 * All that a packing has, and what follows from it alone.
 *
 * @param packing of an object, which the pointer keeps.
 */
template <typename Class, typename Get>
void add_packing(Class &of, const Get &packing)
{
  of.def_property_readonly(
      "polygons",
      [packing](typename Class::type &self) {
        return polygons_of(*packing(self));
      },
      "The corners of each block, arrays of shape (n, 2); L.");
  const auto get = [packing](typename Class::type &self, const std::string &) {
    return packing(self);
  };
  add_fields(of, packing_interface_fields(), get, n_interfaces);
  add_fields(of, packing_cell_fields(), get, n_cells);
}

/** All other quantities of the results: those of any motion come first. */
void add_results(py::class_<PyResults> &of)
{
  const auto moving = [](const PyResults &self, const std::string &) {
    return self.moving();
  };
  const auto state = [](const PyResults &self, const std::string &name) {
    return self.state(name);
  };
  add_fields(of, mechanism_joint_fields(), moving, n_interfaces);
  add_fields(of, mechanism_fields(), moving, n_cells);
  add_fields(of, interface_fields(), state, n_interfaces);
  add_fields(of, cell_fields(), state, n_cells);
}

void add_scene_class(py::module_ &module)
{
  py::class_<PyScene> scene(
      module, "Scene",
      "A packing with its supports, loads and strengths. The packing is made "
      "when it is first needed, and again only if an entry that it is made "
      "from is changed: 'Rotations', or one of 'Packing' or 'Supports'.");
  scene
      .def(
          py::init<
              const std::optional<std::filesystem::path> &, const std::string &,
              const std::vector<py::array_t<double>> &, const py::dict &>(),
          py::arg("file") = py::none(), py::kw_only(), py::arg("text") = "",
          py::arg("polygons") = std::vector<py::array_t<double>>(),
          py::arg("settings") = py::dict(),
          "From a file of parameters, the text of a .prm file, or polygons, "
          "arrays of shape (n, 2); "
          "settings are entries by their names, as in "
          "{'Friction/Strength': 0.5}.")
      .def("set", &PyScene::set, py::arg("name"), py::arg("value"),
           "Change an entry, such as 'Loads/Body force'.")
      .def("__setitem__", &PyScene::set)
      .def("__getitem__", &PyScene::get, py::arg("name"),
           "The text of an entry.")
      .def("solve", &PyScene::solve, "Find what the parameters ask for.");
  add_packing(scene, [](PyScene &self) { return self.get_packing(); });
}

void add_results_class(py::module_ &module)
{
  py::class_<PyResults> results(
      module, "Results",
      "What was found. Arrays are views of its memory, which they keep, and "
      "cannot be written to.");
  results
      .def_property_readonly("status", &PyResults::status,
                             "'solved', 'carried to within' or 'collapse'.")
      .def_property_readonly("summary", &PyResults::summary,
                             "What summary.json has, as a dict: certificate, "
                             "load_factor, ground, ranges, samples and "
                             "others; None "
                             "stands for what is not finite, such as a load "
                             "factor without bound.")
      .def_readonly("warnings", &PyResults::warnings,
                    "Sentences: what the program would print.");
  add_packing(results, [](const PyResults &self) { return self.packing(); });
  add_results(results);
}
} // namespace
} // namespace Voussoir

PYBIND11_MODULE(voussoir, module)
{
  using namespace Voussoir;
  module.doc() =
      "Contact forces between, and stresses inside, the rigid blocks of a "
      "packing. Numbers are in the user's units: L is a length, S a stress, "
      "and a force is per unit thickness, S L. Tension is positive.";
  module.attr("__version__") = VOUSSOIR_VERSION;
  // Of several processes all must begin it.
  if (started_by_mpirun())
    begin_mpi();
  prepare_blas();
  py::register_exception<InputError>(module, "InputError", PyExc_ValueError);
  py::register_exception<SolverError>(module, "SolverError",
                                      PyExc_RuntimeError);

  add_scene_class(module);
  add_results_class(module);
}
