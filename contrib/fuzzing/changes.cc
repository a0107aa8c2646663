// SPDX-License-Identifier: LGPL-2.1-or-later
#include "changes.h"

#include <algorithm>
#include <cctype>

namespace Fuzzing
{
namespace
{
/** What stands in the place of numbers and of single bytes. */
const std::vector<std::string> numbers = {
    "0",   "-1",         "1e308", "-1e-320",
    "nan", "inf",        "1e5",   "0.5;",
    "",    "4294967296", "1/0",   "-0",
    "1 2", "\"",         "{",     "99999999999999999999"};

bool is_of_number(const char c)
{
  return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.' ||
         c == '-';
}

/** The place of the next character for which a test holds; or the end. */
template <typename Test>
std::size_t
next_place(const std::string &text, const std::size_t from, const Test &test)
{
  return std::find_if(text.begin() + from, text.end(), test) - text.begin();
}
} // namespace

Changes::Changes(const std::vector<std::string> &seeds,
                 const unsigned int number)
    : seeds(seeds), random(number)
{}

std::size_t Changes::any_below(const std::size_t n)
{
  return n == 0 ? 0 : random() % n; // the same with every library
}

const std::string &Changes::any_of(const std::vector<std::string> &texts)
{
  return texts[any_below(texts.size())];
}

void Changes::change(std::string &input)
{
  const std::size_t place = any_below(input.size() + 1);
  constexpr std::size_t longest_part = 64;
  const std::size_t n =
      std::min(1 + any_below(longest_part), input.size() - place);
  const auto is_end = [](const char c) { return c == '\n'; };
  switch (any_below(8))
  {
  case 0: // a bit
    if (place < input.size())
      input[place] = static_cast<char>(input[place] ^ (1 << any_below(8)));
    break;
  case 1: // a part is left out
    input.erase(place, n);
    break;
  case 2: // is doubled
    input.insert(place, input.substr(place, n));
    break;
  case 3: // the rest is that of another
  {
    const std::string &other = any_of(seeds);
    input = input.substr(0, place) + other.substr(any_below(other.size() + 1));
    break;
  }
  case 4: // or is missing
    input.resize(place);
    break;
  case 5: // a number
  {
    const std::size_t begin = next_place(input, place, is_of_number);
    const std::size_t end =
        next_place(input, begin, [](const char c) { return !is_of_number(c); });
    input.replace(begin, end - begin, any_of(numbers));
    break;
  }
  case 6: // a line is left out
    input.erase(place, next_place(input, place, is_end) - place);
    break;
  default: // a part of another is put in
  {
    const std::string &other = any_of(seeds);
    const std::size_t from = any_below(other.size() + 1);
    input.insert(place, other.substr(from, n));
  }
  }
}

std::string Changes::next()
{
  constexpr std::size_t most_changes = 4, longest = 8000;
  std::string input = any_of(seeds);
  for (std::size_t k = any_below(most_changes) + 1; k > 0; --k)
    change(input);
  input.resize(std::min(input.size(), longest));
  return input;
}
} // namespace Fuzzing
