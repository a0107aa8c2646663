// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_tests_volumes_h
#define voussoir_tests_volumes_h

#include <voussoir/packing/polyhedra/cell_moments.h>

// What the tests of generators in space and those of models share.

/** The volume of all cells. */
inline double volume_of(const Voussoir::CellFaces &cells)
{
  double volume = 0.;
  for (unsigned int cell = 0; cell < cells.n_cells(); ++cell)
    volume += moments_of(cells, cell).volume;
  return volume;
}

#endif
