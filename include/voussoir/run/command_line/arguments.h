// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_command_line_arguments_h
#define voussoir_run_command_line_arguments_h

#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/** What the command line says. */
struct Arguments
{
  std::string file;
  std::vector<std::string> assignments;
  std::vector<std::string> sweeps;
  std::string find;
  std::vector<std::string> results;
  bool has_directories = false;
  bool validate = false;
  /** The section to print; empty for all parameters. */
  std::optional<std::string> print_parameters;
  bool print_settings = false;
  std::string format = "prm";
  bool print_schema = false;
  bool print_reference = false;
  bool print_completion = false;
  bool quiet = false;
  bool help = false;
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
