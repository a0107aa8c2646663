// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_connected_groups_h
#define voussoir_packing_connected_groups_h

#include <voussoir/packing/packing.h>
#include <voussoir/packing/polyhedra/packing.h>

#include <utility>
#include <vector>

namespace Voussoir
{
/** The choice whether cells that both touch the ground are connected by it. */
enum class Ground
{
  /** They are: the ground and all that touches it is one group. */
  connects,
  /** They are not: each side of the ground stands for itself. */
  separates
};

/**
 * The connected groups of cells and the ground.
 *
 * For each cell, and at last for the ground, the lowest number in its group:
 * n_cells + 1 numbers, where the ground has the number n_cells. Groups touch
 * each other nowhere, so a group without the ground must be balanced by itself.
 * If the ground separates, it is a group of its own.
 *
 * @param others pairs of cells, or of a cell and the ground, that are connected
 *   besides.
 */
template <int dim>
std::vector<unsigned int> connected_groups(
    const Packing<dim> &packing,
    Ground ground = Ground::connects,
    const std::vector<std::pair<unsigned int, unsigned int>> &others = {});

/**
 * The degree of static indeterminacy: as many forces per interface as there are
 * equations of balance per cell, which is three with moments and two without,
 * and one per link, less the independent equations, which are those of all
 * cells but for one cell in each connected group that has no support.
 *
 * @param group what connected_groups() returns, with the links.
 */
unsigned int static_indeterminacy(const Packing<2> &packing,
                                  const std::vector<unsigned int> &group,
                                  unsigned int n_per_cell,
                                  unsigned int n_links = 0);
} // namespace Voussoir

#endif
