// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/shell_word.h>
#include <voussoir/output/summary/provenance.h>
#include <voussoir/run/run.h>
#include <voussoir/run/unused_settings.h>
#include <voussoir/scene/scene_parameters.h>
#include <voussoir/terminal/interruption.h>

#include <deal.II/base/utilities.h>

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <iostream>
#include <sstream>
#include <utility>

namespace Voussoir
{
namespace
{
/** The names that users have given to sections. */
NamedSections named_sections_in(const WrittenParameters &written)
{
  NamedSections names;
  for (const std::string &of_users : SceneParameters::sections_of_users())
  {
    std::set<std::string> &found = names[of_users];
    for (const ParameterInput &input : written.inputs)
      found.merge(input.sections_in(of_users));
    for (const std::string &text : written.assignments)
      if (const SectionPath section = assignment_of_text(text).to.section;
          section.size() > 1 && section[0] == of_users)
        found.insert(section[1]);
  }
  return names;
}
} // namespace

std::vector<ParameterInput> ParameterSources::inputs() const
{
  std::vector<ParameterInput> inputs;
  if (file)
    inputs.emplace_back(*file);
  if (!text.empty())
    inputs.emplace_back(text, "the text");
  return inputs;
}

void Run::read(const ParameterSources &sources)
{
  const bool is_file = sources.file && sources.text.empty();
  read_written({is_file ? sources.file->string() : "", sources.inputs(),
                sources.assignments});
}

Run::Run(Terminal &terminal)
    : terminal(terminal), timer(std::cout,
                                dealii::TimerOutput::never,
                                dealii::TimerOutput::wall_times)
{}

void Run::read_written(WrittenParameters parameters)
{
  written = std::move(parameters);
  prm.declare_entry(dimension_entry, "2", dealii::Patterns::Integer(2, 3),
                    "2: the blocks are polygons in the plane. 3: they are "
                    "polyhedra in space, with parameters of their own, which "
                    "'voussoir --print-parameters --set Dimension=3' lists; "
                    "its states, load factors and ranges are found as in the "
                    "plane.");
  declare_variables();
  declare(named_sections_in(written));
  assigned.watch(prm);
  assign_all();
  check_dimension();
}

/** Call @p f for each name and expression, as they are assigned. */
template <typename F>
void Run::for_each_variable(const F &f) const
{
  for (const ParameterInput &input : written.inputs)
    for (const auto &[name, expression] : input.entries_in(variables_section))
      f(name, expression);
  for (const std::string &text : written.assignments)
    if (const auto [to, value] = assignment_of_text(text);
        to.section == SectionPath{variables_section})
      f(to.entry, value);
}

/** Declare an entry for each variable that is given somewhere. */
void Run::declare_variables()
{
  for_each_variable([&](const std::string &name, const std::string &) {
    const InSection in_section(prm, {variables_section});
    prm.declare_entry(name, "", dealii::Patterns::Anything(),
                      "An expression of the variables before this one, whose "
                      "number stands for $" +
                          name + " in the values of other entries.");
  });
}

/** Assign all that was written, with the numbers of the variables in it. */
void Run::assign_all()
{
  for_each_variable([&](const std::string &name, const std::string &of_name) {
    variables.set(name, of_name);
  });
  variables.evaluate();
  for (ParameterInput input : written.inputs)
  {
    input.replace_values(variables_section, [&](const std::string &text,
                                                const std::string &place) {
      return variables.in(text, place);
    });
    if (input.assign_to(prm))
    {
      has_listing = true;
      assigned.forget_unchanged();
    }
  }
  for (const std::string &text : written.assignments)
    carry_out(text);
}

void Run::carry_out(const std::string &text)
{
  Assignment assignment = assignment_of_text(text);
  const std::string place = "--set " + text;
  if (assignment.to.section != SectionPath{variables_section})
    assignment.value = variables.in(assignment.value, place);
  Voussoir::assign(prm, assignment, place);
}

void Run::assign(const std::string &text)
{
  const EntryPath to = assignment_of_text(text).to;
  const bool is_variable = to.section == SectionPath{variables_section};
  std::vector<std::string> &assignments = written.assignments;
  const std::vector<std::string> before = assignments;
  assignments.erase(std::remove_if(assignments.begin(), assignments.end(),
                                   [&](const std::string &other) {
                                     return assignment_of_text(other).to == to;
                                   }),
                    assignments.end());
  assignments.push_back(text);
  try
  {
    if (is_variable)
      assign_all();
    else
      carry_out(text);
    check_dimension();
  }
  catch (const InputError &)
  {
    assignments = before;
    if (is_variable)
      assign_all();
    throw;
  }
}

void Run::check_dimension()
{
  const std::string own = std::to_string(dimension());
  const std::string value = prm.get(dimension_entry);
  if (prm.get_integer(dimension_entry) == dimension())
    return;
  prm.set(dimension_entry, own);
  throw InputError("'Dimension' is " + value +
                   ", and this scene has been made with " + own +
                   "; make another one for it.");
}

void Run::print(std::ostream &out,
                const std::string &section,
                const ParameterFormat format,
                const Detail detail)
{
  check_section(prm, dealii::Utilities::split_string_list(section, '/'),
                "--print-parameters=" + section);
  const auto is_wanted = [&](const std::string &path) {
    return (section.empty() || boost::starts_with(path, section + '/')) &&
           (detail == Detail::listing || assigned.contains(path));
  };
  print_parameters(out, prm, is_wanted, format, detail);
}

nlohmann::ordered_json
Run::provenance(const std::filesystem::path &directory,
                const std::filesystem::path &results) const
{
  Origin origin;
  origin.has_given_blocks = has_given_blocks;
  if (!written.file.empty() && !has_given_blocks)
  {
    origin.command = "voussoir " + shell_word(written.file);
    for (const std::string &text : written.assignments)
      origin.command += " --set " + shell_word(text);
  }
  origin.directory = directory;
  std::ostringstream parameters;
  const auto is_of_results = [](const std::string &path) {
    return boost::starts_with(path, "Output");
  };
  print_parameters(
      parameters, prm,
      [&](const std::string &path) { return !is_of_results(path); },
      ParameterFormat::prm, Detail::value);
  origin.parameters = parameters.str();
  origin.files = input_files(directory);
  for (const std::filesystem::path &file : files_of_forces())
    origin.files.push_back(file);
  return provenance_of(origin, results);
}

void Run::begin_journal(const std::filesystem::path &directory,
                        const OutputEntries &output)
{
  if (resumes)
    remove_left_over(output.directory);
  made_of = provenance(directory, output.directory);
  const std::filesystem::path file =
      std::filesystem::path(output.directory) / checkpoint_file;
  journal.begin({file, identity_of(made_of), output.checkpoint_after,
                 [file] {
                   Uninterrupted whole;
                   whole.state("no results were written; with --resume the "
                               "run goes on from '" +
                               file.string() + "'.");
                 }},
                resumes);
}

void Run::show_settings() const
{
  if (!variables.empty())
    terminal.stage("Variables", variables.values_in_words());
  // In a listing numbers stand for them already.
  if (!has_listing)
    for (const std::string &name : variables.unused())
      terminal.warning("'" + variables_section + '/' + name +
                       "' has no effect, since no value has $" + name + ".");
  for (const std::string &warning : unused_settings(assigned))
    terminal.warning(warning);
}
} // namespace Voussoir
