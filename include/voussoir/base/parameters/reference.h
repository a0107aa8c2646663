// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_parameters_reference_h
#define voussoir_base_parameters_reference_h

#include <iosfwd>

namespace dealii
{
class ParameterHandler;
}

namespace Voussoir
{
/**
 * The page of the manual on the parameters: of each its place, default, what it
 * accepts, and its documentation, in Markdown.
 */
void write_reference(std::ostream &out, const dealii::ParameterHandler &prm);
} // namespace Voussoir

#endif
