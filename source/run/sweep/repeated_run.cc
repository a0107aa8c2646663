// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/factors/no_live_loads.h>
#include <voussoir/base/content_name.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text_file.h>
#include <voussoir/output/summary/provenance.h>
#include <voussoir/run/make_run.h>
#include <voussoir/run/sweep/repeated_run.h>

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <chrono>
#include <memory>
#include <sstream>
#include <thread>
#include <utility>

namespace Voussoir
{
namespace
{
/** A value of a tree of entries; empty if it has no such entry. */
std::string value_in(const nlohmann::ordered_json &tree,
                     const std::string &place)
{
  const nlohmann::ordered_json::json_pointer at(place);
  return tree.contains(at) ? tree.at(at).get<std::string>() : "";
}
} // namespace

RepeatedRun::RepeatedRun(std::filesystem::path file_in,
                         std::vector<std::string> assignments_in,
                         std::vector<ChangingEntry> changing_in)
    : file(std::move(file_in)), assignments(std::move(assignments_in)),
      changing(std::move(changing_in)),
      // As many as there are runs at a time.
      packings(std::max(1U, std::thread::hardware_concurrency()))
{
  const std::unique_ptr<Run> scene =
      make_run({file, {}, assignments}, Terminal::silent());
  origin = std::filesystem::proximate(
      std::filesystem::canonical(file).parent_path());
  of_scene = scene->entries().get("Title");
  directory = scene->entries().get("Output directory");
  inputs = scene->input_files(origin);
  of_forces = value_in(scene->tree(), "/Forces from/value");
  of_input = identity_of(scene->provenance(origin, directory));
  of_input.erase("threads"); // each run has one
  of_input["kind"] = "many runs";
  seconds_to_checkpoint =
      std::stod(value_in(scene->tree(), "/Output/Checkpoint after/value"));
}

nlohmann::ordered_json json_of(const SweepRun &run)
{
  return {{"values", run.values},
          {"has_answer", run.has_answer},
          {"is_unloaded", run.is_unloaded},
          {"seeks_least", run.seeks_least},
          {"verdict", run.verdict ? static_cast<int>(*run.verdict) : -1},
          {"sentence", run.sentence},
          {"summary", run.summary},
          {"warnings", run.warnings},
          {"reason", run.reason},
          {"page", run.page},
          {"seconds", run.seconds}};
}

SweepRun sweep_run_of(const nlohmann::ordered_json &json)
{
  SweepRun run;
  run.values = json.at("values").get<std::vector<std::string>>();
  run.has_answer = json.at("has_answer");
  run.is_unloaded = json.at("is_unloaded");
  run.seeks_least = json.at("seeks_least");
  if (const int verdict = json.at("verdict"); verdict >= 0)
    run.verdict = static_cast<Status::Kind>(verdict);
  run.sentence = json.at("sentence");
  run.summary = json.at("summary");
  run.warnings = json.at("warnings").get<std::vector<std::string>>();
  run.reason = json.at("reason");
  run.page = json.at("page");
  run.seconds = json.at("seconds");
  return run;
}

std::vector<std::string>
RepeatedRun::assignments_with(const std::vector<std::string> &values) const
{
  std::vector<std::string> all = assignments;
  for (std::size_t k = 0; k < changing.size(); ++k)
    all.push_back(changing[k].assignment(values[k]));
  return all;
}

std::string RepeatedRun::key(const std::vector<std::string> &values) const
{
  std::vector<std::string> texts = assignments_with(values);
  for (const std::string &value : values)
    if (const auto content = bytes_of_file(origin / value))
      texts.push_back(name_of_content(*content));
  return boost::algorithm::join(texts, "\n");
}

SweepRun RepeatedRun::run(const std::vector<std::string> &values,
                          const std::string &results)
{
  const auto begin = std::chrono::steady_clock::now();
  std::vector<std::string> all = assignments_with(values);
  if (!results.empty())
    all.push_back("Output directory=" + results);
  std::ostringstream nowhere;
  Terminal terminal(nowhere);

  SweepRun outcome;
  outcome.values = values;
  try
  {
    const std::unique_ptr<Run> scene = make_run({file, {}, all}, terminal);
    outcome.seeks_least =
        value_in(scene->tree(), "/Load factor/Direction/value") == "least";
    RunOutcome found = scene->carry_out(origin, !results.empty(), &packings);
    outcome.has_answer = true;
    if (found.status)
      outcome.verdict = found.status->kind;
    outcome.summary = std::move(found.summary);
    outcome.sentence = std::move(found.verdict);
  }
  catch (const NoLiveLoads &none)
  {
    outcome.is_unloaded = true;
    outcome.reason = none.what();
  }
  catch (const InputError &error)
  {
    const std::string reason = error.what();
    throw InputError("With " + words_of(names_of(changing), values) + ": " +
                     reason);
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

std::vector<std::string> names_of(const std::vector<ChangingEntry> &changing)
{
  std::vector<std::string> names;
  for (const ChangingEntry &entry : changing)
    names.push_back(entry.name());
  return names;
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
