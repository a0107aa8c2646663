// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_fields_capacity_h
#define voussoir_output_fields_capacity_h

#include <voussoir/analyses/capacity/capacity_curve.h>
#include <voussoir/output/fields/field.h>

namespace Voussoir
{
/** The points of a capacity curve. */
Fields<CapacityCurve> capacity_points();
} // namespace Voussoir

#endif
