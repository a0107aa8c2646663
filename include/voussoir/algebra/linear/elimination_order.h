// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_linear_elimination_order_h
#define voussoir_algebra_linear_elimination_order_h

#include <vector>

struct cholmod_common_struct;
struct cholmod_sparse_struct;

namespace Voussoir
{
/**
 * An order of bodies in which the factors of a matrix are sparse.
 *
 * It is found for the bodies, not for their unknowns, which follow each other:
 * the graph is smaller by the square of their number. CHOLMOD's minimum degree
 * (AMD) finds it, and where the factors would be large its nested dissection
 * (METIS) is tried as well. Where bodies are to be last, minimum degree is told
 * so (CAMD), and nested dissection orders the others alone.
 *
 * @param graph the pattern of the lower triangle of a matrix with one row for
 *   each body.
 * @param n_unknowns the number of unknowns of a body.
 * @param last bodies to be eliminated after all others.
 * @param common CHOLMOD's settings and workspace.
 * @return the bodies in the order of their elimination.
 * @throws std::bad_alloc if there is not enough memory.
 */
std::vector<int> elimination_order(cholmod_sparse_struct &graph,
                                   unsigned int n_unknowns,
                                   const std::vector<unsigned int> &last,
                                   cholmod_common_struct &common);
} // namespace Voussoir

#endif
