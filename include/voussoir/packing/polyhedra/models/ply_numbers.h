// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_models_ply_numbers_h
#define voussoir_packing_polyhedra_models_ply_numbers_h

#include <string>

namespace Voussoir
{
/** The form in which a PLY file has its numbers. */
enum class PlyForm
{
  text,          /**< as words */
  little_endian, /**< in binary, the lowest byte first */
  big_endian     /**< in binary, the highest byte first */
};

/** The bytes of a type of PLY, by its name; zero if there is no such. */
unsigned int bytes_of_ply_type(const std::string &type);

/** The number of a type that begins at a byte, in a binary form. */
double
load_ply_number(const unsigned char *at, const std::string &type, PlyForm form);
} // namespace Voussoir

#endif
