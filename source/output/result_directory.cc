// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/output/result_directory.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace Voussoir
{
namespace fs = std::filesystem;

namespace
{
/** Every file that any run may write: its results, and the packing. */
const std::vector<std::string> all_result_files = {
    "interfaces.csv",       "cells.csv",      "interfaces.vtu",
    "stress.vtu",           "mechanism.csv",  "mechanism.vtu",
    "mechanism_joints.csv", "parameters.prm", "summary.json"};
const std::vector<std::string> all_packing_files = {
    "packing.wkt", "packing.off", "packing_centres.txt"};
} // namespace

ResultDirectory::ResultDirectory(fs::path directory_in)
    : directory(std::move(directory_in))
{
  if (directory.empty())
    throw InputError("'Output directory' is empty; name a directory.");
  fs::path existing = fs::absolute(directory);
  while (!fs::exists(existing) && existing.has_relative_path())
    existing = existing.parent_path();
  if (!fs::is_directory(existing))
    refuse("'" + existing.string() + "' is not a directory");
  if (access(existing.c_str(), W_OK | X_OK) != 0)
    refuse(std::strerror(errno));
}

void ResultDirectory::spare(const fs::path &input) const
{
  std::error_code ignored;
  for (const auto *names : {&all_result_files, &all_packing_files})
    for (const std::string &name : *names)
      if (fs::equivalent(input, directory / name, ignored))
        throw InputError("The results may overwrite '" + input.string() +
                         "', which the packing is made from; copy it to "
                         "another place, or change 'Output directory'.");
}

ResultDirectory::~ResultDirectory()
{
  std::error_code ignored;
  if (!staging.empty())
    fs::remove_all(staging, ignored);
}

void ResultDirectory::write(const std::string &name,
                            const std::function<void(std::ostream &)> &writer)
{
  if (staging.empty())
  {
    std::error_code error;
    fs::create_directories(directory, error);
    if (error)
      refuse(error.message());
    std::string path = (directory / ".voussoir-XXXXXX").string();
    if (mkdtemp(path.data()) == nullptr)
      refuse(std::strerror(errno));
    staging = path;
  }

  errno = 0;
  std::ofstream out(staging / name);
  writer(out);
  out.close();
  if (!out)
    refuse("writing " + name + " failed" +
           (errno != 0 ? std::string(": ") + std::strerror(errno) : ""));
  written.push_back(name);
}

void ResultDirectory::publish()
{
  std::error_code error;
  for (const std::string &name : written)
    if (fs::is_directory(directory / name, error))
      refuse("'" + name + "' there is a directory");
  for (const std::string &name : written)
  {
    fs::rename(staging / name, directory / name, error);
    if (error)
      refuse(error.message());
  }
  for (const std::string &name : all_result_files)
    if (std::find(written.begin(), written.end(), name) == written.end())
      fs::remove(directory / name, error);
  written.clear();
}

void ResultDirectory::refuse(const std::string &reason) const
{
  throw InputError("The output directory '" + directory.string() +
                   "' cannot take the results: " + reason +
                   ". Change 'Output directory'.");
}
} // namespace Voussoir
