// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/vtu/field_arrays.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace Voussoir
{
namespace
{
/** Elements whose values are asked for at a time, and components at most. */
constexpr std::size_t at_a_time = 64, most_components = 9;

/**
 * Add an array of the components @p of, by their numbers, where -1
 * is a zero.
 */
template <typename Number, std::size_t n>
void add_array(VtuFile &file,
               const std::string &name,
               const BoundField &field,
               const std::array<int, n> &of)
{
  const auto fill = [values = field.drawn(), of,
                     in_plane = field.about->n_components()](
                        std::size_t e, const std::size_t end, Number *place) {
    std::array<double, most_components * at_a_time> all;
    for (std::size_t next; e < end; e = next)
    {
      next = std::min(e + at_a_time, end);
      values(e, next, all.data());
      for (const double *value = all.data(); e < next; ++e, value += in_plane)
        for (const int k : of)
          *place++ = k < 0 ? Number() : static_cast<Number>(value[k]);
    }
  };
  file.add_cell_field<Number>(name, n, fill);
}

void add_numbers(VtuFile &file, const BoundField &field)
{
  const std::string &name = field.about->name;
  const std::array<int, 1> number = {{0}};
  switch (field.about->type)
  {
  case FieldType::real:
    return file.add_cell_field<double>(name, 1, field.drawn());
  case FieldType::mark:
    return add_array<std::uint8_t>(file, name, field, number);
  case FieldType::integer:
  case FieldType::name:
    return add_array<std::int32_t>(file, name, field, number);
  }
}
} // namespace

void add_fields(VtuFile &file, const BoundFields &fields)
{
  for (const BoundField &field : fields)
  {
    const FieldDescription &about = *field.about;
    switch (about.shape)
    {
    case FieldShape::number: add_numbers(file, field); break;
    case FieldShape::pair:
      for (const int end : {0, 1})
        add_array<double, 1>(file, about.columns[end], field, {{end}});
      break;
    case FieldShape::vector:
      add_array<double, 3>(file, about.name, field, {{0, 1, -1}});
      break;
    case FieldShape::space_vector:
      add_array<double, 3>(file, about.name, field, {{0, 1, 2}});
      break;
    case FieldShape::tensor:
      add_array<double, 9>(file, about.name, field,
                           {{0, 1, -1, 2, 3, -1, -1, -1, -1}});
      break;
    case FieldShape::space_tensor:
      add_array<double, 9>(file, about.name, field,
                           {{0, 1, 2, 3, 4, 5, 6, 7, 8}});
      break;
    }
  }
}
} // namespace Voussoir
