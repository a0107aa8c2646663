// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_printable_h
#define voussoir_base_printable_h

#include <string>

namespace Voussoir
{
/** True if @p text is UTF-8, as ASCII is. */
bool is_utf8(const std::string &text);

/** True if a terminal may obey the letter rather than show it. */
bool is_control(unsigned char letter);

/**
 * A text with question marks for control characters, but for those @p kept, and
 * for the bytes above ASCII of a text that is not UTF-8.
 */
std::string without_controls(const std::string &text,
                             const std::string &kept = {});

/**
 * A message as it can be shown, whatever it quotes from a file or a command
 * line: control characters but tabs and ends of lines are question marks, and
 * so are the bytes above ASCII of a text that is not UTF-8; and a line of more
 * than 2000 bytes has dots in the place of its middle, as it begins with what
 * is wrong and where, and ends with what to do.
 */
std::string printable(const std::string &message);
} // namespace Voussoir

#endif
