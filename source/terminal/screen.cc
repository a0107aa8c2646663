// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/terminal/screen.h>

#include <cstdlib>
#include <sys/ioctl.h>
#include <unistd.h>

namespace Voussoir
{
namespace
{
/** The value of a variable of the environment; empty if it is not there. */
std::string environment(const char *name)
{
  const char *value = std::getenv(name);
  return value == nullptr ? "" : value;
}
} // namespace

const char *const clear_line = "\r\033[K";

Screen screen_behind(const int file_descriptor)
{
  Screen screen;
  const std::string term = environment("TERM");
  screen.overwrites =
      isatty(file_descriptor) == 1 && !term.empty() && term != "dumb";
  screen.colours = screen.overwrites && environment("NO_COLOR").empty();
  winsize size = {};
  if (screen.overwrites && ioctl(file_descriptor, TIOCGWINSZ, &size) == 0 &&
      size.ws_col > 0)
    screen.width = size.ws_col;
  return screen;
}
} // namespace Voussoir
