// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_cell_pieces_h
#define voussoir_stress_cell_pieces_h

#include <voussoir/packing/packing.h>
#include <voussoir/scene/motion.h>
#include <voussoir/scene/scene.h>
#include <voussoir/stress/side_forces.h>

#include <vector>

namespace Voussoir
{
/**
 * The cells of a packing with those that cannot be seen whole from their centre
 * cut into convex pieces, for the stress alone: blocks stay one for the forces.
 *
 * The pieces of a block form a tree, so that the force and the couple through
 * each cut follow from balance. The body force of a block is taken as the
 * linear one of the same resultant and first moments, which it is if it is
 * uniform or linear. If blocks do not turn, what torque a block has left is
 * shared out by area, as the mean stress of an uncut one has it.
 */
class CellPieces
{
public:
  /** @param packing must outlive the object. */
  explicit CellPieces(const Packing<2> &packing);

  /** The pieces, and all other cells as they are, which share no sides. */
  const Packing<2> &as_packing() const { return pieces; }
  /** The cell that each piece is of, ascending. */
  const std::vector<unsigned int> &cell_of() const { return cells; }

  /** The cells that some pieces, ascending, are of; each once. */
  std::vector<unsigned int>
  cells_of(const std::vector<unsigned int> &pieces) const;

  /** The forces on all pieces. */
  CellForces forces(const Scene &scene, const InterfaceForces &forces) const;
  /** The motion of the pieces. */
  Motion motion(const Motion &of_cells) const;

private:
  CellLoops loops();
  void add_piece(unsigned int cell,
                 const std::vector<unsigned int> &corners,
                 CellLoops &loops);

  const Packing<2> &packing;
  std::vector<unsigned int> cells;
  /** Of each piece, the vertices of its cell, by their numbers in it. */
  std::vector<std::vector<unsigned int>> corners_of;
  Packing<2> pieces;
};
} // namespace Voussoir

#endif
