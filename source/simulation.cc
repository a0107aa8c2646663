// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/output/summary.h>
#include <voussoir/packing/polygons/drawing_faults.h>
#include <voussoir/simulation.h>
#include <voussoir/unused_settings.h>

#include <iostream>
#include <utility>

namespace Voussoir
{
Simulation::Simulation(Terminal &terminal, const Team &team)
    : terminal(terminal), team(team), timer(std::cout,
                                            dealii::TimerOutput::never,
                                            dealii::TimerOutput::wall_times),
      study(terminal, this->team, timer), writer(terminal, this->team, timer)
{}

void Simulation::add_parameters(dealii::ParameterHandler &prm,
                                const std::set<std::string> &load_cases)
{
  writer.add_entries(prm);
  study.add_entries(prm);
  study.add_sections(prm, load_cases);
  writer.add_sections(prm);
}

void Simulation::run(const dealii::ParameterHandler &prm,
                     const std::filesystem::path &directory)
{
  terminal.set_verbosity(writer.verbosity());
  for (const std::string &warning : unused_settings(prm))
    terminal.warning(warning);
  ResultDirectory files = writer.open(study.forces_from());
  for (const std::filesystem::path &file : study.input_files(directory))
    files.spare(file);
  std::optional<EarlierRun> earlier = study.earlier_run();

  if (team.size() > 1)
    terminal.stage("Processes", std::to_string(team.size()));
  timer.enter_subsection("packing");
  terminal.begin("Packing");
  Given given = study.given(read_packing(files, directory));
  show_packing(terminal, given.packing);
  timer.leave_subsection();
  Findings findings = study.answer(std::move(given), std::move(earlier));
  std::visit([&](auto &found) { writer.write(files, found, prm); },
             findings.found);
}

Packing Simulation::read_packing(ResultDirectory &files,
                                 const std::filesystem::path &directory)
{
  try
  {
    return study.read_packing(directory);
  }
  catch (const DrawingRefused &refused)
  {
    const std::string where = writer.show_faults(files, refused);
    if (where.empty())
      throw;
    throw InputError(refused.what() + ('\n' + where));
  }
}
} // namespace Voussoir
