// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_fields_links_h
#define voussoir_output_fields_links_h

#include <voussoir/output/fields/field.h>
#include <voussoir/output/results.h>

namespace Voussoir
{
/** The ends, the line and the bounds of links. */
Fields<Scene> link_ends();
/** The forces of links, and what they use of their bounds. */
Fields<Results> link_forces();
/** What a motion does to links. */
Fields<MovingScene> link_elongations();
} // namespace Voussoir

#endif
