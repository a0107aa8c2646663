// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_reference_h
#define voussoir_base_reference_h

#include <iosfwd>
#include <string>

namespace dealii
{
class ParameterHandler;
}

namespace Voussoir
{
/**
 * The values that an entry accepts, in words: "a number from 0 to 1" for
 * deal.II's "[Double 0...1 (inclusive)]", whatever follows that. A description
 * of another form is left as it is.
 */
std::string text_of_pattern(const std::string &text);

/**
 * The page of the manual on the parameters: of each its place, default, what it
 * accepts, and its documentation, in Markdown.
 */
void write_reference(std::ostream &out, const dealii::ParameterHandler &prm);
} // namespace Voussoir

#endif
