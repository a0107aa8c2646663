// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_side_forces_h
#define voussoir_stress_side_forces_h

#include <voussoir/packing/cell_range.h>
#include <voussoir/scene/scene.h>

#include <vector>

namespace Voussoir
{
/** What acts on a cell through one of its sides; S L. */
struct SideForce
{
  /** The force of an interface, a support or a traction. */
  dealii::Tensor<1, 2> force;
  /**
   * D, see CellForces::shift_on_side; zero on an interface where blocks do not
   * turn.
   */
  dealii::Tensor<1, 2> shift;
};

/**
 * The force on @p cell through its side @p i. An interface beside the side, in
 * the middle of a joint of some width, has its force there: the couple about
 * the middle of the side is more than that on the interface.
 */
SideForce side_force(const Scene &scene,
                     const InterfaceForces &forces,
                     unsigned int cell,
                     unsigned int i);

/**
 * The forces on some cells that are cut free of all others (paper, eq. 14), and
 * where blocks turn their couples; S L. An element for each side, cell by cell.
 */
struct CellForces
{
  /**
   * On the cell, through each side: the force of an interface, a support or a
   * traction.
   */
  std::vector<dealii::Tensor<1, 2>> on_side;
  /**
   * D, the part of each force F that is shifted from the first half of its side
   * to the second, counterclockwise around the cell: F/2 - D and F/2 + D act on
   * them, so that D |e| / 2 is the first moment of the tractions along the
   * side, and t x D |e| / 2 the couple, with the direction t of the side. Empty
   * where blocks do not turn: F is spread evenly.
   */
  std::vector<dealii::Tensor<1, 2>> shift_on_side;
  /**
   * The integral of the body force over the triangle of the centre and each
   * side; empty if there is none.
   */
  std::vector<dealii::Tensor<1, 2>> body;
};

/** The forces on the cells of a range, of a scene and its interfaces. */
CellForces cell_forces(const Scene &scene,
                       const InterfaceForces &forces,
                       const CellRange &cells);
} // namespace Voussoir

#endif
