// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/shell_word.h>

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cctype>
#include <cstring>

namespace Voussoir
{
std::string shell_word(const std::string &text)
{
  const auto needs_no_quotes = [](const char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::strchr("/._-=+:,", c) != nullptr;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), needs_no_quotes))
    return text;
  return "'" + boost::replace_all_copy(text, "'", "'\\''") + "'";
}
} // namespace Voussoir
