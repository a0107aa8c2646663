// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/printable.h>

#include <boost/regex/pending/unicode_iterator.hpp>

#include <stdexcept>

namespace Voussoir
{
namespace
{
/** The bytes of a line, and of its beginning and end if it has more. */
constexpr std::size_t longest_line = 2000, longest_beginning = 1200,
                      longest_end = 600;

/** The last place up to @p k where a letter of UTF-8 begins. */
std::size_t begin_of_letter(const std::string &line, std::size_t k)
{
  while (k > 0 && (line[k] & 0xC0) == 0x80)
    --k;
  return k;
}

std::string without_middle(const std::string &line)
{
  return line.size() <= longest_line
             ? line
             : line.substr(0, begin_of_letter(line, longest_beginning)) +
                   " ... " +
                   line.substr(
                       begin_of_letter(line, line.size() - longest_end));
}
} // namespace

bool is_utf8(const std::string &text)
{
  using Iterator = boost::u8_to_u32_iterator<std::string::const_iterator>;
  try
  {
    Iterator letter(text.begin(), text.begin(), text.end());
    const Iterator end(text.end(), text.begin(), text.end());
    while (letter != end)
      ++letter;
  }
  catch (const std::out_of_range &)
  {
    return false;
  }
  return true;
}

bool is_control(const unsigned char letter)
{
  return letter < ' ' || letter == 0x7f;
}

std::string without_controls(const std::string &text, const std::string &kept)
{
  std::string shown = text;
  const bool is_readable = is_utf8(text);
  for (char &letter : shown)
    if ((is_control(letter) && kept.find(letter) == kept.npos) ||
        (!is_readable && (letter & 0x80) != 0))
      letter = '?';
  // The other control characters, from U+0080 to U+009F.
  constexpr char first_of_two = '\xC2';
  for (std::size_t k = 0; is_readable && k + 1 < shown.size(); ++k)
    if (shown[k] == first_of_two &&
        static_cast<unsigned char>(shown[k + 1]) < 0xA0)
      shown[k] = shown[k + 1] = '?';
  return shown;
}

std::string printable(const std::string &message)
{
  const std::string shown = without_controls(message, "\n\t");
  if (shown.size() <= longest_line)
    return shown;
  std::string lines;
  for (std::size_t begin = 0;;)
  {
    const std::size_t end = shown.find('\n', begin);
    lines += without_middle(shown.substr(begin, end - begin));
    if (end == shown.npos)
      return lines;
    lines += '\n';
    begin = end + 1;
  }
}
} // namespace Voussoir
