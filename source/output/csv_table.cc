// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/csv_table.h>
#include <voussoir/output/summary/text_lines.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace Voussoir
{
namespace
{
/** Lines whose values are asked for at a time, which stay in the cache. */
constexpr unsigned int lines_at_a_time = 128;

/** Append a component of @p field; a value that is none is empty. */
void append_value(TextLines &line, const BoundField &field, const double value)
{
  if (std::isnan(value))
    return;
  if (field.about->type == FieldType::name)
    line << (*field.names)[value];
  else if (field.about->type == FieldType::real)
    line << value;
  else
    line << int(value);
}

/** The values of some lines, one quantity after the other. */
std::vector<double> values_of(const BoundFields &fields,
                              const unsigned int begin,
                              const unsigned int end)
{
  std::vector<double> values;
  for (const BoundField &field : fields)
  {
    const std::size_t first = values.size();
    values.resize(first + (end - begin) * field.about->n_components(),
                  std::numeric_limits<double>::quiet_NaN());
    if (field.has_values)
      field.values(begin, end, &values[first]);
  }
  return values;
}

void append_lines(TextLines &lines,
                  const BoundFields &fields,
                  const unsigned int begin,
                  const unsigned int end)
{
  const std::vector<double> values = values_of(fields, begin, end);
  for (unsigned int e = begin; e < end; ++e)
  {
    std::size_t first = 0;
    for (const BoundField &field : fields)
    {
      const unsigned int n = field.about->n_components();
      for (unsigned int k = 0; k < n; ++k)
      {
        if (first + k > 0)
          lines << ',';
        append_value(lines, field, values[first + (e - begin) * n + k]);
      }
      first += (end - begin) * n;
    }
    lines << '\n';
  }
}
} // namespace

void write_table(std::ostream &out,
                 const BoundFields &fields,
                 const unsigned int n)
{
  std::string comma;
  for (const BoundField &field : fields)
    for (const std::string &column : field.about->columns)
    {
      out << comma << column;
      comma = ",";
    }
  out << '\n';
  write_pieces(out, n, [&](TextLines &lines, unsigned int begin, auto end) {
    for (unsigned int next; begin < end; begin = next)
    {
      next = std::min(begin + lines_at_a_time, end);
      append_lines(lines, fields, begin, next);
    }
  });
}
} // namespace Voussoir
