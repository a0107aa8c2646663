// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_views_h
#define voussoir_output_report_views_h

#include <voussoir/output/report/details.h>
#include <voussoir/output/report/drawing.h>
#include <voussoir/output/results.h>
#include <voussoir/packing/polygons/drawing_faults.h>

#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/** One way to look at the results, which the reader switches to. */
struct View
{
  std::string id;     /**< for HTML, one word */
  std::string name;   /**< for the switch */
  std::string legend; /**< HTML */
};

/** The motion that a picture shows. */
struct DrawnMotion
{
  /** Of the results, which must outlive this object. */
  const Motion *motion;
  /** What it is multiplied by as it is drawn. */
  double factor;
  /** By what the reader may multiply it at most. */
  double most;
  /** The largest displacement, a length if the motion has a size. */
  double largest;
  /** False if only its direction says something. */
  bool has_size;
};

/** The picture of a run, with all that any view shows. */
struct Picture
{
  /** @param box of what is drawn. */
  explicit Picture(const dealii::BoundingBox<2> &box) : drawing(box) {}

  /** The elements of all layers, each with the views that show it. */
  Drawing drawing;
  /** In the order of the switch. */
  std::vector<View> views;
  /** Which layers and colours each view shows. */
  std::string style;
  /** The motion of the view of that, if there is one. */
  std::optional<DrawnMotion> motion;
};

/**
 * Draw what was found; the first view is the one to begin with.
 *
 * @param names the units of legends.
 * @param in_full also the resultant of each joint and the stress of each block,
 *   and every block and joint as an element of its own.
 */
Picture
picture_of(const Results &results, const UnitNames &names, bool in_full);
/** The picture of a collapse: the mechanism. */
Picture
picture_of(const Collapse &collapse, const UnitNames &names, bool in_full);
/** A drawing: its cells, those with faults in colour, and what faults cover. */
Picture picture_of(const DrawingCheck &check);
} // namespace Voussoir

#endif
