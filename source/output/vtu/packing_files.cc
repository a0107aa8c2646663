// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/summary/text_lines.h>
#include <voussoir/output/vtu/packing_files.h>

#include <algorithm>
#include <ostream>
#include <utility>

namespace Voussoir
{
namespace
{
/** A point that can be ordered. */
std::pair<double, double> key(const dealii::Point<2> &p)
{
  return {p[0], p[1]};
}
} // namespace

void write_packing_wkt(std::ostream &out, const Packing<2> &packing)
{
  write_lines(out, packing.n_cells(), [&](TextLines &line, unsigned int c) {
    line << "POLYGON (";
    for (unsigned int i = 0; i <= packing.n_sides(c); ++i)
      line << (i == 0 ? "(" : ", ") << packing.vertex(c, i)[0] << ' '
           << packing.vertex(c, i)[1];
    line << "));" << packing.group_name(c) << '\n';
  });
}

void write_packing_off(std::ostream &out, const Packing<2> &packing)
{
  std::vector<std::pair<double, double>> vertices;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
      vertices.push_back(key(packing.vertex(c, i)));
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());

  out << "OFF\n" << vertices.size() << ' ' << packing.n_cells() << " 0\n";
  write_lines(out, vertices.size(), [&](TextLines &line, unsigned int v) {
    line << vertices[v].first << ' ' << vertices[v].second << " 0\n";
  });
  write_lines(out, packing.n_cells(), [&](TextLines &line, unsigned int c) {
    line << packing.n_sides(c);
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
      line << ' '
           << std::lower_bound(vertices.begin(), vertices.end(),
                               key(packing.vertex(c, i))) -
                  vertices.begin();
    line << '\n';
  });
}

void write_centres(std::ostream &out, const Packing<2> &packing)
{
  write_lines(out, packing.n_cells(), [&](TextLines &line, unsigned int c) {
    line << packing.centre(c)[0] << ' ' << packing.centre(c)[1] << '\n';
  });
}
} // namespace Voussoir
