// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/output/result_directory.h>
#include <voussoir/terminal/interruption.h>

#include <deal.II/base/exceptions.h>

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

namespace Voussoir
{
namespace fs = std::filesystem;

namespace
{
/** How often a directory is made, if others that make and remove it interfere.
 */
constexpr unsigned int n_trials = 100;

/** What the names of directories for files that are not complete begin with. */
const std::string aside = ".voussoir-";

bool contains(const std::vector<std::string> &names, const std::string &name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}
} // namespace

ResultDirectory::ResultDirectory(fs::path directory_in,
                                 FilesOfRuns all_files_in,
                                 Terminal &terminal)
    : directory(std::move(directory_in)), all_files(std::move(all_files_in)),
      terminal(terminal)
{
  if (directory.empty())
    throw InputError("'Output directory' is empty; name a directory.");
  fs::path existing = fs::absolute(directory);
  fs::file_status status = fs::status(existing);
  for (; !fs::exists(status) && existing.has_relative_path();
       status = fs::status(existing))
    existing = existing.parent_path();
  if (!fs::is_directory(status))
    refuse("'" + existing.string() + "' is not a directory");
  Uninterrupted whole;
  whole.state("nothing was written, and '" + directory.string() +
              (fs::exists(directory) ? "' is as it was." : "' was not made."));
  make_staging(whole);
  discard();
  whole.on_interruption({});
}

void ResultDirectory::protect(const fs::path &input) const
{
  std::error_code ignored;
  for (const auto *names : {&all_files.results, &all_files.packings})
    for (const std::string &name : *names)
      if (fs::equivalent(input, directory / name, ignored))
        throw InputError("The results may overwrite '" + input.string() +
                         "', which the packing is made from; copy it to "
                         "another place, or change 'Output directory'.");
}

ResultDirectory::~ResultDirectory()
{
  if (staging.empty() && created.empty())
    return;
  Uninterrupted whole;
  discard();
  whole.on_interruption({});
}

bool ResultDirectory::is_result(const std::string &name) const
{
  return contains(all_files.results, name) ||
         (all_files.is_piece && all_files.is_piece(name));
}

void ResultDirectory::make_staging(Uninterrupted &whole)
{
  std::error_code error = try_to_make_staging();
  // Another run may have removed a directory that it had made, and this one had
  // found.
  for (unsigned int k = 1;
       error == std::errc::no_such_file_or_directory && k < n_trials; ++k)
    error = try_to_make_staging();
  if (error)
    refuse(error.message());
  whole.on_interruption([this] { discard(); });
}

std::error_code ResultDirectory::try_to_make_staging()
{
  std::error_code error;
  for (fs::path missing = fs::absolute(directory); !fs::exists(missing, error);
       missing = missing.parent_path())
    created.push_back(missing);
  fs::create_directories(directory, error);
  std::string path = fs::absolute(directory / (aside + "XXXXXX")).string();
  if (!error && mkdtemp(path.data()) == nullptr)
    error.assign(errno, std::generic_category());
  if (error)
    discard();
  else
    staging = path;
  return error;
}

void ResultDirectory::discard()
{
  std::error_code ignored;
  if (!staging.empty())
    fs::remove_all(staging, ignored);
  staging.clear();
  // Innermost first; what is not empty by now stays.
  for (const fs::path &path : created)
    fs::remove(path, ignored);
  created.clear();
}

void ResultDirectory::write(const std::string &name,
                            const std::function<void(std::ostream &)> &writer)
{
  Assert(is_result(name) || contains(all_files.packings, name),
         dealii::ExcInternalError());
  std::ofstream out;
  {
    // No file may appear where an interruption is removing all of them.
    Uninterrupted whole;
    if (staging.empty())
      make_staging(whole);
    errno = 0;
    out.open(staging / name);
  }
  terminal.progress("writing " + name);
  writer(out);
  out.close();
  if (!out)
    refuse("writing " + name + " failed" +
           (errno != 0 ? std::string(": ") + std::strerror(errno) : ""));
  written.push_back(name);
}

fs::path ResultDirectory::place_for(const std::string &name)
{
  Assert(is_result(name), dealii::ExcInternalError());
  Uninterrupted whole;
  if (staging.empty())
    make_staging(whole);
  written.push_back(name);
  return staging / name;
}

void ResultDirectory::put_in_place()
{
  std::error_code error;
  for (const std::string &name : written)
    if (fs::is_directory(directory / name, error))
      refuse("'" + name + "' there is a directory");
  // What is there is kept until all is in place, or else comes back.
  const fs::path before = staging / "before";
  fs::create_directory(before, error);
  std::size_t n = 0;
  for (; n < written.size() && !error; ++n)
  {
    const fs::path place = directory / written[n];
    std::error_code not_linked;
    if (fs::exists(place, not_linked))
      fs::create_hard_link(place, before / written[n], not_linked);
    if (not_linked) // a file system without links
      fs::rename(place, before / written[n], error);
    if (!error)
      fs::rename(staging / written[n], place, error);
  }
  if (!error)
    return;
  std::error_code ignored;
  for (std::size_t k = 0; k < n; ++k)
    if (fs::exists(before / written[k], ignored))
      fs::rename(before / written[k], directory / written[k], ignored);
    else if (!fs::exists(staging / written[k], ignored))
      fs::remove(directory / written[k], ignored);
  refuse(error.message());
}

void ResultDirectory::finish(Uninterrupted &whole)
{
  written.clear();
  created.clear();
  discard();
  whole.on_interruption({});
  whole.state("the results in '" + directory.string() + "' are complete.");
}

void ResultDirectory::publish()
{
  Uninterrupted whole;
  put_in_place();
  std::error_code error;
  std::vector<fs::path> outdated;
  for (const auto &entry : fs::directory_iterator(directory, error))
  {
    const std::string name = entry.path().filename();
    if (is_result(name) && !contains(written, name))
      outdated.push_back(entry);
  }
  for (const fs::path &path : outdated)
    fs::remove(path, error);
  finish(whole);
}

void ResultDirectory::publish_beside()
{
  Uninterrupted whole;
  put_in_place();
  finish(whole);
}

void ResultDirectory::refuse(const std::string &reason) const
{
  throw InputError("The output directory '" + directory.string() +
                   "' cannot take the results: " + reason +
                   ". Change 'Output directory'.");
}

void remove_left_over(const fs::path &directory)
{
  std::error_code ignored;
  std::vector<fs::path> left_over;
  for (const fs::directory_entry &entry :
       fs::directory_iterator(directory, ignored))
    if (boost::starts_with(entry.path().filename().string(), aside))
      left_over.push_back(entry.path());
  for (const fs::path &path : left_over)
    fs::remove_all(path, ignored);
}
} // namespace Voussoir
