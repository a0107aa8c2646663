// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_content_name_h
#define voussoir_base_content_name_h

#include <string>

namespace Voussoir
{
/**
 * The name of a content: its UUID of version 5, from SHA-1, in the name space
 * of object identifiers, as Python's uuid.uuid5(uuid.NAMESPACE_OID, content).
 */
std::string name_of_content(const std::string &content);
} // namespace Voussoir

#endif
