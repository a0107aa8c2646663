// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/vtu/field_arrays.h>

#include <array>
#include <cstdint>

namespace Voussoir
{
namespace
{
/** The components of a value in the plane. */
using InPlane = std::array<double, 4>;

/**
 * Add an array of the components in the plane @p of, by their numbers, where -1
 * is a zero.
 */
template <typename Number, std::size_t n>
void add_array(VtuFile &file,
               const std::string &name,
               const FieldValues &values,
               const std::array<int, n> &of)
{
  file.add_cell_field<Number>(
      name, n,
      [values, of](std::size_t e, const std::size_t end, Number *place) {
        InPlane value;
        for (; e < end; ++e)
        {
          values(e, e + 1, value.data());
          for (const int k : of)
            *place++ = k < 0 ? Number() : static_cast<Number>(value[k]);
        }
      });
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
    return add_array<std::uint8_t>(file, name, field.drawn(), number);
  case FieldType::integer:
  case FieldType::name:
    return add_array<std::int32_t>(file, name, field.drawn(), number);
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
        add_array<double, 1>(file, about.columns[end], field.values, {{end}});
      break;
    case FieldShape::vector:
      add_array<double, 3>(file, about.name, field.values, {{0, 1, -1}});
      break;
    case FieldShape::tensor:
      add_array<double, 9>(file, about.name, field.values,
                           {{0, 1, -1, 2, 3, -1, -1, -1, -1}});
      break;
    }
  }
}
} // namespace Voussoir
