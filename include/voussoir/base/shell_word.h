// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_shell_word_h
#define voussoir_base_shell_word_h

#include <string>

namespace Voussoir
{
/** A text as one word for a shell. */
std::string shell_word(const std::string &text);
} // namespace Voussoir

#endif
