// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_side_pairs_h
#define voussoir_packing_polygons_side_pairs_h

#include <voussoir/packing/packing.h>
#include <voussoir/packing/polygons/polygon_list.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <array>
#include <optional>
#include <vector>

namespace Voussoir
{
/** A side of a cell, counterclockwise around it. */
struct PolygonSide
{
  /** From @p start to @p end, of the cell of that number. */
  PolygonSide(unsigned int cell,
              const dealii::Point<2> &start,
              const dealii::Point<2> &end);

  /** The number of the cell. */
  unsigned int cell;
  /** Where the side begins; a length. */
  dealii::Point<2> start;
  /** Where it ends; a length. */
  dealii::Point<2> end;
  /** The unit vector from start to end. */
  dealii::Tensor<1, 2> along;
  /** The distance of the two; a length. */
  double length;
};

/** The sides of all polygons, one after the other. */
std::vector<PolygonSide> sides_of(const PolygonList &polygons);
/** The sides of all cells, counted through. */
std::vector<PolygonSide> sides_of(const CellLoops &cells);

/** What makes two sides face each other; see facing_pair(). */
struct FacingLimits
{
  /** The largest distance between them; a length. */
  double joint_width;
  /** The largest angle between their directions, below a right one; radians. */
  double angle;
  /** How deep they may overlap, and how short a joint vanishes; a length. */
  double tolerance;
};

/**
 * Two sides that face each other across a strip: what their projections on a
 * line have in common. Places have a coordinate along the line, zero where the
 * first side starts, and a height out of the first side's cell; lengths.
 */
class SidePair
{
public:
  /** Coordinates from the first to the second. */
  using Interval = std::array<double, 2>;

  /**
   * @param side the numbers of the two among @p sides.
   * @param along the unit vector along the line, to which the first side is
   *   nearly parallel and the second nearly opposite.
   */
  SidePair(const std::vector<PolygonSide> &sides,
           const std::array<std::size_t, 2> &side,
           const dealii::Tensor<1, 2> &along);

  /** The numbers of the two sides. */
  std::array<std::size_t, 2> side;
  /** Their cells. */
  std::array<unsigned int, 2> cells;
  /** The lower end of the strip. */
  double low;
  /** The upper end; there is no strip unless it is the larger one. */
  double high;

  /** The length of the strip along the line. */
  double length() const { return high - low; }
  /** The unit vector along the line. */
  const dealii::Tensor<1, 2> &direction() const { return along; }
  /** The coordinate of a place. */
  double coordinate(const dealii::Point<2> &p) const
  {
    return (p - origin) * along;
  }
  /** The coordinate at the distance @p t from the start of side @p k. */
  double coordinate(const unsigned int k, const double t) const
  {
    return begin[k] + t * slope[k];
  }
  /** The distance from the start of side @p k at coordinate @p s. */
  double on_side(const unsigned int k, const double s) const
  {
    return (s - begin[k]) / slope[k];
  }
  /** The distance between the sides at @p s, negative where they overlap. */
  double gap(const double s) const { return height(1, s) - height(0, s); }
  /** The least of these along the strip. */
  double least_gap() const { return std::min(gap(low), gap(high)); }
  /** The place midway between the sides at the middle of the strip. */
  dealii::Point<2> middle() const;
  /** Shorten the strip to where the gap is within two values. */
  void keep_gaps(double least, double greatest);
  /**
   * The strip but for a margin on all sides, counterclockwise, from the end
   * @p low of the first side; empty if there is nothing else.
   */
  std::vector<dealii::Point<2>> outline(double margin = 0.) const;
  /**
   * What a segment from @p a to @p b covers of the strip; empty if it does not
   * enter it.
   *
   * @param margins how far from either side it must stay at least to count,
   *   negative where it may be behind the side; lengths.
   */
  std::optional<Interval> shadow(const dealii::Point<2> &a,
                                 const dealii::Point<2> &b,
                                 const std::array<double, 2> &margins) const;
  /** What is left without @p taken, in parts longer than @p shortest. */
  std::vector<SidePair> without(std::vector<Interval> taken,
                                double shortest) const;

private:
  /** The height of side @p k at coordinate @p s. */
  double height(const unsigned int k, const double s) const
  {
    return start_height[k] + on_side(k, s) * rise[k];
  }
  dealii::Point<2> place(double s, double height) const;

  dealii::Point<2> origin;
  dealii::Tensor<1, 2> along;
  /** Of each side the coordinate and height of its start, and how they change
   * along it. */
  std::array<double, 2> begin, slope, start_height, rise;
};

/**
 * Where two sides face each other: their outward normals are opposite but for
 * the angle, and their distance, measured across the line that halves that, is
 * at most the width.
 */
std::optional<SidePair> facing_pair(const std::vector<PolygonSide> &sides,
                                    const std::array<std::size_t, 2> &side,
                                    const FacingLimits &limits);

/** Finds sides near each other, and what lies between them, by an R-tree. */
class SideTree
{
public:
  /** @param sides of all cells; they must outlive this object. */
  SideTree(const std::vector<PolygonSide> &sides, double tolerance);

  /** The sides that come near to @p side, in ascending order. */
  std::vector<std::size_t> near(std::size_t side, double distance) const;
  /**
   * The parts of a strip that no block covers. A part beside a block that is
   * shorter than it is wide is none: that is the joint between the block and
   * its neighbour, or the block stands back a little.
   */
  std::vector<SidePair> uncovered(const SidePair &pair) const;

private:
  using Box = dealii::BoundingBox<2>;

  std::optional<SidePair::Interval> shadow(const SidePair &pair,
                                           const PolygonSide &side) const;

  const std::vector<PolygonSide> &sides;
  const double tolerance;
  std::vector<Box> boxes;
  decltype(dealii::pack_rtree_of_indices(
      std::declval<std::vector<Box>>())) tree;
};
} // namespace Voussoir

#endif
