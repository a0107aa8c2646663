// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_drawn_lines_h
#define voussoir_packing_polygons_drawn_lines_h

#include <voussoir/packing/polygons/polygon_list.h>

#include <deal.II/base/parameter_handler.h>

namespace Voussoir
{
/** What is done with the lines of a drawing that are not closed. */
enum class OpenLines
{
  /** They are faults. */
  refuse,
  /** They are left out, with a notice. */
  ignore,
  /** They bound cells together; see join_lines(). */
  join
};

/** The entry 'Packing/polygons/Lines'. */
void add_open_lines(dealii::ParameterHandler &prm, OpenLines &lines);

/**
 * The mean size of a polygon or line that is not broken, the diagonal of the
 * box around its vertices, before cells are made of it; a length.
 */
double drawn_size(const PolygonList &polygons);

/** The matching tolerance for it, see tolerance_of(); a length. */
double drawn_tolerance(const PolygonList &polygons);

/**
 * Close the rings whose ends are no further apart than @p tolerance, a length,
 * by leaving out the last vertex. Other rings that are open are faults, and
 * broken, but for lines, with which it is as @p lines says.
 *
 * @throws DrawingRefused if lines are left out and there are faults, which name
 *   cells by their numbers.
 */
void close_rings(PolygonList &polygons, double tolerance, OpenLines lines);
} // namespace Voussoir

#endif
