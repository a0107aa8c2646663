// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_formula_formula_reader_h
#define voussoir_formula_formula_reader_h

#include <voussoir/formula/formula.h>

namespace mu
{
class Parser;
}

namespace Voussoir
{
/**
 * Give @p parser the functions that formulas may use, and no others: those of
 * smooth_functions() and stepped_functions(), min, max, sum, avg, atan2, pow
 * and if.
 */
void define_functions(mu::Parser &parser);

/**
 * Read the byte code of a formula.
 *
 * @param parser has the formula, the functions of define_functions(), and has
 *   evaluated the formula once.
 * @param variables of the formula, at the addresses that the parser was given
 *   for them.
 */
Formula read_formula(const mu::Parser &parser,
                     const std::vector<double> &variables);
} // namespace Voussoir

#endif
