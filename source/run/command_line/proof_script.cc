// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/shell_word.h>
#include <voussoir/run/command_line/proof_script.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <sys/wait.h>

namespace Voussoir
{
namespace
{
namespace fs = std::filesystem;

/** Where it is installed, or else beside what is built. */
fs::path proof_script()
{
  const fs::path program = fs::canonical("/proc/self/exe").parent_path();
  for (const char *const place : {"../share/voussoir", "share/voussoir"})
    if (const fs::path script = program / place / "check_proof";
        fs::exists(script))
      return script;
  throw InputError("--check runs the script check_proof, which is not in '" +
                   (program / "../share/voussoir").lexically_normal().string() +
                   "'. Install the program with its files, or run "
                   "contrib/check_proof of its source.");
}
} // namespace

bool prove_again(const std::vector<std::string> &directories,
                 const std::function<void(const std::string &line)> &take)
{
  std::string command = "python3 " + shell_word(proof_script().string());
  for (const std::string &directory : directories)
    command += ' ' + shell_word(directory);
  FILE *const output = popen(command.c_str(), "r");
  int status = -1;
  if (output != nullptr)
  {
    std::string line;
    for (int letter = 0; (letter = std::getc(output)) != EOF;)
      if (letter != '\n')
        line += static_cast<char>(letter);
      else
      {
        take(line);
        line.clear();
      }
    status = pclose(output);
  }
  constexpr int proven = 0, not_proven = 1;
  const int answer = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  if (answer != proven && answer != not_proven)
    throw InputError("--check runs a script of Python, which did not run to "
                     "its end: see what it said. Install Debian's python3 "
                     "if it is missing.");
  return answer == proven;
}
} // namespace Voussoir
