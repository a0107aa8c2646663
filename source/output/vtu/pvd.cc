// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/vtu/pvd.h>

#include <ostream>

namespace Voussoir
{
void write_pvd(std::ostream &out, const std::vector<std::string> &files)
{
  out << "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  unsigned int step = 0;
  for (const std::string &file : files)
    out << "<DataSet timestep=\"" << step++ << "\" part=\"0\" file=\"" << file
        << "\"/>\n";
  out << "</Collection>\n</VTKFile>\n";
}
} // namespace Voussoir
