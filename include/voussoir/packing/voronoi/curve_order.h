// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_voronoi_curve_order_h
#define voussoir_packing_voronoi_curve_order_h

#include <deal.II/base/point.h>

#include <vector>

namespace Voussoir
{
/**
 * Put points in the order in which a Hilbert curve through a square or a cube
 * around them meets them. Cells that touch then mostly have numbers close to
 * each other, and their data lies close in memory; in the order of drawing, a
 * million cells take twice as long in all that looks at neighbours.
 *
 * @param points finite; lengths.
 */
template <int dim>
void order_along_curve(std::vector<dealii::Point<dim>> &points);
} // namespace Voussoir

#endif
