// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_formula_integrals_discontinuities_h
#define voussoir_formula_integrals_discontinuities_h

#include <voussoir/formula/formula.h>

#include <deal.II/base/point.h>

#include <functional>
#include <vector>

namespace Voussoir
{
/**
 * A parallelogram of points centre + s half_axes[0] + t half_axes[1], with s
 * and t from -1 to 1.
 */
struct Patch
{
  /** Its middle; lengths. */
  dealii::Point<2> centre;
  /** From there to the middles of two sides; lengths. The second may be zero.
   */
  std::array<dealii::Tensor<1, 2>, 2> half_axes;
};

/** The axis-parallel rectangle around some points. */
Patch box_around(const std::vector<dealii::Point<2>> &points);

/** The rectangle on the longest side of a triangle, of twice its area. */
Patch rectangle_around(const std::array<dealii::Point<2>, 3> &triangle);

/**
 * The curves in the plane across which a function of the place may jump or have
 * a kink, as its formulas say. See Formula.
 */
class Discontinuities
{
public:
  /** Of all jumps of the formulas, counted through. */
  using Crossing = Formula::Crossing;
  /** Of the arguments of all jumps. */
  using Limits = Formula::Limits;

  /** None: a smooth function. */
  Discontinuities() = default;

  /**
   * The discontinuities of some formulas in x, y and further variables.
   *
   * @param formulas must outlive this object.
   * @param constants the further variables, of which the first x and y are not
   *   part.
   */
  Discontinuities(
      const std::vector<std::reference_wrapper<const Formula>> &formulas,
      const std::vector<double> &constants);

  /** Let the further variables have these values. */
  void set_constants(const std::vector<double> &constants);

  /** True if there is none at all. */
  bool empty() const { return first.back() == 0; }

  /** True if there are formulas, and so bounds_in(). */
  bool has_formulas() const { return !formulas.empty(); }

  /** The bounds of each formula in @p patch within @p limits; the slopes are
   * along the half axes. */
  std::vector<Bounds> bounds_in(const Patch &patch, const Limits &limits) const;

  /** No limits to the argument of any jump. */
  Limits no_limits() const { return Limits(first.back(), Interval::whole()); }

  /**
   * The jumps that may cross @p patch within @p limits; see Formula::bounds().
   * The slopes are along the half axes.
   */
  std::vector<Crossing> crossings(const Patch &patch,
                                  const Limits &limits) const;

  /**
   * The argument less the level of a crossing, at a point; zero if it is not
   * real there, and the value is for the caller to refuse.
   */
  double distance(const Crossing &crossing, const dealii::Point<2> &p) const;

  /**
   * True if the function has a step there, rather than a kink: if its values on
   * both sides of @p crossing at @p p, within @p limits, differ by more than
   * rounding.
   */
  bool is_step(const Crossing &crossing,
               const dealii::Point<2> &p,
               const Limits &limits) const;

  /** The limits on one side of a crossing: below its level, or above. */
  static Limits on_side(const Crossing &crossing, bool is_below, Limits limits);

private:
  /** Place @p patch in values and bounds. */
  void place(const Patch &patch) const;
  /** The bounds of each formula where it was placed. */
  std::vector<Bounds> bounds_there(const Limits &limits) const;
  Limits limits_of(unsigned int formula, const Limits &limits) const;

  std::vector<std::reference_wrapper<const Formula>> formulas;
  /** The first jump of each formula, and the number of all. */
  std::vector<unsigned int> first = {0};
  /** x, y and the constants. */
  mutable std::vector<double> values = {0., 0.};
  mutable std::vector<Bounds> bounds = {{}, {}};
};
} // namespace Voussoir

#endif
