// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/report/views.h>

#include <string>
#include <vector>

namespace Voussoir
{
namespace
{
using dealii::Point;

/** How cells with faults, and what faults cover, look. */
const std::string style_of_faults =
    ".legend{display:block}\n"
    ".faulty{--colour:#f0b9a8}\n"
    ".covered{fill:var(--load);stroke:var(--load);stroke-width:1.5px}\n"
    ".open{fill:none;stroke:var(--load);stroke-width:2.5px}\n";

const std::string legend_of_faults =
    "<p><span class=\"swatch\" style=\"background:#f0b9a8\"></span> cells with "
    "a fault, or beside a gap</p><p><span class=\"swatch line "
    "of-gap\"></span> overlaps, gaps and open lines</p>";

/** The box around all that can be drawn. */
dealii::BoundingBox<2> box_of(const DrawingCheck &check)
{
  std::vector<Point<2>> points;
  for (const auto &ring : check.rings)
    points.insert(points.end(), ring.begin(), ring.end());
  for (const DrawingFault &fault : check.faults)
    points.insert(points.end(), fault.line.begin(), fault.line.end());
  if (points.empty())
    return dealii::BoundingBox<2>({Point<2>(), Point<2>(1., 1.)});
  return dealii::BoundingBox<2>(points);
}
} // namespace

Picture picture_of(const DrawingCheck &check)
{
  std::vector<bool> is_faulty(check.rings.size(), false);
  for (const DrawingFault &fault : check.faults)
    for (const unsigned int c : fault.cells)
      if (c < is_faulty.size())
        is_faulty[c] = true;

  Picture picture(box_of(check));
  Drawing &drawing = picture.drawing;
  drawing.open("id=\"blocks\"");
  for (std::size_t c = 0; c < check.rings.size(); ++c)
    if (check.rings[c].size() > 2)
      drawing.polygon(check.rings[c], is_faulty[c] ? "faulty" : "");
  drawing.close();
  drawing.open("id=\"joints\""); // the page looks for it
  drawing.close();
  drawing.open("id=\"faults\"");
  for (const DrawingFault &fault : check.faults)
    if (fault.outline.size() > 2)
      drawing.polygon(fault.outline, "covered");
  for (const DrawingFault &fault : check.faults)
    if (fault.line.size() > 1)
      drawing.polyline(fault.line, "open");
  drawing.close();
  picture.views.push_back({"faults", "Faults", legend_of_faults});
  picture.style = style_of_faults;
  return picture;
}
} // namespace Voussoir
