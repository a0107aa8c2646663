// SPDX-License-Identifier: LGPL-2.1-or-later

// What the terminal shows: progress with its rate and remaining time, on a
// screen only, in one line that is cleared; colours on a terminal only, and not
// if NO_COLOR is set; warnings only, if it is quiet.

#include "tests.h"
#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <thread>
#include <unistd.h>

namespace test_terminal
{
using namespace Voussoir;

/** What a stage writes to @p screen that lasts for @p duration. */
std::string shown_on(const Screen &screen,
                     const std::chrono::milliseconds duration)
{
  std::ostringstream out;
  {
    ProgressLine line(out, screen, std::chrono::seconds(0),
                      std::chrono::milliseconds(1));
    line.begin("Stress");
    line.count(0, 1000, "cells");
    line.count(10, 1000, "cells");
    std::this_thread::sleep_for(duration);
    line.write("a warning\n");
    line.end();
  }
  return out.str();
}

/**
 * The same, so long that the line shows how many things were counted, on
 * however busy a machine.
 */
std::string shown_on(const Screen &screen)
{
  std::string shown;
  for (std::chrono::milliseconds duration(50);
       shown.find("10 of 10") == std::string::npos &&
       duration < std::chrono::seconds(20);
       duration *= 3)
    shown = shown_on(screen, duration);
  return shown;
}

/** All that a run may say, at verbosity 1. */
std::string said_by(Terminal &terminal, const std::ostringstream &out)
{
  terminal.begin("Packing");
  terminal.progress(1, 2, "cells");
  terminal.stage("Packing", "2 cells");
  terminal.iteration("Newton", "iteration 3");
  terminal.warning("one");
  terminal.status("solved", true);
  return out.str();
}

void run()
{
  // 100 of 400 in 2 s are 50 a second, and the other 300 take 6 s.
  Progress progress;
  progress.done = 100;
  progress.total = 400;
  progress.things = "cells";
  progress.counted_for = 2.;
  std::cout << text_of_progress(progress) << '\n';
  progress.done = 1;
  progress.counted_for = 300.;
  std::cout << text_of_progress(progress) << '\n';
  progress.total = 40;
  std::cout << text_of_progress(progress) << '\n';
  progress.since = 3600.; // an hour of which has passed since
  std::cout << text_of_progress(progress) << '\n';
  progress.done = 0; // no rate to go by
  progress.seconds = 62.;
  std::cout << text_of_progress(progress) << '\n';
  Progress uncounted;
  uncounted.seconds = 12.;
  std::cout << text_of_progress(uncounted) << '\n';
  uncounted.state = "iteration 7";
  std::cout << text_of_progress(uncounted) << '\n';

  Screen screen;
  screen.overwrites = screen.colours = true;
  std::string shown = shown_on(screen);
  check("progress is shown",
        shown.find(std::string(clear_line) + "  Stress: 10 of 1000 cells, ") !=
            std::string::npos);
  check("and cleared before a line",
        shown.find(std::string(clear_line) + "a warning\n") !=
            std::string::npos);
  const std::string last = shown.substr(shown.rfind("a warning\n") + 10);
  check("and at the end",
        last.empty() || last.substr(last.rfind('\r')) == clear_line);
  screen.width = 20;
  shown = shown_on(screen);
  check("not wider than the screen",
        shown.find(std::string(clear_line) + "  Stress: 10 of 100" +
                   clear_line) != std::string::npos);

  const auto terminal_says = [](const Screen &screen, const bool quiet) {
    std::ostringstream out;
    Terminal terminal(out, 1, screen);
    if (quiet)
      terminal.be_quiet();
    return said_by(terminal, out);
  };
  std::cout << terminal_says({}, false);
  check("quiet: the warning alone",
        terminal_says({}, true) == "Warning        one\n");
  screen.overwrites = false; // so that no thread writes
  const std::string coloured = terminal_says(screen, false);
  check("colours",
        coloured.find("\033[33mWarning\033[0m        one") !=
                std::string::npos &&
            coloured.find("\033[32msolved\033[0m\n") != std::string::npos);

  int controller, terminal;
  if (openpty(&controller, &terminal, nullptr, nullptr, nullptr) != 0)
    return check("a terminal can be opened", false);
  const winsize size = {24, 132, 0, 0};
  ioctl(terminal, TIOCSWINSZ, &size);
  setenv("TERM", "xterm", 1);
  unsetenv("NO_COLOR");
  check("a terminal", screen_behind(terminal).overwrites &&
                          screen_behind(terminal).colours &&
                          screen_behind(terminal).width == 132);
  setenv("NO_COLOR", "1", 1);
  check("NO_COLOR",
        screen_behind(terminal).overwrites && !screen_behind(terminal).colours);
  unsetenv("NO_COLOR");
  setenv("TERM", "dumb", 1);
  check("TERM=dumb", !screen_behind(terminal).overwrites &&
                         !screen_behind(terminal).colours);
  setenv("TERM", "xterm", 1);
  const int file = open("/dev/null", O_WRONLY);
  check("no terminal",
        !screen_behind(file).overwrites && !screen_behind(file).colours);
}

const RoomTest test("terminal", run);
} // namespace test_terminal
