// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameter_tree.h>
#include <voussoir/base/text.h>
#include <voussoir/python/entry_text.h>
#include <voussoir/python/scene.h>

#include <fstream>
#include <pybind11/pybind11.h>

namespace Voussoir
{
namespace py = pybind11;

namespace
{
/** The blocks of a page that every notebook shows at once. */
constexpr std::size_t most_blocks_in_notebook = 2000;

std::string assignment_of(const std::string &name,
                          const py::handle &value,
                          const unsigned int dimension)
{
  return name + '=' + entry_text(name, value, dimension);
}
} // namespace

py::object PyResults::summary() const
{
  const std::string text = json().dump(
      -1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  return py::module_::import("json").attr("loads")(text);
}

void PyResults::write_page(const std::filesystem::path &file)
{
  const std::string html = page();
  std::ofstream out(file);
  if (!(out << html << std::flush))
    throw InputError("The page '" + file.string() +
                     "' cannot be written; is there such a directory, and may "
                     "you write there?");
}

std::string PyResults::view_in_notebook()
{
  if (n_blocks() > most_blocks_in_notebook)
    return text("<p>", status(), ": ", counted(n_blocks(), "block"),
                ", too many to be shown here; <code>report(\"page.html\")"
                "</code> writes the page.</p>");
  const py::object escape = py::module_::import("html").attr("escape");
  return "<iframe srcdoc=\"" + escape(page()).cast<std::string>() +
         "\" width=\"100%\" height=\"700\" frameborder=\"0\"></iframe>";
}

ParameterSources PySources::with(std::vector<std::string> assignments,
                                 const unsigned int dimension) const
{
  for (const auto &[name, value] : settings)
    assignments.push_back(
        assignment_of(py::str(name).cast<std::string>(), value, dimension));
  return {file, text, std::move(assignments)};
}

ParameterSources
PySources::before_dimension(std::vector<std::string> assignments) const
{
  for (const auto &[name, value] : settings)
    if (const auto entry = py::str(name).cast<std::string>();
        entry == dimension_entry)
      assignments.push_back(assignment_of(entry, value, 0));
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

PySolvedWith PyScene::solved_with()
{
  return {parameters().as_written(), directory, take_warnings()};
}

void PyScene::set(const std::string &name, const py::handle &value)
{
  parameters().assign(assignment_of(name, value, parameters().dimension()));
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
