// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_terminal_terminal_h
#define voussoir_terminal_terminal_h

#include <voussoir/terminal/progress_line.h>
#include <voussoir/terminal/screen.h>

#include <cstddef>
#include <iosfwd>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
/**
 * The output that the user sees while a scene runs.
 *
 * Verbosity 0 shows the closing summary alone, 1 adds a line per stage and, on
 * a screen, how far a stage of more than two seconds has come, 2 adds the
 * iterations of the solvers. Warnings are always shown.
 */
class Terminal
{
public:
  /** @param screen behind @p out. */
  explicit Terminal(std::ostream &out,
                    unsigned int verbosity = 1,
                    const Screen &screen = {});

  /** One that shows nothing, not even warnings. */
  static Terminal &silent();

  /** Show warnings alone from now on, whatever the verbosity. */
  void be_quiet() { quiet = true; }
  /** Show what belongs to this verbosity, 0 to 2. */
  void set_verbosity(const unsigned int verbosity) { level = verbosity; }
  /** The verbosity; 0 also of a quiet one. */
  unsigned int verbosity() const { return quiet ? 0 : level; }

  /** The stage @p name begins; it is in progress until stage() ends it. */
  void begin(const std::string &name);

  /** Report the result of a stage that has ended. Shown from verbosity 1. */
  void stage(const std::string &name, const std::string &found);

  /** Report the progress of the stage, on a screen. */
  void progress(const std::string &state)
  {
    if (in_progress)
      in_progress->say(state);
  }

  /** Report how many of @p total things are done, such as "cells". */
  void progress(const std::size_t done,
                const std::size_t total,
                const std::string &things)
  {
    if (in_progress)
      in_progress->count(done, total, things);
  }

  /** An iteration of a solver: a line of its own at verbosity 2. */
  void iteration(const std::string &solver, const std::string &state);

  /** Something unexpected that did not stop the run. Always shown. */
  void warning(const std::string &message);
  /** All of these, in their order; none of the silent one. */
  const std::vector<std::string> &warnings() const { return warned; }
  /** Hand over all warnings, of which none are kept. */
  std::vector<std::string> take_warnings() { return std::exchange(warned, {}); }

  /** A line of the closing summary. Shown unless quiet. */
  void summary(const std::string &name, const std::string &value);
  /** A line of it that is shown at verbosity 2 only. */
  void detail(const std::string &name, const std::string &value)
  {
    if (verbosity() >= 2)
      summary(name, value);
  }
  /** The first of them, in the colour of what is good or bad. */
  void status(const std::string &value, const bool is_good)
  {
    summary("Status", is_good ? screen.good(value) : screen.bad(value));
  }

private:
  void line(const std::string &name, const std::string &text);

  std::ostream &out;
  const Screen screen;
  unsigned int level;
  bool quiet = false;
  std::vector<std::string> warned;
  /** The line of progress; null before a stage and where none is shown. */
  std::unique_ptr<ProgressLine> in_progress;
};
} // namespace Voussoir

#endif
