// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/input/csv_reader.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

namespace Voussoir
{
/**
 * The number of characters of a field that a message quotes; a field may be a
 * whole file.
 */
constexpr std::size_t quotation_length = 40;

CsvReader::CsvReader(std::filesystem::path file_in)
    : file(std::move(file_in)), in(file)
{
  if (!in || std::filesystem::is_directory(file))
    throw InputError("The file '" + file.string() +
                     "' cannot be read; it must be as an earlier run "
                     "has written it.");
  std::getline(in, content);
  split();
  columns.assign(fields.begin(), fields.end());
}

bool CsvReader::has_column(const std::string &name) const
{
  return std::find(columns.begin(), columns.end(), name) != columns.end();
}

void CsvReader::choose(const std::vector<std::string> &names)
{
  for (const std::string &name : names)
  {
    const auto found = std::find(columns.begin(), columns.end(), name);
    if (found == columns.end())
      refuse("has no column '" + name +
             "'; the file must be as an earlier run has written it.");
    chosen.push_back(found - columns.begin());
  }
  values.resize(chosen.size());
}

bool CsvReader::next()
{
  if (!std::getline(in, content))
    return false;
  ++line;
  const std::size_t n_fields = split();
  if (n_fields != columns.size())
    refuse(text("has ", counted(n_fields, "field"), ", but the first line ",
                columns.size(),
                "; the file must be as an earlier run has written it."));
  for (std::size_t i = 0; i < chosen.size(); ++i)
    parse(chosen[i], i);
  return true;
}

std::size_t CsvReader::split()
{
  fields.clear();
  std::string_view rest = content;
  if (!rest.empty() && rest.back() == '\r')
    rest.remove_suffix(1);
  for (;;)
  {
    const std::size_t comma = rest.find(',');
    fields.push_back(rest.substr(0, comma));
    if (comma == std::string_view::npos)
      return fields.size();
    rest.remove_prefix(comma + 1);
  }
}

void CsvReader::parse(const std::size_t column, const std::size_t choice)
{
  const std::string_view &field = fields[column];
  const char *const end = field.data() + field.size();
  const auto [parsed, error] =
      std::from_chars(field.data(), end, values[choice]);
  if (parsed != end || error != std::errc() || !std::isfinite(values[choice]))
    refuse(text("has '", field.substr(0, quotation_length),
                field.size() > quotation_length ? "..." : "",
                "' in the column '", columns[column],
                "', where a finite number is expected; the file must be as an "
                "earlier run has written it."));
}

void CsvReader::refuse(const std::string &fault) const
{
  throw InputError(text("Line ", line, " of '", file.string(), "' ", fault));
}
} // namespace Voussoir
