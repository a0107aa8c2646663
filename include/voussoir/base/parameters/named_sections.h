// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_parameters_named_sections_h
#define voussoir_base_parameters_named_sections_h

#include <map>
#include <set>
#include <string>

namespace Voussoir
{
/**
 * The names that a user has given to sections, by the section that these are
 * in, such as `Load cases`.
 */
using NamedSections = std::map<std::string, std::set<std::string>>;
} // namespace Voussoir

#endif
