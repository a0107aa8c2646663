// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_parameters_decimal_comma_h
#define voussoir_base_parameters_decimal_comma_h

#include <cctype>
#include <string>

namespace Voussoir
{
/**
 * A text with a decimal point for every comma between two digits: "4.0; -0.5"
 * of "4,0; -0,5".
 */
inline std::string with_decimal_points(std::string text)
{
  const auto is_digit = [&](const std::size_t i) {
    return std::isdigit(static_cast<unsigned char>(text[i])) != 0;
  };
  for (std::size_t i = 1; i + 1 < text.size(); ++i)
    if (text[i] == ',' && is_digit(i - 1) && is_digit(i + 1))
      text[i] = '.';
  return text;
}

/** What a message on "4,0" says of it. */
inline std::string advice_on_decimal_comma(const std::string &text)
{
  return "; numbers have a decimal point: " + with_decimal_points(text);
}
} // namespace Voussoir

#endif
