// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/printable.h>
#include <voussoir/terminal/terminal.h>

#include <iomanip>
#include <ostream>
#include <sstream>
#include <system_error>

namespace Voussoir
{
constexpr int name_width = 14;

Terminal::Terminal(std::ostream &out,
                   const unsigned int verbosity,
                   const Screen &screen)
    : out(out), screen(screen), level(verbosity)
{}

Terminal &Terminal::silent()
{
  static std::ostream nowhere(nullptr);
  static Terminal terminal(nowhere, 0);
  return terminal;
}

void Terminal::begin(const std::string &name)
{
  // Not beside the iterations, which Ipopt writes by itself.
  if (!screen.overwrites || verbosity() != 1)
    return;
  try
  {
    if (!in_progress)
      in_progress = std::make_unique<ProgressLine>(out, screen);
    in_progress->begin(name);
  }
  catch (const std::system_error &)
  {
    // Without another thread the run goes on as on no screen.
  }
}

void Terminal::stage(const std::string &name, const std::string &found)
{
  if (in_progress)
    in_progress->end();
  if (verbosity() >= 1)
    line(name, printable(found));
}

void Terminal::iteration(const std::string &solver, const std::string &state)
{
  if (verbosity() >= 2)
    line("  " + solver, state);
  else
    progress(state);
}

void Terminal::warning(const std::string &message)
{
  if (out.rdbuf() != nullptr)
    warned.push_back(message);
  // Padded here, since the width of a colour is not that of its characters.
  const std::string name = "Warning";
  line(screen.doubtful(name) + std::string(name_width - name.size(), ' '),
       printable(message));
}

void Terminal::summary(const std::string &name, const std::string &value)
{
  if (in_progress)
    in_progress->end();
  if (!quiet)
    line(name, value);
}

void Terminal::line(const std::string &name, const std::string &text)
{
  std::ostringstream words;
  words << std::left << std::setw(name_width) << name << ' ' << text << '\n';
  if (in_progress)
    in_progress->write(words.str());
  else
    out << words.str() << std::flush;
}
} // namespace Voussoir
