// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polygons/drawn_lines.h>
#include <voussoir/packing/polygons/polygon_checks.h>

#include <deal.II/base/bounding_box.h>

#include <algorithm>

namespace Voussoir
{
namespace
{
using dealii::Point;
using Polygon = PolygonList::Polygon;

/** Refuse a ring that is open. */
void refuse_open(PolygonList &polygons, const unsigned int cell)
{
  Polygon &polygon = polygons.polygons[cell];
  const Point<2> &first = polygon.ring.front(), &last = polygon.ring.back();
  DrawingFault fault = polygons.fault(
      DrawingFault::Kind::not_closed, cell,
      polygon.is_line
          ? "is a line from " + text_of_point(first) + " to " +
                text_of_point(last) +
                " that is not closed; close it, or delete it if it bounds no "
                "cell. 'Packing/polygons/Lines = join' makes cells of lines "
                "that meet, and 'ignore' leaves them out."
          : "is not closed: it ends at " + text_of_point(last) +
                "; repeat its first vertex " + text_of_point(first) +
                " at the end.");
  fault.size = first.distance(last);
  fault.line = polygon.ring;
  polygons.faults.push_back(fault);
  polygon.is_broken = true;
}

/** Close a ring of at least two vertices whose ends are the same. */
void close(Polygon &polygon)
{
  polygon.ring.pop_back();
  if (!polygon.bulges.empty())
    polygon.bulges.pop_back(); // of no side
  polygon.is_open = false;
}

/** Leave out all lines that are still open. */
void leave_out_lines(PolygonList &polygons)
{
  std::vector<Polygon> &all = polygons.polygons;
  const auto is_left_out = [](const Polygon &polygon) {
    return polygon.is_open && !polygon.is_broken;
  };
  const auto first = std::find_if(all.begin(), all.end(), is_left_out);
  if (first == all.end())
    return;
  polygons.refuse_faults();
  const std::size_t n = std::count_if(first, all.end(), is_left_out);
  polygons.notices.push_back(
      text(counted(n, "line"), " of '", polygons.file.string(), "' that ",
           n == 1 ? "is" : "are", " not closed ", n == 1 ? "is" : "are",
           " left out ('Packing/polygons/Lines = ignore'); the first, ",
           polygons.record_of(first - all.begin()), ", goes from ",
           text_of_point(first->ring.front()), " to ",
           text_of_point(first->ring.back()), '.'));
  all.erase(std::remove_if(first, all.end(), is_left_out), all.end());
  if (all.empty())
    throw InputError("The file of polygons '" + polygons.file.string() +
                     "' has no closed lines, and 'Packing/polygons/Lines = "
                     "ignore' leaves out the others; a packing needs at least "
                     "one polygon.");
}
} // namespace

void add_open_lines(dealii::ParameterHandler &prm, OpenLines &lines)
{
  add_choice<OpenLines>(
      prm, "Lines", lines,
      {{OpenLines::refuse, "refuse",
        "each line of a drawing must be closed, and is a cell."},
       {OpenLines::ignore, "ignore",
        "those that are not closed are left out, such as dimensions."},
       {OpenLines::join, "join",
        "lines, polylines and arcs that are not closed are cut where they meet "
        "or cross one another or closed ones, within 'Matching tolerance', and "
        "each area that they enclose is a cell, even if it was meant to be an "
        "opening; what only closed lines enclose between them is none. Such a "
        "cell is in the group of that line which is the longest part of its "
        "boundary, or of the closed line that the lines divide."}},
      "What lines of drawings, in files that GDAL reads, stand for.");
}

double drawn_size(const PolygonList &polygons)
{
  double sum = 0.;
  unsigned int n = 0;
  for (const Polygon &polygon : polygons.polygons)
    if (!polygon.is_broken && !polygon.ring.empty() && polygon.is_finite())
    {
      const auto [low, high] =
          dealii::BoundingBox<2>(polygon.ring).get_boundary_points();
      sum += low.distance(high);
      ++n;
    }
  return sum / std::max(n, 1u);
}

double drawn_tolerance(const PolygonList &polygons)
{
  return tolerance_of(polygons, drawn_size(polygons));
}

void close_rings(PolygonList &polygons,
                 const double tolerance,
                 const OpenLines lines)
{
  for (unsigned int c = 0; c < polygons.polygons.size(); ++c)
  {
    Polygon &polygon = polygons.polygons[c];
    if (!polygon.is_open || polygon.is_broken)
      continue;
    if (!polygon.is_finite()) // which is told of later
    {
      polygon.is_open = false;
      polygon.bulges.clear();
    }
    else if (polygon.ring.size() > 1 &&
             polygon.ring.front().distance(polygon.ring.back()) <= tolerance)
      close(polygon);
    else if (!polygon.is_line || lines == OpenLines::refuse)
      refuse_open(polygons, c);
  }
  if (lines == OpenLines::ignore)
    leave_out_lines(polygons);
}
} // namespace Voussoir
