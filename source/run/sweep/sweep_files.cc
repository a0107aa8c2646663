// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/summary/text_lines.h>
#include <voussoir/run/sweep/sweep_files.h>
#include <voussoir/run/sweep/sweep_results.h>

#include <boost/algorithm/string/join.hpp>

#include <map>
#include <ostream>

namespace Voussoir
{
const std::vector<SweepColumn> sweep_columns = {
    {"load_factor", "load_factor/carried"},
    {"load_factor_bound", "load_factor/bound"},
    {"within", "within"},
    {"equilibrium_residual", "certificate/equilibrium_residual"},
    {"admissibility_violation", "certificate/admissibility_violation"},
    {"max_utilisation", "certificate/max_utilisation"},
    {"work_over_dissipation", "mechanism/work_over_dissipation"},
    {"closing_violation", "mechanism/closing_violation"},
    {"iterations", "solver/iterations"}};

namespace
{
/** The text of a table's field, in quotes if need be. */
std::string field(const std::string &text)
{
  if (text.find_first_of(",\"\n") == text.npos)
    return text;
  std::string quoted = "\"";
  for (const char letter : text)
    quoted += letter == '"' ? std::string("\"\"")
                            : std::string(1, letter == '\n' ? ' ' : letter);
  return quoted + '"';
}
} // namespace

std::string word_of(const SweepRun &run)
{
  if (run.is_unloaded)
    return "unloaded";
  return run.has_answer ? run.summary.at("status").get<std::string>()
                        : "failed";
}

std::string kind_of_verdict(const SweepRun &run)
{
  if (!run.verdict)
    return "none";
  return *run.verdict == Status::Kind::collapse         ? "collapse"
         : *run.verdict == Status::Kind::carried_within ? "within"
                                                        : "carried";
}

std::string counts_of(const std::vector<SweepRun> &runs)
{
  std::map<std::string, std::size_t> of_word;
  for (const SweepRun &run : runs)
    ++of_word[word_of(run)];
  std::string words;
  for (const auto &[word, n] : of_word)
    words += text(words.empty() ? "" : ", ", n, ' ', word);
  return words;
}

std::string SharedWarning::description(const std::vector<std::string> &names,
                                       const std::vector<SweepRun> &all) const
{
  const std::string first = words_of(names, all[runs.front()].values);
  if (runs.size() == 1)
    return "With " + first + ": " + text;
  if (runs.size() == all.size())
    return "In all runs: " + text;
  return Voussoir::text("In ", runs.size(), " of ", all.size(),
                        " runs, the first with ", first, ": ", text);
}

std::vector<SharedWarning> warnings_of(const std::vector<SweepRun> &runs)
{
  std::vector<SharedWarning> warnings;
  std::map<std::string, std::size_t> place;
  for (std::size_t k = 0; k < runs.size(); ++k)
    for (const std::string &text : runs[k].warnings)
    {
      const auto [found, is_new] = place.emplace(text, warnings.size());
      if (is_new)
        warnings.push_back({text, {}});
      std::vector<std::size_t> &of = warnings[found->second].runs;
      if (of.empty() || of.back() != k)
        of.push_back(k);
    }
  return warnings;
}

void write_sweep_csv(std::ostream &out,
                     const std::vector<std::string> &names,
                     const std::vector<std::string> &results,
                     const std::vector<SweepRun> &runs)
{
  for (const std::string &name : names)
    out << field(name) << ',';
  out << "status";
  for (const SweepColumn &column : sweep_columns)
    out << ',' << column.first;
  for (const std::string &result : results)
    out << ',' << field(result);
  out << ",seconds,message,warnings\n";
  for (const SweepRun &run : runs)
  {
    for (const std::string &value : run.values)
      out << field(value) << ',';
    out << word_of(run);
    for (const SweepColumn &column : sweep_columns)
      out << ',' << field(result_at(run.summary, column.second));
    for (const std::string &result : results)
      out << ',' << field(result_at(run.summary, result));
    out << ',' << value_text(run.seconds) << ',' << field(run.reason) << ','
        << field(boost::algorithm::join(run.warnings, " ")) << '\n';
  }
}
} // namespace Voussoir
