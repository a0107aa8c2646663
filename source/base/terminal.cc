// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/terminal.h>

#include <iomanip>
#include <ostream>

namespace Voussoir
{
namespace
{
constexpr auto progress_interval = std::chrono::seconds(2);
constexpr int name_width = 14;
} // namespace

Terminal::Terminal(std::ostream &out, const unsigned int verbosity)
    : out(out), level(verbosity), last_line(std::chrono::steady_clock::now())
{
}

void Terminal::set_verbosity(const unsigned int verbosity)
{
  level = verbosity;
}

unsigned int Terminal::verbosity() const
{
  return level;
}

void Terminal::stage(const std::string &name, const std::string &found)
{
  if (level >= 1)
    line(name, found);
}

void Terminal::progress(const std::string &name, const std::string &state)
{
  if (level >= 1 &&
      std::chrono::steady_clock::now() - last_line >= progress_interval)
    line("  " + name, state);
}

void Terminal::warning(const std::string &message)
{
  line("Warning", message);
}

void Terminal::summary(const std::string &name, const std::string &value)
{
  line(name, value);
}

void Terminal::line(const std::string &name, const std::string &text)
{
  out << std::left << std::setw(name_width) << name << ' ' << text << std::endl;
  last_line = std::chrono::steady_clock::now();
}
} // namespace Voussoir
