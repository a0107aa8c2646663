// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameter_input.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/packing/polygons/drawing_faults.h>
#include <voussoir/run/analysis_run.h>
#include <voussoir/run/unused_settings.h>
#include <voussoir/scene/loads/load_cases.h>
#include <voussoir/scene/proofs/reactions.h>

#include <deal.II/base/utilities.h>

#include <boost/algorithm/string/predicate.hpp>

#include <iostream>
#include <set>
#include <variant>

namespace Voussoir
{
AnalysisRun::AnalysisRun(Terminal &terminal, const ProcessGroup &processes)
    : terminal(terminal), processes(processes),
      timer(std::cout,
            dealii::TimerOutput::never,
            dealii::TimerOutput::wall_times),
      analysis(terminal, this->processes, timer),
      writer(terminal, this->processes, timer)
{}

void AnalysisRun::read(const ParameterSources &sources)
{
  std::vector<ParameterInput> inputs;
  if (sources.file)
    inputs.emplace_back(*sources.file);
  if (!sources.text.empty())
    inputs.emplace_back(sources.text, "the text");
  std::set<std::string> cases;
  for (const ParameterInput &input : inputs)
    cases.merge(input.sections_in(load_cases_section));
  for (const std::string &text : sources.assignments)
  {
    const SectionPath section = assignment_of_text(text).to.section;
    if (section.size() > 1 && section[0] == load_cases_section)
      cases.insert(section[1]);
  }

  writer.add_entries(prm);
  analysis.add_entries(prm);
  analysis.add_sections(prm, cases);
  writer.add_sections(prm);
  assigned.watch(prm);
  for (const ParameterInput &input : inputs)
    if (input.assign_to(prm))
      assigned.forget_unchanged();
  for (const std::string &assignment : sources.assignments)
    assign_parameter(prm, assignment);
}

void AnalysisRun::assign(const std::string &assignment)
{
  assign_parameter(prm, assignment);
}

void AnalysisRun::print(std::ostream &out,
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

void AnalysisRun::warn_of_unused() const
{
  for (const std::string &warning : unused_settings(assigned))
    terminal.warning(warning);
}

std::shared_ptr<const Packing<2>>
AnalysisRun::shared_packing(const std::filesystem::path &directory,
                            SharedPackings &packings) const
{
  return packings.get(
      SceneParameters::packing_key(tree()),
      [&] { return analysis.read_packing(directory); }, terminal);
}

void AnalysisRun::validate(const std::filesystem::path &directory) const
{
  warn_of_unused();
  terminal.begin("Packing");
  analysis.show(analysis.data(analysis.read_packing(directory)),
                writer.unit_names());
  terminal.stage("Valid", "nothing was solved, and nothing written");
}

RunOutcome AnalysisRun::run(const std::filesystem::path &directory,
                            const bool writes,
                            SharedPackings *const packings)
{
  timer.reset(); // what an exception in a run before has left
  warn_of_unused();
  const std::unique_ptr<ResultDirectory> files =
      writes ? open(directory) : nullptr;
  std::optional<EarlierRun> earlier = analysis.earlier_run();
  if (processes.size() > 1)
    terminal.stage("Processes", std::to_string(processes.size()));

  timer.enter_subsection("packing");
  terminal.begin("Packing");
  SceneData data =
      analysis.data(packings ? *shared_packing(directory, *packings)
                             : read_packing(directory, files.get()));
  timer.leave_subsection();
  RunOutcome outcome = {analysis.answer(std::move(data), std::move(earlier)),
                        {}};
  auto &found = outcome.result.found;
  if (auto *const carried = std::get_if<Results>(&found))
    carried->reactions = reactions(carried->scene, carried->forces);
  if (files)
    outcome.message = std::visit(
        [&](auto &of) { return writer.write(*files, of, prm); }, found);
  return outcome;
}

std::unique_ptr<ResultDirectory>
AnalysisRun::open(const std::filesystem::path &directory)
{
  std::unique_ptr<ResultDirectory> files(
      new ResultDirectory(writer.open(analysis.forces_from())));
  for (const std::filesystem::path &file : analysis.input_files(directory))
    files->protect(file);
  return files;
}

Packing<2> AnalysisRun::read_packing(const std::filesystem::path &directory,
                                     ResultDirectory *const files)
{
  try
  {
    return analysis.read_packing(directory);
  }
  catch (const DrawingRefused &refused)
  {
    const std::string where = files ? writer.show_faults(*files, refused) : "";
    if (where.empty())
      throw;
    throw InputError(refused.what() + ('\n' + where));
  }
}
} // namespace Voussoir
