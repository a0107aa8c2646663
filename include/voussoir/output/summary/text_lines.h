// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_summary_text_lines_h
#define voussoir_output_summary_text_lines_h

#include <charconv>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>
#include <type_traits>

namespace Voussoir
{
/**
 * A text that grows, in the C locale. A double is written with as many digits
 * as it takes to read the same double again, at most 17: 0.1, not
 * 0.10000000000000001. That loses nothing, and is several times as fast as a
 * stream.
 */
class TextLines
{
public:
  /** @{ */
  /** Append a text, a letter or a number. */
  TextLines &operator<<(const std::string_view text)
  {
    content.append(text);
    return *this;
  }

  TextLines &operator<<(const char letter)
  {
    content.push_back(letter);
    return *this;
  }

  template <typename Number,
            typename = std::enable_if_t<std::is_arithmetic_v<Number>>>
  TextLines &operator<<(const Number number)
  {
    char digits[longest_number];
    const auto end = std::to_chars(digits, digits + longest_number, number);
    content.append(digits, end.ptr);
    return *this;
  }
  /** @} */

  /** Append numbers or texts with a comma between each two. */
  template <typename First, typename... Others>
  TextLines &row(const First &first, const Others &...others)
  {
    *this << first;
    ((*this << ',' << others), ...);
    return *this;
  }

  /** All that was appended. */
  const std::string &text() const { return content; }

  /** Begin again, in the memory that there is. */
  void clear() { content.clear(); }

private:
  /** -1.7976931348623157e+308 has 24 letters. */
  static constexpr int longest_number = 32;

  std::string content;
};

/** The shortest text that is read as @p value again. */
inline std::string value_text(const double value)
{
  return (TextLines() << value).text();
}

/**
 * Write what @p lines appends for the numbers from begin to end - 1, which
 * follow on each other from 0 to @p n - 1. It is called by all threads at a
 * time.
 */
void write_pieces(
    std::ostream &out,
    unsigned int n,
    const std::function<void(TextLines &, unsigned int begin, unsigned int end)>
        &lines);

/** Write lines by what @p line appends for one number. */
void write_lines(std::ostream &out,
                 unsigned int n,
                 const std::function<void(TextLines &, unsigned int)> &line);
} // namespace Voussoir

#endif
