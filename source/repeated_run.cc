// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters.h>
#include <voussoir/output/summary.h>
#include <voussoir/repeated_run.h>
#include <voussoir/result_writer.h>
#include <voussoir/scene/reactions.h>
#include <voussoir/study.h>

#include <chrono>
#include <sstream>
#include <utility>

namespace Voussoir
{
namespace
{
/** The parameters of a run, and what they are bound to. */
struct BoundRun
{
  BoundRun(const std::filesystem::path &file,
           const std::vector<std::string> &assignments)
      : terminal(nowhere), timer(nowhere,
                                 dealii::TimerOutput::never,
                                 dealii::TimerOutput::wall_times),
        study(terminal, alone, timer), writer(terminal, alone, timer)
  {
    writer.add_entries(prm);
    study.add_entries(prm);
    study.add_sections(prm, subsections_in("Load cases", file, assignments));
    writer.add_sections(prm);
    read_parameters(prm, file);
    for (const std::string &assignment : assignments)
      assign_parameter(prm, assignment);
  }

  std::ostringstream nowhere;
  Terminal terminal;
  const Team alone;
  dealii::TimerOutput timer;
  dealii::ParameterHandler prm;
  Study study;
  ResultWriter writer;
};

bool starts_with(const std::string &text, const std::string &start)
{
  return text.compare(0, start.size(), start) == 0;
}

/** The directory of a file, where relative paths begin. */
std::filesystem::path directory_of(const std::filesystem::path &file)
{
  return std::filesystem::proximate(
      std::filesystem::canonical(file).parent_path());
}
} // namespace

RepeatedRun::RepeatedRun(std::filesystem::path file,
                         std::vector<std::string> assignments,
                         std::vector<std::string> names)
    : file(std::move(file)), assignments(std::move(assignments)),
      names(std::move(names)), shares_packing(true)
{
  for (const std::string &name : this->names)
    shares_packing = shares_packing && !starts_with(name, "Packing/") &&
                     !starts_with(name, "Supports/");
  const BoundRun bound(this->file, this->assignments);
  directory = bound.prm.get("Output directory");
}

RunOutcome RepeatedRun::run(const std::vector<std::string> &values,
                            const std::string &results)
{
  const auto begin = std::chrono::steady_clock::now();
  std::vector<std::string> all = assignments;
  for (std::size_t k = 0; k < names.size(); ++k)
    all.push_back(names[k] + '=' + values[k]);
  if (!results.empty())
    all.push_back("Output directory=" + results);
  BoundRun bound(file, all);

  RunOutcome outcome;
  outcome.values = values;
  const auto make_packing = [&] {
    return bound.study.read_packing(directory_of(file));
  };
  const auto summary_of = [&](const auto &found) {
    std::ostringstream json;
    write_summary_json(json, found);
    outcome.summary = nlohmann::json::parse(json.str());
  };
  try
  {
    if (shares_packing)
    {
      const std::lock_guard lock(making_packing);
      if (!packing)
        packing = std::make_unique<const Packing>(make_packing());
    }
    Findings findings = bound.study.answer(
        bound.study.given(shares_packing ? *packing : make_packing()),
        bound.study.earlier_run());
    outcome.has_answer = true;
    if (auto *const carried = std::get_if<Results>(&findings.found))
    {
      outcome.answer = carried->status.kind;
      carried->reactions = reactions(*findings.scene, carried->forces);
      summary_of(*carried);
    }
    else
    {
      outcome.answer = Status::Kind::collapse;
      summary_of(std::get<Collapse>(findings.found));
    }
    if (!results.empty())
    {
      ResultDirectory files = bound.writer.open(bound.study.forces_from());
      std::visit(
          [&](auto &found) { bound.writer.write(files, found, bound.prm); },
          findings.found);
    }
  }
  catch (const InputError &error)
  {
    const std::string reason = error.what();
    throw InputError("With " + words_of(names, values) + ": " + reason);
  }
  catch (const LoadNotCarried &)
  {
    // All of it is written.
  }
  catch (const SolverError &error)
  {
    outcome.reason = error.what();
  }
  outcome.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
          .count();
  return outcome;
}

std::string words_of(const std::vector<std::string> &names,
                     const std::vector<std::string> &values)
{
  std::string words;
  for (std::size_t k = 0; k < names.size(); ++k)
    words += (k > 0 ? ", " : "") + names[k] + " = " + values[k];
  return words;
}
} // namespace Voussoir
