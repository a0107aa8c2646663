// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_ranges_greatest_force_h
#define voussoir_analyses_ranges_greatest_force_h

#include <voussoir/analyses/ranges/state_program.h>
#include <voussoir/statics/conic/feasible_state.h>

#include <optional>
#include <vector>

namespace Voussoir
{
/**
 * Maximise c . x over all admissible states x, see StateProgram, by SelfDual
 * with the cost -c. It takes about as long as a load factor, and no state to
 * start from: of large packings it is the way to few values, as the simplex
 * method is to many, and where sections crush it is the only one.
 *
 * @param problem has the rows, and the loads.
 * @param c one number for each row.
 * @param anchor a state away from the limits, towards which states are moved
 *   that rounding lets miss balance; or one is found on the way.
 * @param terminal sees the iterations.
 * @return the best state and motion that were found, or none.
 */
StateProgram::Optimum greatest_force(const RowProblem &problem,
                                     const std::vector<double> &c,
                                     std::optional<FactorState> anchor,
                                     Terminal &terminal);
} // namespace Voussoir

#endif
