// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/output/summary/summary.h>
#include <voussoir/run/sweep/repeated_run.h>

#include <algorithm>
#include <chrono>
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
  AnalysisRun analysis(Terminal::silent());
  analysis.read({file, {}, assignments});
  origin = std::filesystem::proximate(
      std::filesystem::canonical(file).parent_path());
  directory = analysis.entries().get("Output directory");
  inputs = analysis.input_files(origin);
}

SweepRun RepeatedRun::run(const std::vector<std::string> &values,
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
  AnalysisRun analysis(terminal);
  analysis.read({file, {}, all});

  SweepRun outcome;
  outcome.values = values;
  try
  {
    const RunResult result =
        analysis.run(origin, !results.empty(), &packings).result;
    outcome.has_answer = true;
    outcome.answer = result.status().kind;
    outcome.summary = std::visit(
        [](const auto &found) { return summary_of(found); }, result.found);
  }
  catch (const InputError &error)
  {
    const std::string reason = error.what();
    throw InputError("With " + words_of(names, values) + ": " + reason);
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

std::string words_of(const std::vector<std::string> &names,
                     const std::vector<std::string> &values)
{
  std::string words;
  for (std::size_t k = 0; k < names.size(); ++k)
    words += (k > 0 ? ", " : "") + names[k] + " = " + values[k];
  return words;
}
} // namespace Voussoir
