// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_tests_run_program_h
#define voussoir_tests_run_program_h

#include <voussoir/run/command_line/command_line.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

/** How the program ended, and what it has said. */
struct Ended
{
  int status;
  std::string out, error;

  /** "status 2 voussoir: ...". */
  std::string message() const
  {
    return "status " + std::to_string(status) + ' ' + error;
  }
};

/** Run the program with the arguments @p words. */
inline Ended run_program(const std::vector<std::string> &words)
{
  std::ostringstream out, error;
  const int status = Voussoir::run_command_line(words, out, error);
  return {status, out.str(), error.str()};
}

/** All of a file. */
inline std::string content_of(const std::string &file)
{
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

#endif
