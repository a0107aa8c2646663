// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_page_parts_h
#define voussoir_output_report_page_parts_h

#include <functional>
#include <iosfwd>
#include <map>
#include <string>
#include <string_view>

namespace Voussoir
{
/** What takes the place of "{{name}}" in a page, by these names. */
using PageParts = std::map<std::string, std::string, std::less<>>;

/** Write a page with its parts, of which each name in it has one. */
void fill_page(std::ostream &out,
               std::string_view page,
               const PageParts &parts);
} // namespace Voussoir

#endif
