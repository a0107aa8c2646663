// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/blas.h>
#include <voussoir/base/content_name.h>
#include <voussoir/base/text_file.h>
#include <voussoir/output/summary/provenance.h>
#include <voussoir/output/summary/versions.h>

#include <deal.II/base/multithread_info.h>

#include <optional>

namespace Voussoir
{
namespace
{
/** Null if it cannot be read, which who needs it says. */
nlohmann::ordered_json name_of_file(const std::filesystem::path &file)
{
  const std::optional<std::string> content = bytes_of_file(file);
  return content ? nlohmann::ordered_json(name_of_content(*content))
                 : nlohmann::ordered_json();
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
    files[from_results(file)] = name_of_file(file);
  nlohmann::ordered_json provenance;
  if (origin.has_given_blocks)
    provenance["given_blocks"] = true;
  provenance.update({{"command", origin.command},
                     {"directory", from_results(origin.directory)},
                     {"parameters", name_of_content(origin.parameters)},
                     {"files", files},
                     {"commit", commit()},
                     {"kernel", blas_kernel()},
                     {"threads", dealii::MultithreadInfo::n_threads()}});
  return provenance;
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
