// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text_file.h>

#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <fstream>
#include <iterator>

namespace Voussoir
{
namespace
{
/** By the byte order mark, or by an ASCII character of two bytes. */
bool is_utf_16(const std::string &bytes)
{
  return boost::starts_with(bytes, "\xFF\xFE") ||
         boost::starts_with(bytes, "\xFE\xFF") ||
         (bytes.size() > 1 && (bytes[0] == '\0') != (bytes[1] == '\0'));
}
} // namespace

std::optional<std::string> bytes_of_file(const std::filesystem::path &file)
{
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file))
    return {};
  std::string bytes((std::istreambuf_iterator<char>(in)), {});
  return in.bad() ? std::optional<std::string>() : bytes;
}

std::optional<std::string> read_text_file(const std::filesystem::path &file)
{
  const std::optional<std::string> bytes = bytes_of_file(file);
  if (!bytes)
    return {};
  std::string text = *bytes;
  if (is_utf_16(text))
    throw InputError("The file '" + file.string() +
                     "' is in UTF-16; save it as UTF-8, which editors offer "
                     "as the encoding.");
  const std::string byte_order_mark = "\xEF\xBB\xBF";
  if (boost::starts_with(text, byte_order_mark))
    text.erase(0, byte_order_mark.size());
  boost::replace_all(text, "\r\n", "\n");
  return text;
}
} // namespace Voussoir
