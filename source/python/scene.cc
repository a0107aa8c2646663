// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameter_tree.h>
#include <voussoir/python/scene.h>

#include <pybind11/pybind11.h>

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

py::object PyResults::summary() const
{
  const std::string text = json().dump(
      -1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  return py::module_::import("json").attr("loads")(text);
}

ParameterSources PySources::with(std::vector<std::string> assignments) const
{
  for (const auto &[name, value] : settings)
    assignments.push_back(py::str(name).cast<std::string>() + '=' +
                          text_of(value));
  return {file, text, std::move(assignments)};
}

PyScene::PyScene(const PySources &sources)
    : terminal(output),
      directory(sources.file
                    ? std::filesystem::canonical(*sources.file).parent_path()
                    : ".")
{}

std::vector<std::string> PyScene::take_warnings()
{
  output.str("");
  return terminal.take_warnings();
}

void PyScene::set(const std::string &name, const py::handle &value)
{
  parameters().assign(name + '=' + text_of(value));
}

std::string PyScene::get(const std::string &name) const
{
  const nlohmann::ordered_json &tree = parameters().tree();
  const nlohmann::ordered_json::json_pointer place('/' + name);
  if (!tree.contains(place) || !is_entry(tree.at(place)))
    throw py::key_error("there is no entry '" + name + "'");
  return tree.at(place).at("value");
}
} // namespace Voussoir
