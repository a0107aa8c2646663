// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_invalid_index_h
#define voussoir_base_invalid_index_h

#include <deal.II/base/types.h>

namespace Voussoir
{
/** No number of a cell, side, unknown, ... */
constexpr unsigned int invalid_index = dealii::numbers::invalid_unsigned_int;
} // namespace Voussoir

#endif
