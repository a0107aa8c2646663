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
  /** Of the side from each vertex to the next, as Arc::bulge; 0: straight. */
  std::vector<double> bulges;
  /** True if a curve that is no arc was replaced by straight sides. */
  bool has_other_curves = false;

  /** True if a side is an arc. */
  bool has_arcs() const;
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

/** The angle of a step along an arc in fine points, in degrees. */
constexpr double fine_step = 0.1;

/**
 * What was drawn, from three chains of chords that a library makes of it, each
 * with the vertices of the first among its own, but for rounding. A curve that
 * is no arc has the vertices of the last, and straight sides.
 *
 * @param coarse with one chord for each arc; lengths.
 * @param fine with a vertex on arcs every fine_step degrees.
 * @param usual as many as the library makes by itself.
 */
DrawnChain chain_between(const std::vector<dealii::Point<2>> &coarse,
                         const std::vector<dealii::Point<2>> &fine,
                         const std::vector<dealii::Point<2>> &usual);
} // namespace Voussoir

#endif
