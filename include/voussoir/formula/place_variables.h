// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_formula_place_variables_h
#define voussoir_formula_place_variables_h

#include <string>
#include <vector>

namespace Voussoir
{
/** The variables of expressions on edges, or in space on faces: the place and
 * the unit normal. */
template <int dim>
std::vector<std::string> variables_on_sides()
{
  return dim == 2 ? std::vector<std::string>{"x", "y", "nx", "ny"}
                  : std::vector<std::string>{"x", "y", "z", "nx", "ny", "nz"};
}
} // namespace Voussoir

#endif
