// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_terminal_screen_h
#define voussoir_terminal_screen_h

#include <string>

namespace Voussoir
{
/**
 * The abilities of the device that a stream writes to; by default only to take
 * one line after the other, as a file does.
 */
struct Screen
{
  /** True if a line can be written over. */
  bool overwrites = false;
  /** True if text can be coloured. */
  bool colours = false;
  /** Characters in a line, if lines can be written over. */
  unsigned int width = 80;

  /** @p text in colour or, if there are none, as it is. */
  std::string good(const std::string &text) const { return in("32", text); }
  /** @p text in the colour of warnings. */
  std::string doubtful(const std::string &text) const { return in("33", text); }
  /** @p text in the colour of errors. */
  std::string bad(const std::string &text) const { return in("31", text); }

private:
  /** By the escape sequence (ECMA-48, SGR) of @p colour. */
  std::string in(const std::string &colour, const std::string &text) const
  {
    return colours ? "\033[" + colour + "m" + text + "\033[0m" : text;
  }
};

/** Back to the beginning of the line, which is cleared. */
extern const char *const clear_line;

/**
 * The screen behind an open file: a terminal, unless TERM is "dumb", with
 * colours unless NO_COLOR is set; or none.
 */
Screen screen_behind(int file_descriptor);
} // namespace Voussoir

#endif
