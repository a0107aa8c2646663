// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/output/csv.h>
#include <voussoir/output/report/verdict.h>
#include <voussoir/output/summary/summary.h>
#include <voussoir/packing/polygons/drawing_faults.h>
#include <voussoir/run/analysis_run.h>
#include <voussoir/scene/proofs/reactions.h>

#include <variant>

namespace Voussoir
{
namespace
{
/** What the page says before all else. */
std::string sentence_of(const RunResult &result, const UnitNames &names)
{
  const auto *const carried = std::get_if<Results>(&result.found);
  return carried ? verdict_of(*carried, names).sentence
                 : verdict_of(std::get<Collapse>(result.found)).sentence;
}
} // namespace

AnalysisRun::AnalysisRun(Terminal &terminal, const ProcessGroup &processes)
    : Run(terminal), processes(processes),
      analysis(terminal, this->processes, timer),
      writer(terminal, this->processes, timer)
{}

void AnalysisRun::declare(const NamedSections &names)
{
  writer.add_entries(prm);
  analysis.add_entries(prm);
  analysis.add_sections(prm, names);
  writer.add_sections(prm);
}

std::shared_ptr<const Packing<2>>
AnalysisRun::shared_packing(const std::filesystem::path &directory,
                            SharedPackings<Packing<2>> &packings) const
{
  return packings.get(
      SceneParameters::packing_key(tree()),
      [&] { return analysis.read_packing(directory); }, terminal);
}

std::vector<std::filesystem::path> AnalysisRun::files_of_forces() const
{
  std::vector<std::filesystem::path> files;
  const std::filesystem::path directory = analysis.forces_from();
  for (const std::string &name : {interfaces_csv, cells_csv, links_csv})
    if (!directory.empty() && std::filesystem::exists(directory / name))
      files.push_back(directory / name);
  return files;
}

void AnalysisRun::validate(const std::filesystem::path &directory) const
{
  show_settings();
  terminal.begin("Packing");
  analysis.show(analysis.data(analysis.read_packing(directory)),
                writer.unit_names());
  terminal.stage("Valid", "nothing was solved, and nothing written");
}

RunOutcome AnalysisRun::carry_out(const std::filesystem::path &directory,
                                  const bool writes,
                                  PackingsOfRuns *const packings)
{
  show_settings();
  const std::unique_ptr<ResultDirectory> files =
      writes ? open(directory) : nullptr;
  if (writes)
    begin_journal(directory, writer.output());
  analysis.keep_in(writes ? &journal : nullptr);
  RunResult result =
      find(directory, files.get(), packings ? &packings->in_plane : nullptr);
  RunOutcome outcome;
  outcome.status = result.status();
  if (files)
  {
    outcome.message = write(*files, result);
    journal.end();
  }
  outcome.summary =
      std::visit([](const auto &of) { return summary_of(of); }, result.found);
  outcome.verdict = sentence_of(result, writer.unit_names());
  return outcome;
}

RunResult AnalysisRun::answer(const std::filesystem::path &directory,
                              SharedPackings<Packing<2>> &packings)
{
  show_settings();
  RunResult result = find(directory, nullptr, &packings);
  std::visit(
      [&](auto &found) {
        found.timings =
            timer.get_summary_data(dealii::TimerOutput::total_wall_time);
      },
      result.found);
  return result;
}

void AnalysisRun::write(const std::filesystem::path &directory,
                        RunResult &result)
{
  made_of = provenance(directory, writer.output().directory);
  write(*open(directory), result);
}

std::string AnalysisRun::write(ResultDirectory &files, RunResult &result)
{
  return std::visit(
      [&](auto &found) {
        found.provenance = made_of;
        return writer.write(files, found, prm);
      },
      result.found);
}

void AnalysisRun::write_page(std::ostream &out, RunResult &result) const
{
  std::visit([&](auto &found) { writer.write_page(out, found, prm); },
             result.found);
}

RunResult AnalysisRun::find(const std::filesystem::path &directory,
                            ResultDirectory *const files,
                            SharedPackings<Packing<2>> *const packings)
{
  timer.reset(); // what an exception in a run before has left
  std::optional<EarlierRun> earlier = analysis.earlier_run();
  if (processes.size() > 1)
    terminal.stage("Processes", std::to_string(processes.size()));

  timer.enter_subsection("packing");
  terminal.begin("Packing");
  SceneData data =
      analysis.data(packings ? *shared_packing(directory, *packings)
                             : read_packing(directory, files));
  timer.leave_subsection();
  RunResult result = analysis.answer(std::move(data), std::move(earlier));
  if (auto *const carried = std::get_if<Results>(&result.found))
    carried->reactions = reactions(carried->scene, carried->forces);
  return result;
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
