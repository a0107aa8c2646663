// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/base/text_file.h>
#include <voussoir/output/summary/provenance.h>
#include <voussoir/output/summary/summary.h>
#include <voussoir/run/make_run.h>
#include <voussoir/run/output_entries.h>
#include <voussoir/run/reproduction.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace Voussoir
{
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace
{
/** Seconds after which it makes no checkpoint that nobody could go on from. */
const std::string never = "1e300";

/** A directory that is removed with all that is in it. */
struct TemporaryDirectory
{
  TemporaryDirectory()
  {
    std::string name = (fs::temp_directory_path() / "voussoir-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw InputError("No directory can be made in '" +
                       fs::temp_directory_path().string() +
                       "'; set TMPDIR to one that can be written to.");
    path = name;
  }
  TemporaryDirectory(const TemporaryDirectory &) = delete;
  TemporaryDirectory &operator=(const TemporaryDirectory &) = delete;
  ~TemporaryDirectory()
  {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }

  fs::path path;
};

/** The results that are there. */
class MadeBefore
{
public:
  explicit MadeBefore(const fs::path &file) : file(file)
  {
    std::ifstream in(file);
    if (!in || fs::is_directory(file))
      refuse("cannot be read");
    try
    {
      summary = Json::parse(in);
      const Json &of = summary.at(provenance_key);
      if (of.contains("given_blocks"))
        refuse("is of blocks that Python has given, which no file has");
      origin = (directory() / of.at("directory").get<std::string>())
                   .lexically_normal();
      content_of_parameters = of.at("parameters");
      for (const auto &[name, content] : of.at("files").items())
        files.emplace_back((directory() / name).lexically_normal(), content);
    }
    catch (const Json::exception &error)
    {
      refuse(std::string("does not say what the results are made of (") +
             error.what() + ")");
    }
  }

  /** Of the results. */
  fs::path directory() const { return file.parent_path(); }

  /** @throws InputError unless all files are there. */
  void check_files() const
  {
    for (const auto &[path, content] : files)
      if (!fs::exists(path))
        throw InputError("The results of '" + file.string() +
                         "' are made of '" + path.string() +
                         "', which is not there; bring it back, or run the "
                         "scene itself.");
  }

  /** @throws InputError unless the input is still what it was. */
  void check(const Json &now) const
  {
    for (const auto &[path, content] : files)
      if (const Json &names = now.at("files");
          std::find(names.begin(), names.end(), content) == names.end())
        throw InputError("The file '" + path.string() +
                         "' is not the one that the results of '" +
                         file.string() +
                         "' are made of; bring that back, or "
                         "run the scene itself.");
    if (now.at("parameters") != content_of_parameters)
      throw InputError("'" + (directory() / parameters_prm).string() +
                       "' is not the file that was written with '" +
                       file.string() +
                       "': its entries differ; bring it back, or run the "
                       "scene itself.");
  }

  /** As it is in the file. */
  Json summary;
  /** Where paths of the parameters begin. */
  fs::path origin;

private:
  [[noreturn]] void refuse(const std::string &fault) const
  {
    throw InputError("'" + file.string() + "' " + fault +
                     "; name the summary.json that a run of this version has "
                     "written.");
  }

  const fs::path file;
  std::string content_of_parameters;
  std::vector<std::pair<fs::path, std::string>> files;
};

/** Whether it is told of in a summary how, and not what, was found. */
bool is_of_machine(const std::string &place)
{
  for (const std::string &name :
       {std::string("timings"), provenance_key, std::string("versions"),
        std::string("processes")})
    if (boost::starts_with(place, '/' + name))
      return true;
  return boost::contains(place, "seconds");
}

/** What differs in two summaries. */
struct Differences
{
  /** The numbers of members that are in both, or in one. */
  unsigned int n_members = 0, n_different = 0;
  /** The largest difference of numbers over the larger. */
  double largest = 0.;
  /** Where it is, or where there are other words or members. */
  std::string place;
};

Differences differences_of(const Json &before, const Json &now)
{
  const Json one = before.flatten(), other = now.flatten();
  Differences found;
  const auto differ = [&](const std::string &place, const double by) {
    ++found.n_different;
    if (by > found.largest || found.place.empty())
    {
      found.largest = std::max(found.largest, by);
      found.place = place.substr(1);
    }
  };
  constexpr double altogether = std::numeric_limits<double>::infinity();
  for (const auto &[place, value] : one.items())
    if (!is_of_machine(place))
    {
      ++found.n_members;
      if (!other.contains(place))
        differ(place, altogether);
      else if (const Json &there = other.at(place); value != there)
      {
        const bool are_numbers = value.is_number() && there.is_number();
        const double a = are_numbers ? value.get<double>() : 0.;
        const double b = are_numbers ? there.get<double>() : 0.;
        differ(place, are_numbers
                          ? std::abs(a - b) / std::max(std::abs(a), std::abs(b))
                          : altogether);
      }
    }
  for (const auto &[place, value] : other.items())
    if (!is_of_machine(place) && !one.contains(place))
    {
      ++found.n_members;
      differ(place, altogether);
    }
  return found;
}

/** The end of load factors that a summary gives a number; or else infinity. */
double end_of_factor(const Json &factor, const std::string &name)
{
  const Json end = factor.value(name, Json());
  return end.is_number() ? end.get<double>()
                         : std::numeric_limits<double>::infinity();
}

/** Whether both have the same status, and load factors that may be the same. */
bool have_same_answer(const Json &before, const Json &now)
{
  if (before.at("status") != now.at("status"))
    return false;
  const Json factor = before.value("load_factor", Json::object()),
             other = now.value("load_factor", Json::object());
  if (factor.empty() != other.empty() ||
      factor.value("unbounded", false) != other.value("unbounded", false))
    return false;
  // Without a bound only what is carried can be compared.
  const double a = end_of_factor(factor, "carried"),
               b = end_of_factor(factor, "bound"),
               c = end_of_factor(other, "carried"),
               d = end_of_factor(other, "bound");
  if (!std::isfinite(a + b + c + d))
    return std::isfinite(a) == std::isfinite(c) &&
           std::isfinite(b) == std::isfinite(d);
  constexpr double rounding = 1e-12;
  const double slack = rounding * std::max(std::abs(a), std::abs(c));
  return std::min(a, b) <= std::max(c, d) + slack &&
         std::min(c, d) <= std::max(a, b) + slack;
}

/** The names of the tables in a directory. */
std::set<std::string> tables_in(const fs::path &directory)
{
  std::set<std::string> names;
  const std::vector<std::string> results = files_of_all_runs().results;
  for (const std::string &name : results)
    if (fs::path(name).extension() == ".csv" && fs::exists(directory / name))
      names.insert(name);
  return names;
}

/** Show which tables differ, or are in one of the directories alone. */
void compare_tables(const fs::path &before,
                    const fs::path &now,
                    Terminal &terminal)
{
  std::set<std::string> names = tables_in(before);
  names.merge(tables_in(now));
  std::vector<std::string> different;
  for (const std::string &name : names)
    if (const auto one = bytes_of_file(before / name),
        other = bytes_of_file(now / name);
        !one || !other || *one != *other)
      different.push_back(name);
  if (different.empty())
    terminal.summary("Tables",
                     text(names.size(), ", the same to the last byte"));
  else
    terminal.summary("Tables", boost::algorithm::join(different, ", ") +
                                   " differ, of " +
                                   std::to_string(names.size()));
}

/** Show where and by what the results were made, if that is another way now. */
void compare_machines(const Json &before, const Json &now, Terminal &terminal)
{
  const auto value = [](const Json &summary, const std::string &section,
                        const std::string &name) {
    const Json of = summary.value(section, Json::object());
    return of.contains(name) ? of.at(name).dump() : "none";
  };
  const auto compare = [&](const std::string &section, const std::string &name,
                           const std::string &words) {
    const std::string a = value(before, section, name),
                      b = value(now, section, name);
    if (a != b)
      terminal.summary("Made with", words + ' ' + a + ", now with " + b);
  };
  compare(provenance_key, "commit", "the commit");
  compare(provenance_key, "kernel", "the kernel");
  compare(provenance_key, "threads", "threads:");
  const Json versions = now.value("versions", Json::object());
  for (const auto &[name, version] : versions.items())
    compare("versions", name, name);
}
} // namespace

bool reproduce(const fs::path &file,
               Terminal &terminal,
               const ProcessGroup &processes)
{
  const MadeBefore results(file);
  results.check_files();
  const TemporaryDirectory temporary;
  const fs::path again = temporary.path / "again";
  const std::unique_ptr<Run> run =
      make_run({results.directory() / parameters_prm,
                {},
                {"Output directory=" + again.string(),
                 "Output/Checkpoint after=" + never}},
               Terminal::silent(), processes);
  terminal.set_verbosity(run->verbosity());
  results.check(run->provenance(results.origin, results.directory()));
  terminal.begin("Run");
  run->carry_out(results.origin, true);
  terminal.stage("Run",
                 "the results of '" + file.string() + "' are made again");
  std::ifstream in(again / summary_json);
  const Json now = Json::parse(in);

  const Differences differences = differences_of(results.summary, now);
  const bool is_same = have_same_answer(results.summary, now);
  terminal.summary("Reproduced",
                   is_same ? "the answer is the same" : "ANOTHER ANSWER");
  terminal.summary(
      "Summary",
      differences.n_different == 0
          ? text(differences.n_members, " members, the same to the last digit")
          : text(differences.n_different, " of ", differences.n_members,
                 " members differ, most '", differences.place, "'",
                 std::isfinite(differences.largest)
                     ? text(", by ", differences.largest, " of it")
                     : ""));
  compare_tables(results.directory(), again, terminal);
  compare_machines(results.summary, now, terminal);
  return is_same;
}
} // namespace Voussoir
