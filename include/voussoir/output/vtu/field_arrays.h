// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_vtu_field_arrays_h
#define voussoir_output_vtu_field_arrays_h

#include <voussoir/output/fields/field.h>
#include <voussoir/output/vtu/vtu_file.h>

namespace Voussoir
{
/**
 * Give the cells of a grid the values of @p fields: of vectors three
 * components and of tensors nine, as VTK has them, and of pairs two arrays.
 */
void add_fields(VtuFile &file, const BoundFields &fields);
} // namespace Voussoir

#endif
