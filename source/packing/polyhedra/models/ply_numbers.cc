// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/models/ply_numbers.h>

#include <boost/endian/conversion.hpp>

#include <cstdint>
#include <map>

namespace Voussoir
{
unsigned int bytes_of_ply_type(const std::string &type)
{
  static const std::map<std::string, unsigned int> sizes = {
      {"char", 1},  {"int8", 1},    {"uchar", 1},  {"uint8", 1},
      {"short", 2}, {"int16", 2},   {"ushort", 2}, {"uint16", 2},
      {"int", 4},   {"int32", 4},   {"uint", 4},   {"uint32", 4},
      {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
  const auto found = sizes.find(type);
  return found == sizes.end() ? 0 : found->second;
}

namespace
{
template <typename Number>
double load_ply_number(const unsigned char *const at, const PlyForm form)
{
  using boost::endian::order;
  return form == PlyForm::big_endian
             ? boost::endian::endian_load<Number, sizeof(Number), order::big>(
                   at)
             : boost::endian::endian_load<Number, sizeof(Number),
                                          order::little>(at);
}
} // namespace

double load_ply_number(const unsigned char *const at,
                       const std::string &type,
                       const PlyForm form)
{
  const bool is_unsigned = type[0] == 'u';
  switch (bytes_of_ply_type(type))
  {
  case 1:
    return is_unsigned ? load_ply_number<std::uint8_t>(at, form)
                       : load_ply_number<std::int8_t>(at, form);
  case 2:
    return is_unsigned ? load_ply_number<std::uint16_t>(at, form)
                       : load_ply_number<std::int16_t>(at, form);
  case 4:
    if (type[0] == 'f')
      return load_ply_number<float>(at, form);
    return is_unsigned ? load_ply_number<std::uint32_t>(at, form)
                       : load_ply_number<std::int32_t>(at, form);
  default: return load_ply_number<double>(at, form);
  }
}
} // namespace Voussoir
