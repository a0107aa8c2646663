// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_parameters_pattern_description_h
#define voussoir_base_parameters_pattern_description_h

#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/** What an entry accepts, read from deal.II's description of its pattern. */
struct PatternDescription
{
  /** The kinds that entries have. */
  enum class Kind
  {
    text,      /**< any text */
    truth,     /**< true or false */
    number,    /**< a number */
    integer,   /**< a whole number */
    selection, /**< one of some words */
    list,      /**< values behind a separator */
    other      /**< what is not read */
  };

  Kind kind = Kind::other; /**< which of them */
  /** @{ */
  /** The bounds of numbers, or of the length of a list, if there are any. */
  std::optional<std::string> low, high;
  /** @} */
  /** The words of a selection. */
  std::vector<std::string> choices;
  /** What separates the values of a list. */
  std::string separator;
  /** The description of each of them. */
  std::string element;
};

/**
 * @param text such as "[Double 0...1 (inclusive)]"; what follows the last
 *   bracket, see with_uses(), does not count.
 */
PatternDescription read_pattern(const std::string &text);

/**
 * The values that an entry accepts, in words: "a number from 0 to 1". What
 * read_pattern() does not know is left as it is.
 */
std::string text_of_pattern(const std::string &text);
} // namespace Voussoir

#endif
