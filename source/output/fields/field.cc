// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/fields/field.h>

#include <cmath>

namespace Voussoir
{
FieldValues BoundValues::drawn() const
{
  if (!stand_in)
    return values;
  return [values = values, stand_in = stand_in](
             std::size_t e, const std::size_t end, double *place) {
    values(e, end, place);
    for (; e < end; ++e, ++place)
      if (!std::isfinite(*place))
        stand_in(e, e + 1, place);
  };
}

std::vector<std::string>
FieldDescription::component_names(const std::string &of) const
{
  switch (shape)
  {
  case FieldShape::number: return {of};
  case FieldShape::pair: return {of + "_0", of + "_1"};
  case FieldShape::vector: return {of + "_x", of + "_y"};
  case FieldShape::space_vector: return {of + "_x", of + "_y", of + "_z"};
  case FieldShape::tensor:
    return {of + "_xx", of + "_xy", of + "_yx", of + "_yy"};
  case FieldShape::space_tensor:
    return {of + "_xx", of + "_xy", of + "_xz", of + "_yx", of + "_yy",
            of + "_yz", of + "_zx", of + "_zy", of + "_zz"};
  }
  return {};
}
} // namespace Voussoir
