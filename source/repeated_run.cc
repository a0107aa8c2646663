// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/output/summary.h>
#include <voussoir/repeated_run.h>
#include <voussoir/scene/reactions.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <sstream>
#include <thread>
#include <utility>
#include <variant>

namespace Voussoir
{
RepeatedRun::RepeatedRun(std::filesystem::path file_in,
                         std::vector<std::string> assignments_in,
                         std::vector<std::string> names_in)
    : file(std::move(file_in)), assignments(std::move(assignments_in)),
      names(std::move(names_in)),
      // As many as there are runs at a time.
      packings(std::max(1U, std::thread::hardware_concurrency()))
{
  RunParameters parameters(Terminal::silent());
  parameters.read({file, {}, assignments});
  origin = std::filesystem::proximate(
      std::filesystem::canonical(file).parent_path());
  directory = parameters.entries().get("Output directory");
  inputs = parameters.study.input_files(origin);
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
  std::ostringstream nowhere;
  Terminal terminal(nowhere);
  RunParameters parameters(terminal);
  parameters.read({file, {}, all});

  RunOutcome outcome;
  outcome.values = values;
  try
  {
    answer(parameters, terminal, !results.empty(), outcome);
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
  outcome.warnings = terminal.take_warnings();
  outcome.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
          .count();
  return outcome;
}

/** Answer the question of the parameters, and write the answer if asked to. */
void RepeatedRun::answer(RunParameters &parameters,
                         Terminal &terminal,
                         const bool writes,
                         RunOutcome &outcome)
{
  for (const std::string &warning : parameters.unused())
    terminal.warning(warning);
  Study &study = parameters.study;
  const std::unique_ptr<ResultDirectory> files(
      writes ? new ResultDirectory(parameters.writer.open(study.forces_from()))
             : nullptr);
  if (writes)
    for (const std::filesystem::path &input : study.input_files(origin))
      files->spare(input);
  std::optional<EarlierRun> earlier = study.earlier_run();
  Findings findings =
      study.answer(study.given(*packings.get(parameters, origin, terminal)),
                   std::move(earlier));
  outcome.has_answer = true;
  outcome.answer = Status::Kind::collapse;
  if (auto *const carried = std::get_if<Results>(&findings.found))
  {
    outcome.answer = carried->status.kind;
    carried->reactions = reactions(*findings.scene, carried->forces);
  }
  std::visit(
      [&](auto &found) {
        outcome.summary = summary_of(found);
        if (writes)
          parameters.writer.write(*files, found, parameters.entries());
      },
      findings.found);
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
