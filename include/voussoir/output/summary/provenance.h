// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_summary_provenance_h
#define voussoir_output_summary_provenance_h

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace Voussoir
{
/** The member of summary.json that has what results were made of. */
inline const std::string provenance_key = "provenance";

/** What the results of a run were made of. */
struct Origin
{
  /** A command that makes them; empty if no file has the parameters. */
  std::string command;
  /** True if blocks were given by Python, so that nothing else has them. */
  bool has_given_blocks = false;
  /** Where paths of the parameters begin. */
  std::filesystem::path directory;
  /** All parameters but those of the output, as a text. */
  std::string parameters;
  /** The files that they name. */
  std::vector<std::filesystem::path> files;
};

/**
 * What tells the results of a run from those of another: the command, the names
 * of the contents of its parameters and files, the commit that the program was
 * built of, and the processor's kernel and the threads that numbers depend on.
 *
 * @param origin what they are made of.
 * @param results the directory of the results, from which paths are given; with
 *   none of an empty one.
 */
nlohmann::ordered_json provenance_of(const Origin &origin,
                                     const std::filesystem::path &results);

/**
 * What the way of a computation depends on: the contents of parameters and
 * files, the commit, the kernel and the threads.
 */
nlohmann::ordered_json identity_of(const nlohmann::ordered_json &provenance);
} // namespace Voussoir

#endif
