// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/blas.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/parallel/begin_mpi.h>
#include <voussoir/python/arrays.h>
#include <voussoir/python/scene.h>
#include <voussoir/scene/proofs/utilisation.h>
#include <voussoir/version.h>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace Voussoir
{
namespace
{
namespace py = pybind11;

/** The polygons of a packing as arrays. */
std::vector<py::array_t<double>> polygons_of(const Packing &packing)
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

/** A value for each cell, or each interface, of a packing. */
template <typename Value>
auto filled(const std::size_t n, const Value &value)
{
  py::array_t<decltype(value(0U))> array(n);
  for (unsigned int k = 0; k < n; ++k)
    array.mutable_at(k) = value(k);
  return array;
}

/** The geometry and the topology, for scenes and results. */
template <typename Class, typename Get>
void add_packing(Class &of, const Get &packing)
{
  const auto add = [&](const char *name, const auto &value, const char *words) {
    of.def_property_readonly(
        name,
        [packing, value](typename Class::type &self) {
          return value(packing(self));
        },
        words);
  };
  add(
      "polygons", [](const Packing &p) { return polygons_of(p); },
      "The corners of each block, arrays of shape (n, 2); L.");
  add(
      "centres",
      [](const Packing &p) {
        py::array_t<double> x({int(p.n_cells()), 2});
        for (unsigned int c = 0; c < p.n_cells(); ++c)
          for (unsigned int d = 0; d < 2; ++d)
            x.mutable_at(c, d) = p.centre(c)[d];
        return x;
      },
      "x_c of each block, shape (n_blocks, 2); L.");
  add(
      "areas",
      [](const Packing &p) {
        return filled(p.n_cells(), [&](unsigned int c) { return p.area(c); });
      },
      "|c| of each block; L^2.");
  add(
      "groups",
      [](const Packing &p) {
        std::vector<std::string> names;
        for (unsigned int c = 0; c < p.n_cells(); ++c)
          names.push_back(p.group_name(c));
        return names;
      },
      "The name of the group of each block.");
  add(
      "cell_minus",
      [](const Packing &p) {
        return filled(p.interfaces().size(), [&](unsigned int e) {
          return std::int64_t(p.interfaces()[e].cell_minus);
        });
      },
      "c- of each joint.");
  add(
      "cell_plus",
      [](const Packing &p) {
        return filled(p.interfaces().size(), [&](unsigned int e) {
          const unsigned int plus = p.interfaces()[e].cell_plus;
          return plus == p.ground() ? std::int64_t(-1) : std::int64_t(plus);
        });
      },
      "c+ of each joint; -1 is the ground.");
}

/** A view of one member of all interfaces of a packing that @p owner keeps. */
template <typename Owner>
py::array_t<double> of_interfaces(const Packing &packing,
                                  const double *first,
                                  const std::vector<py::ssize_t> &shape,
                                  const Owner &owner)
{
  return view<double, Packing::Interface>(first, packing.interfaces().size(),
                                          shape, owner);
}

void add_joints(py::class_<PyResults> &of)
{
  const auto add = [&](const char *name, const auto &member,
                       const std::vector<py::ssize_t> &shape,
                       const char *words) {
    of.def_property_readonly(
        name,
        [member, shape](const PyResults &self) {
          const Packing &p = self.scene().packing;
          static const Packing::Interface nothing = {};
          const Packing::Interface &first =
              p.interfaces().empty() ? nothing : p.interfaces().front();
          return of_interfaces(p, member(first), shape, self.findings);
        },
        words);
  };
  using Interface = Packing::Interface;
  add(
      "starts", [](const Interface &i) { return &i.start[0]; }, {2},
      "The start of each joint, shape (n_joints, 2); L.");
  add(
      "ends", [](const Interface &i) { return &i.end[0]; }, {2},
      "The end of each joint; t_e runs from start to end; L.");
  add(
      "normals", [](const Interface &i) { return &i.normal[0]; }, {2},
      "n_e of each joint, from c- to c+.");
  add(
      "lengths", [](const Interface &i) { return &i.length; }, {},
      "|e| of each joint; L.");
}

/** Of the samples, if there are any that have settled. */
void add_samples(py::class_<PyResults> &of)
{
  using Forces = std::vector<Moments> StateSamples::*;
  const auto add = [&](const std::string &name, const Forces forces,
                       double Moments::*const moment, const double sign,
                       const std::string &words) {
    of.def_property_readonly(
        name.c_str(),
        [=](const PyResults &self) {
          const Results &r = self.state(name);
          if (!r.samples)
            throw py::attribute_error(
                "there are no samples, so that there is no '" + name +
                "'; set 'Ranges/Samples'");
          if (!r.samples->have_settled())
            throw py::attribute_error(
                "the samples have not settled, so that there is no '" + name +
                "'; see 'warnings'");
          const std::vector<Moments> &all = (*r.samples).*forces;
          return filled(all.size(), [&](unsigned int e) {
            return 0. + sign * (all[e].*moment);
          });
        },
        words.c_str());
  };
  const auto add_force = [&](const std::string &letter, const Forces forces,
                             const double sign, const std::string &what) {
    add(letter + "_mean", forces, &Moments::mean, sign,
        "The mean of " + what + " of each joint over the samples; S L.");
    add(letter + "_mean_error", forces, &Moments::error, 1.,
        "The standard error of that mean; S L.");
    add(letter + "_deviation", forces, &Moments::deviation, 1.,
        "The standard deviation of " + what + " over the samples; S L.");
  };
  add_force("p", &StateSamples::normal, -1., "the pressure -f_e^n");
  add_force("q", &StateSamples::tangential, 1., "f_e^t");
}

void add_forces(py::class_<PyResults> &of)
{
  const auto add = [&](const char *name, const auto &values,
                       const char *words) {
    of.def_property_readonly(
        name,
        [name, values](const PyResults &self) {
          return values(self.state(name), self);
        },
        words);
  };
  add(
      "normal_force",
      [](const Results &r, const PyResults &self) {
        return view_of(r.forces.normal, {}, self.findings);
      },
      "f_e^n of each joint, negative in compression; S L.");
  add(
      "tangential_force",
      [](const Results &r, const PyResults &self) {
        return view_of(r.forces.tangential, {}, self.findings);
      },
      "f_e^t of each joint: the force on c- along t_e; S L.");
  add(
      "end_forces",
      [](const Results &r, const PyResults &self) {
        return view_of(r.forces.at_ends, {2}, self.findings);
      },
      "What of f_e^n acts at the start and at the end, shape (n_joints, 2), "
      "or (0, 2) where blocks do not turn; S L.");
  add(
      "utilisation",
      [](const Results &r, const PyResults &) {
        return filled(r.forces.normal.size(), Utilisation(r.scene, r.forces));
      },
      "The share of the strength of each joint that is used.");
  add(
      "eccentricity",
      [](const Results &r, const PyResults &) {
        const auto &interfaces = r.scene.packing.interfaces();
        return filled(interfaces.size(), [&](unsigned int e) {
          return r.forces.eccentricity(interfaces[e], e);
        });
      },
      "The place of the resultant over the length of each joint, from -1/2 at "
      "its start to 1/2 at its end.");
  add(
      "stress",
      [](const Results &r, const PyResults &self) {
        return view_of(r.mean_stresses, {2, 2}, self.findings);
      },
      "The mean stress of each block, shape (n_blocks, 2, 2); S.");
  add(
      "torque",
      [](const Results &r, const PyResults &self) {
        return view_of(r.torques, {}, self.findings);
      },
      "The torque of all forces on each block, which is zero where blocks "
      "turn; S L^2.");
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
  add_packing(scene, [](PyScene &self) -> const Packing & {
    return self.get_packing();
  });

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
                    "Sentences: what the program would print.")
      .def_property_readonly(
          "loads",
          [](const PyResults &self) {
            return view_of(self.scene().load, {2}, self.findings);
          },
          "F_c of each block, shape (n_blocks, 2); S L.")
      .def_property_readonly(
          "strength",
          [](const PyResults &self) {
            return view_of(self.scene().strength, {}, self.findings);
          },
          "s_e of each joint; S.")
      .def_property_readonly(
          "displacement",
          [](const PyResults &self) {
            return view_of(self.motion().displacement, {2}, self.findings);
          },
          "Of each block, shape (n_blocks, 2); that of the mechanism if the "
          "load is not carried, or a load factor has one.")
      .def_property_readonly(
          "rotation",
          [](const PyResults &self) {
            return view_of(self.motion().rotation, {}, self.findings);
          },
          "The angle of each block, counterclockwise; empty where blocks do "
          "not turn.");
  add_packing(results, [](const PyResults &self) -> const Packing & {
    return self.scene().packing;
  });
  add_joints(results);
  add_forces(results);
  add_samples(results);
}
