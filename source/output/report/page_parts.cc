// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/report/page_parts.h>

#include <ostream>

namespace Voussoir
{
void fill_page(std::ostream &out, std::string_view page, const PageParts &parts)
{
  for (std::size_t begin; (begin = page.find("{{")) != page.npos;)
  {
    const std::size_t end = page.find("}}", begin);
    out << page.substr(0, begin)
        << parts.find(page.substr(begin + 2, end - begin - 2))->second;
    page.remove_prefix(end + 2);
  }
  out << page;
}
} // namespace Voussoir
