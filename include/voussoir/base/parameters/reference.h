// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_parameters_reference_h
#define voussoir_base_parameters_reference_h

#include <iosfwd>
#include <string>

namespace dealii
{
class ParameterHandler;
}

namespace Voussoir
{
/**
 * The page of the manual on the parameters: of each its place, default, what it
 * accepts, and its documentation, in Markdown.
 *
 * @param title of the page.
 * @param options with which the program prints it, each after a space.
 */
void write_reference(std::ostream &out,
                     const dealii::ParameterHandler &prm,
                     const std::string &title,
                     const std::string &options);
} // namespace Voussoir

#endif
