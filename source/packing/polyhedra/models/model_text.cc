// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/decimal_comma.h>
#include <voussoir/base/text.h>
#include <voussoir/base/text_file.h>
#include <voussoir/packing/polyhedra/models/model_text.h>

#include <boost/algorithm/string/predicate.hpp>

#include <charconv>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>

namespace Voussoir
{
namespace
{
[[noreturn]] void refuse_unreadable_model(const std::filesystem::path &file)
{
  throw InputError("The file of blocks '" + file.string() +
                   "' cannot be read. Paths in a .prm file start at the "
                   "directory of that file.");
}

/** The number that a whole word is; infinite if it is too large for one. */
std::optional<double> number_of_word(std::string_view word)
{
  if (word.size() > 1 && word[0] == '+' && word[1] != '-')
    word.remove_prefix(1);
  double value = 0.;
  const char *const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument)
    return {};
  if (error == std::errc::result_out_of_range)
    // Of what is too small for a number nothing is left.
    return word.find("e-") != word.npos || word.find("E-") != word.npos
               ? 0.
               : std::numeric_limits<double>::infinity();
  return value;
}
} // namespace

ModelText::ModelText(const std::filesystem::path &file,
                     const std::string &format)
    : file(file), format(format)
{
  std::optional<std::string> text = read_text_file(file);
  if (!text)
    refuse_unreadable_model(file);
  content = std::move(*text);
}

bool ModelText::next_line()
{
  constexpr std::string_view blanks = " \t\r\v\f";
  words_of_line.clear();
  current.clear();
  while (next < content.size())
  {
    const std::size_t end = std::min(content.find('\n', next), content.size());
    if (current.empty())
      number_of_line = n_lines + 1;
    current.append(content, next, end - next);
    next = end + 1;
    ++n_lines;
    if (!current.empty() && current.back() == '\\')
    {
      current.back() = ' ';
      continue;
    }
    for (std::size_t at = current.find_first_not_of(blanks);
         at != current.npos;)
    {
      const std::size_t stop =
          std::min(current.find_first_of(blanks, at), current.size());
      words_of_line.emplace_back(current.data() + at, stop - at);
      at = current.find_first_not_of(blanks, stop);
    }
    if (!words_of_line.empty() && words_of_line[0][0] != '#')
      return true;
    words_of_line.clear();
    current.clear();
  }
  number_of_line = n_lines + 1;
  return false;
}

void ModelText::expect_line(const std::string &what)
{
  if (!next_line())
    refuse_file("ends where " + what + " should be; it was cut short.");
}

bool ModelText::begins_with(const std::string_view word) const
{
  return !words_of_line.empty() && boost::iequals(words_of_line[0], word);
}

std::string ModelText::rest(const std::size_t word) const
{
  if (word >= words_of_line.size())
    return "";
  const std::string_view last = words_of_line.back();
  return {words_of_line[word].data(), last.data() + last.size()};
}

dealii::Point<3> ModelText::point(const std::size_t word) const
{
  dealii::Point<3> point;
  for (unsigned int d = 0; d < 3; ++d)
  {
    const std::optional<double> x =
        word + d < words_of_line.size()
            ? number_of_word(words_of_line[word + d])
            : std::nullopt;
    if (!x)
      refuse("'" + rest(word) + "' should begin with three numbers \"x y z\"" +
             (rest(word).find(',') != std::string::npos
                  ? advice_on_decimal_comma(rest(word))
                  : "") +
             ".");
    point[d] = *x;
  }
  return point;
}

long long ModelText::integer(const std::size_t word,
                             const std::string &expected,
                             const long long least,
                             const long long most) const
{
  if (word < words_of_line.size())
  {
    const std::string_view digits = words_of_line[word];
    long long value = 0;
    const char *const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (stop == end && error == std::errc() && least <= value && value <= most)
      return value;
  }
  refuse(text("'", word < words_of_line.size() ? rest(word) : "",
              "' should begin with ", expected, ", a whole number from ", least,
              " to ", most, "."));
}

std::string ModelText::fault_in_line(const std::string &fault) const
{
  return text("The ", format, " file '", file.string(),
              "' cannot be read in line ", line(), ": ", fault);
}

void ModelText::refuse(const std::string &fault) const
{
  throw InputError(fault_in_line(fault));
}

void ModelText::refuse_file(const std::string &fault) const
{
  throw InputError("The " + format + " file '" + file.string() + "' " + fault);
}

std::string read_model_bytes(const std::filesystem::path &file)
{
  std::optional<std::string> bytes = bytes_of_file(file);
  if (!bytes)
    refuse_unreadable_model(file);
  return std::move(*bytes);
}
} // namespace Voussoir
