// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_capacity_capacity_path_h
#define voussoir_analyses_capacity_capacity_path_h

#include <voussoir/analyses/capacity/capacity_points.h>
#include <voussoir/analyses/capacity/placement.h>
#include <voussoir/analyses/factors/load_factor.h>

#include <memory>
#include <string>

namespace Voussoir
{
/** One position on a capacity curve, and what is known of it. */
struct CapacityStop
{
  Placement place;          /**< where the blocks are */
  CapacityPoint point = {}; /**< of the curve */
  /** The motion from here; a step is a length. */
  Motion motion = {};
  /** The jumps of the motion; L. */
  InterfaceJumps jumps = {};
};

/** What the blocks of a capacity curve go along. */
class CapacityPath
{
public:
  /** Of the scene with the dead loads at rest; both outlive it. */
  CapacityPath(const Scene &dead, const CapacityWanted &wanted)
      : dead(dead), wanted(wanted)
  {}
  virtual ~CapacityPath() = default;

  /** The blocks at rest. */
  virtual CapacityStop begin() const { return {Placement(dead)}; }
  /** True if blocks do not stay where this was found. */
  virtual bool falls(const LoadFactorAnswer &answer) const = 0;
  /** That, as the end of a sentence. */
  virtual std::string words_of_fall() const = 0;
  /**
   * Take the motion from a position, and what else is known of it there.
   *
   * @param stop takes them.
   * @param factor that was found there.
   * @return why there is none; empty if there is.
   */
  virtual std::string take(CapacityStop &stop,
                           const LoadFactor &factor) const = 0;
  /** The step from rest; L. */
  virtual double first_step() const = 0;
  /** The step from the last of @p points, which @p last is; L. */
  virtual double next_step(const std::vector<CapacityPoint> &points,
                           const CapacityStop &last) const = 0;
  /** Why the curve ends at a position; empty if it goes on. */
  virtual std::string end_at(const CapacityStop &stop) const
  {
    return wanted.largest > 0. && stop.point.displacement >= wanted.largest
               ? "the displacement is that of 'Capacity/Largest displacement'"
               : "";
  }
  /**
   * The error of the last place where blocks stay, to be found before one where
   * they fall; L. Zero: it means nothing.
   */
  virtual double error_of_last_place() const = 0;

protected:
  /** Where the point is that is followed. */
  dealii::Point<2> place_of_point(const CapacityStop &stop) const
  {
    return stop.place.positions().of(dead.packing, wanted.cell, wanted.place);
  }

  const Scene &dead;            /**< at rest */
  const CapacityWanted &wanted; /**< of the curve */
};

/**
 * The mechanism of the factor, or the supports if they move.
 *
 * @param dead the scene at rest, with the dead loads.
 * @param wanted of the curve.
 */
std::unique_ptr<const CapacityPath>
make_capacity_path(const Scene &dead, const CapacityWanted &wanted);
} // namespace Voussoir

#endif
