// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_drawing_faults_h
#define voussoir_packing_polygons_drawing_faults_h

#include <voussoir/base/exceptions.h>

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace Voussoir
{
/** A fault of a cell of a drawing, or of two. */
class DrawingFault : public InputError
{
public:
  /** What is wrong, in the order in which messages list them. */
  enum class Kind
  {
    /** A record is no polygon, or cannot be read. */
    no_polygon,
    not_closed,
    hole,
    /** A vertex is not finite or is repeated, or there are too few. */
    bad_vertex,
    no_area,
    self_crossing,
    sliver,
    bad_group_name,
    /** Smaller or narrower than the matching tolerance allows. */
    too_small_to_match,
    duplicate,
    overlap,
    /** Cells would be joined across an opening, or through another joint. */
    impossible_joint,
    /** It touches nothing; a fault only if something else is wrong, too. */
    floats,
    /** Cells face each other across a gap; no fault. */
    gap
  };

  /** @param message a whole one, with cell, record, place and what to do. */
  DrawingFault(const Kind kind,
               std::vector<unsigned int> cells,
               const std::string &message)
      : InputError(message), kind(kind), cells(std::move(cells))
  {}

  /** What is wrong. */
  Kind kind;
  /** The cells that have it. */
  std::vector<unsigned int> cells;
  /**
   * The depth of an overlap, the width of a gap or joint, the distance between
   * the ends of an open line, a length; else 0.
   */
  double size = 0.;
  /** What an overlap, a gap or a joint covers, counterclockwise; lengths. */
  std::vector<dealii::Point<2>> outline = {};
  /** The vertices of a line that is open; lengths. */
  std::vector<dealii::Point<2>> line = {};
};

/** What a drawing shows, and what is wrong with it. */
struct DrawingCheck
{
  /**
   * The vertices of each cell, empty where they cannot be drawn or are those of
   * an open line; lengths.
   */
  std::vector<std::vector<dealii::Point<2>>> rings;
  /** All that was found. */
  std::vector<DrawingFault> faults;
};

/** The message of several faults, by kind; the first ones of each in full. */
std::string message_of(const std::string &file,
                       const std::vector<DrawingFault> &faults);

/** A drawing has faults; the message names them all. */
class DrawingRefused : public InputError
{
public:
  /** @param file of the drawing, for the message. */
  DrawingRefused(const std::string &file, DrawingCheck check)
      : InputError(message_of(file, check.faults)), check(std::move(check))
  {}

  /** To be shown. */
  DrawingCheck check;
};
} // namespace Voussoir

#endif
