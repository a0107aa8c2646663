// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_terminal_h
#define voussoir_base_terminal_h

#include <chrono>
#include <iosfwd>
#include <string>

namespace Voussoir
{
/**
 * What the user sees while a scene runs.
 *
 * Verbosity 0 shows the closing summary alone, 1 adds a line per stage and a
 * progress line every few seconds of a long stage, 2 adds the iterations of
 * the solvers.
 */
class Terminal
{
public:
  explicit Terminal(std::ostream &out, unsigned int verbosity = 1);

  void set_verbosity(unsigned int verbosity);
  unsigned int verbosity() const;

  /** Say what a stage found, once it has ended. Shown from verbosity 1. */
  void stage(const std::string &name, const std::string &found);

  /**
   * Say how far a long stage has come. Shown from verbosity 1, and at most once
   * every two seconds since the last line of any kind.
   */
  void progress(const std::string &name, const std::string &state);

  /** Something unexpected that did not stop the run. Always shown. */
  void warning(const std::string &message);

  /** A line of the closing summary. Always shown. */
  void summary(const std::string &name, const std::string &value);

private:
  void line(const std::string &name, const std::string &text);

  std::ostream &out;
  unsigned int level;
  std::chrono::steady_clock::time_point last_line;
};
} // namespace Voussoir

#endif
