// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_command_line_arguments_h
#define voussoir_run_command_line_arguments_h

#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/** What the command line says; the options as --help explains them. */
struct Arguments
{
  /** The file of parameters; empty if none is named. */
  std::string file;
  /** --set, and --verbosity as an assignment. */
  std::vector<std::string> assignments;
  /** --sweep. */
  std::vector<std::string> sweeps;
  /** --find. */
  std::string find;
  /** --result. */
  std::vector<std::string> results;
  /** --directories. */
  bool has_directories = false;
  /** --critical. */
  bool writes_critical = false;
  /** --validate. */
  bool validate = false;
  /** --resume. */
  bool resumes = false;
  /** --reproduce: a summary.json; empty if that is not asked for. */
  std::string reproduced;
  /** --check: directories of results. */
  std::vector<std::string> checked;
  /** --print-parameters: the section to print; empty for all parameters. */
  std::optional<std::string> print_parameters;
  /** --print-settings. */
  bool print_settings = false;
  /** --as. */
  std::optional<std::string> format;
  /** --print-schema. */
  bool print_schema = false;
  /** --print-reference. */
  bool print_reference = false;
  /** --print-completion. */
  bool print_completion = false;
  /** --quiet. */
  bool quiet = false;
  /** --help. */
  bool help = false;
  /** --version. */
  bool version = false;
};

/**
 * @param words behind the name of the program.
 * @throws InputError if they are not valid.
 */
Arguments arguments_of(const std::vector<std::string> &words);

/** What --help prints. */
std::string help();

/** All options, such as "--set". */
std::vector<std::string> option_names();
} // namespace Voussoir

#endif
