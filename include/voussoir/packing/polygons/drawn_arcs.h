// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_drawn_arcs_h
#define voussoir_packing_polygons_drawn_arcs_h

#include <deal.II/base/point.h>

#include <vector>

namespace Voussoir
{
/** Vertices in a row, with arcs between some of them. */
struct DrawnChain
{
  /** In their order; lengths. */
  std::vector<dealii::Point<2>> points;
  /** Of the side from each vertex to the next; see bulge_through(). */
  std::vector<double> bulges;
  /** True if a curve that is no arc was replaced by straight sides. */
  bool has_other_curves = false;

  /** Go on to @p point, the first one too, along a straight side or an arc. */
  void add(const dealii::Point<2> &point, double bulge = 0.);
  /**
   * Go on along an arc to @p end. A whole circle, which ends where it begins,
   * becomes two arcs.
   */
  void add_arc(const dealii::Point<2> &middle, const dealii::Point<2> &end);
  /** Go on along all of @p other, which begins where this ends. */
  void append(const DrawnChain &other);
};

/**
 * The bulge of the arc from @p start through @p middle to @p end: the tangent
 * of a quarter of the angle that it turns by, positive if to the left, as DXF
 * has it. The three points differ.
 */
double bulge_through(const dealii::Point<2> &start,
                     const dealii::Point<2> &middle,
                     const dealii::Point<2> &end);

/** The angle of a step along an arc in fine points, in degrees. */
constexpr double fine_step = 0.1;

/**
 * What was drawn, from two chains of chords that a library makes of it.
 *
 * @param coarse with one chord for each arc; lengths.
 * @param fine with a vertex on arcs every fine_step degrees, and the vertices
 *   of @p coarse among its own, to the bit.
 */
DrawnChain chain_between(const std::vector<dealii::Point<2>> &coarse,
                         const std::vector<dealii::Point<2>> &fine);
} // namespace Voussoir

#endif
