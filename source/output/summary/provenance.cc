// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/blas.h>
#include <voussoir/base/content_name.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/output/summary/provenance.h>
#include <voussoir/output/summary/versions.h>

#include <deal.II/base/multithread_info.h>

#include <fstream>
#include <iterator>

namespace Voussoir
{
namespace
{
std::string content_of(const std::filesystem::path &file)
{
  std::ifstream in(file, std::ios::binary);
  std::string content((std::istreambuf_iterator<char>(in)), {});
  if (!in.is_open() || in.bad())
    throw InputError("The file '" + file.string() +
                     "', of which the results are made, cannot be read again; "
                     "was it moved or removed meanwhile?");
  return content;
}
} // namespace

nlohmann::ordered_json provenance_of(const Origin &origin,
                                     const std::filesystem::path &results)
{
  // Also if that directory is not there yet.
  using std::filesystem::absolute;
  const std::filesystem::path from = absolute(results.empty() ? "." : results);
  const auto from_results = [&](const std::filesystem::path &path) {
    return std::filesystem::proximate(absolute(path), from).generic_string();
  };
  nlohmann::ordered_json files = nlohmann::ordered_json::object();
  for (const std::filesystem::path &file : origin.files)
    files[from_results(file)] = name_of_content(content_of(file));
  return {{"command", origin.command},
          {"directory", from_results(origin.directory)},
          {"parameters", name_of_content(origin.parameters)},
          {"files", files},
          {"commit", commit()},
          {"kernel", blas_kernel()},
          {"threads", dealii::MultithreadInfo::n_threads()}};
}

nlohmann::ordered_json identity_of(const nlohmann::ordered_json &provenance)
{
  nlohmann::ordered_json identity;
  for (const char *const name :
       {"parameters", "files", "commit", "kernel", "threads"})
    identity[name] = provenance.at(name);
  return identity;
}
} // namespace Voussoir
