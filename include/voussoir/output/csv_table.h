// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_csv_table_h
#define voussoir_output_csv_table_h

#include <voussoir/output/fields/field.h>

#include <iosfwd>

namespace Voussoir
{
/**
 * Write a table of one line for each of @p n elements, below the names of the
 * columns of @p fields. Numbers are read back as the same doubles; see
 * TextLines.
 */
void write_table(std::ostream &out, const BoundFields &fields, unsigned int n);
} // namespace Voussoir

#endif
