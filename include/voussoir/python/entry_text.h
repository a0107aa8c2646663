// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_python_entry_text_h
#define voussoir_python_entry_text_h

#include <pybind11/pytypes.h>
#include <string>

namespace Voussoir
{
/**
 * A value of Python's as it stands in a .prm file. An array is a list of
 * values: of joints one number each, and of loads on blocks a row each.
 *
 * @param name of the entry, as in "Friction/Strength".
 * @param dimension of the scene, the number of columns of loads.
 * @throws pybind11::value_error if the entry takes no array, or another shape.
 */
std::string entry_text(const std::string &name,
                       const pybind11::handle &value,
                       unsigned int dimension);
} // namespace Voussoir

#endif
