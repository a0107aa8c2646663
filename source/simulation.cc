// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/packing/polygons/drawing_faults.h>
#include <voussoir/simulation.h>

#include <optional>
#include <utility>
#include <variant>

namespace Voussoir
{
Simulation::Simulation(Terminal &terminal, const Team &team)
    : terminal(terminal), parameters(terminal, team)
{}

void Simulation::validate(const std::filesystem::path &directory)
{
  for (const std::string &warning : parameters.unused())
    terminal.warning(warning);
  terminal.begin("Packing");
  const Study &study = parameters.study;
  study.show(study.given(study.read_packing(directory)),
             parameters.writer.unit_names());
  terminal.stage("Valid", "nothing was solved, and nothing written");
}

void Simulation::run(const std::filesystem::path &directory)
{
  Study &study = parameters.study;
  ResultWriter &writer = parameters.writer;
  dealii::TimerOutput &timer = parameters.timer;
  terminal.set_verbosity(writer.verbosity());
  for (const std::string &warning : parameters.unused())
    terminal.warning(warning);
  ResultDirectory files = writer.open(study.forces_from());
  for (const std::filesystem::path &file : study.input_files(directory))
    files.spare(file);
  std::optional<EarlierRun> earlier = study.earlier_run();

  if (parameters.team.size() > 1)
    terminal.stage("Processes", std::to_string(parameters.team.size()));
  timer.enter_subsection("packing");
  terminal.begin("Packing");
  Given given = study.given(read_packing(files, directory));
  timer.leave_subsection();
  Findings findings = study.answer(std::move(given), std::move(earlier));
  std::visit(
      [&](auto &found) { writer.write(files, found, parameters.entries()); },
      findings.found);
}

Packing Simulation::read_packing(ResultDirectory &files,
                                 const std::filesystem::path &directory)
{
  try
  {
    return parameters.study.read_packing(directory);
  }
  catch (const DrawingRefused &refused)
  {
    const std::string where = parameters.writer.show_faults(files, refused);
    if (where.empty())
      throw;
    throw InputError(refused.what() + ('\n' + where));
  }
}
} // namespace Voussoir
