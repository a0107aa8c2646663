// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_cells_h
#define voussoir_packing_cells_h

#include <voussoir/packing/cell_loops.h>
#include <voussoir/packing/polyhedra/cell_faces.h>

#include <type_traits>

namespace Voussoir
{
/** The lists from which a Packing<dim> is made. */
template <int dim>
using Cells = std::conditional_t<dim == 2, CellLoops, CellFaces>;
} // namespace Voussoir

#endif
