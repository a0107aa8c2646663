// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polygons/polygon_list.h>

#include <fstream>
#include <iterator>

namespace Voussoir
{
void PolygonList::refuse(const unsigned int cell,
                         const unsigned int record,
                         const std::string &fault) const
{
  throw InputError(text("Cell ", cell, " (", record_name, ' ', record, " of '",
                        file.string(), "') ", fault));
}

std::string read_polygon_text(const std::filesystem::path &file)
{
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file))
    throw InputError("The file of polygons '" + file.string() +
                     "' cannot be read. Paths in a .prm file start at the "
                     "directory of that file.");
  std::string all((std::istreambuf_iterator<char>(in)), {});
  const std::string byte_order_mark = "\xEF\xBB\xBF";
  if (all.compare(0, byte_order_mark.size(), byte_order_mark) == 0)
    all.erase(0, byte_order_mark.size());
  return all;
}
} // namespace Voussoir
