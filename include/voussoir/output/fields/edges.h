// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_fields_edges_h
#define voussoir_output_fields_edges_h

#include <voussoir/output/fields/field.h>

namespace Voussoir
{
/** The cells of each interface, its ends, its normal and its length. */
Fields<Packing<2>> interface_edges();
/** From the centre of c- to that of c+, or to the midpoint of a support. */
Fields<Packing<2>> branch_vectors();
/** The boundary edges, with the forces on them and branch vectors. */
Fields<Scene> boundary_edges();
} // namespace Voussoir

#endif
