// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameter_tree.h>
#include <voussoir/output/summary/summary.h>
#include <voussoir/python/arrays.h>
#include <voussoir/python/scene.h>
#include <voussoir/scene/proofs/reactions.h>
#include <voussoir/stress/cell_means.h>

#include <utility>
#include <variant>

namespace Voussoir
{
namespace py = pybind11;

namespace
{
/** A value of Python's as it stands in a .prm file. */
std::string text_of(const py::handle &value)
{
  if (py::isinstance<py::bool_>(value))
    return value.cast<bool>() ? "true" : "false";
  // repr: the shortest digits that are the same double.
  return py::isinstance<py::float_>(value) ? py::repr(value) : py::str(value);
}
} // namespace

PyResults::PyResults(RunResult found, std::vector<std::string> warnings)
    : warnings(std::move(warnings)),
      findings(std::make_shared<RunResult>(std::move(found)))
{}

std::shared_ptr<const Results> PyResults::state(const std::string &what) const
{
  const Results *const carried = std::get_if<Results>(&findings->found);
  if (carried == nullptr)
    throw py::attribute_error("the load is not carried, so that there is no '" +
                              what + "'; see 'displacement' and 'summary'");
  return {findings, carried};
}

std::shared_ptr<const MovingScene> PyResults::moving() const
{
  struct Kept
  {
    std::shared_ptr<const RunResult> findings;
    MovingScene moving;
  };
  const auto kept = std::make_shared<const Kept>(
      Kept{findings, MovingScene(*findings->scene, motion())});
  return {kept, &kept->moving};
}

const Motion &PyResults::motion() const
{
  const Results *const of = std::get_if<Results>(&findings->found);
  if (of == nullptr)
    return std::get<Collapse>(findings->found).motion;
  const MotionBeside *const beside = of->motion_beside();
  return beside ? beside->motion : of->motion;
}

py::object PyResults::summary() const
{
  std::ostringstream json;
  std::visit([&](const auto &found) { write_summary_json(json, found); },
             findings->found);
  return py::module_::import("json").attr("loads")(json.str());
}

PyScene::PyScene(const std::optional<std::filesystem::path> &given,
                 const std::string &text,
                 const std::vector<py::array_t<double>> &polygons,
                 const py::dict &settings)
    : terminal(output), run(terminal), packings(1)
{
  ParameterSources sources = {given, text};
  if (!polygons.empty())
  {
    run.give(list_of(polygons));
    sources.assignments.push_back("Packing/Generator=polygons");
  }
  for (const auto &[name, value] : settings)
    sources.assignments.push_back(py::str(name).cast<std::string>() + '=' +
                                  text_of(value));
  run.read(sources);
  if (given)
    directory = std::filesystem::canonical(*given).parent_path();
}

void PyScene::set(const std::string &name, const py::handle &value)
{
  run.assign(name + '=' + text_of(value));
}

std::string PyScene::get(const std::string &name) const
{
  const nlohmann::ordered_json &tree = run.tree();
  const nlohmann::ordered_json::json_pointer place('/' + name);
  if (!tree.contains(place) || !is_entry(tree.at(place)))
    throw py::key_error("there is no entry '" + name + "'");
  return tree.at(place).at("value");
}

std::shared_ptr<const Packing<2>> PyScene::get_packing()
{
  return run.shared_packing(directory, packings);
}

PyResults PyScene::solve()
{
  const py::gil_scoped_release others_may_go_on;
  terminal.take_warnings(); // of a look at the packing, or an exception
  RunResult found = run.run(directory, false, &packings).result;
  if (auto *const results = std::get_if<Results>(&found.found))
  {
    results->torques = residual_torques(*found.scene, results->forces);
    results->mean_stresses = cell_mean_stresses(*found.scene, results->forces);
  }
  output.str("");
  return {std::move(found), terminal.take_warnings()};
}
} // namespace Voussoir
