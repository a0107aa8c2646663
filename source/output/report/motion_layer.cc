// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/report/layer.h>
#include <voussoir/output/report/motion_layer.h>
#include <voussoir/scene/proofs/displacement_jumps.h>

#include <cmath>
#include <vector>

namespace Voussoir
{
namespace
{
using dealii::Point;
using dealii::Tensor;

/** A jump, over the largest displacement, that is one. */
constexpr double least_jump = 1e-6;

/**
 * Where a point of a cell is after the motion, turned by the whole angle; the
 * ground stays.
 */
Point<2> moved(const Packing<2> &packing,
               const Motion &motion,
               const double factor,
               const unsigned int c,
               const Point<2> &x)
{
  if (c == packing.ground())
    return x;
  const Point<2> &centre = packing.centre(c);
  const double angle = motion.rotation.empty() ? 0. : motion.rotation[c];
  const double turn = factor * angle;
  const Tensor<1, 2> arm = x - centre;
  Point<2> place = centre + factor * motion.displacement[c];
  place[0] += std::cos(turn) * arm[0] - std::sin(turn) * arm[1];
  place[1] += std::sin(turn) * arm[0] + std::cos(turn) * arm[1];
  return place;
}

/** The blocks. */
void draw_moved_blocks(Drawing &drawing,
                       const Packing<2> &packing,
                       const Motion &motion,
                       const double factor,
                       const std::string &views)
{
  const Layer layer(drawing, "moved", views);
  std::vector<Point<2>> corners;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    corners.clear();
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
      corners.push_back(
          moved(packing, motion, factor, c, packing.vertex(c, i)));
    drawing.polygon(corners, "");
  }
}

/** The joints that open or slide, drawn on the cells c-. */
void draw_jumps(Drawing &drawing,
                const Packing<2> &packing,
                const Motion &motion,
                const double factor,
                const std::string &views)
{
  const Layer layer(drawing, "jumps", views);
  const InterfaceJumps jumps = jumps_of(packing, motion);
  const double least = least_jump * jumps.largest_displacement;
  const auto &interfaces = packing.interfaces();
  for (unsigned int e = 0; e < interfaces.size(); ++e)
  {
    const Packing<2>::Interface &i = interfaces[e];
    const auto place = [&](const Point<2> &x) {
      return moved(packing, motion, factor, i.cell_minus, x);
    };
    const std::string attributes =
        text("data-joint=\"", e, "\" data-cells=\"", i.cell_minus, '"');
    const bool start = jumps.openings[e][0] > least,
               end = jumps.openings[e][1] > least;
    if (start || end)
      drawing.line(place(i.start), place(i.end), "opens", attributes);
    else if (std::abs(jumps.sliding[e]) > least)
      drawing.line(place(i.start), place(i.end), "slides", attributes);
    if (start != end)
      drawing.dot(place(start ? i.end : i.start), "hinge", attributes);
  }
}

/** Links, which go with their cells. */
void draw_moved_links(Drawing &drawing,
                      const Scene &scene,
                      const Motion &motion,
                      const double factor,
                      const std::string &views)
{
  if (scene.links.empty())
    return;
  const Layer layer(drawing, "moved-links", views);
  const auto number = [&](const unsigned int c) {
    return c == scene.packing.ground() ? -1 : int(c);
  };
  for (unsigned int k = 0; k < scene.links.size(); ++k)
  {
    const Link &link = scene.links[k];
    const auto place = [&](const unsigned int c, const Point<2> &x) {
      return moved(scene.packing, motion, factor, c, x);
    };
    drawing.line(place(link.cell_minus, link.on_minus),
                 place(link.cell_plus, link.on_plus), "link",
                 text("data-link=\"", k, "\" data-cells=\"",
                      number(link.cell_minus), ' ', number(link.cell_plus),
                      '"'));
  }
}
} // namespace

void draw_motion(Drawing &drawing,
                 const Scene &scene,
                 const Motion &motion,
                 const double factor,
                 const std::string &views)
{
  draw_moved_blocks(drawing, scene.packing, motion, factor, views);
  draw_moved_links(drawing, scene, motion, factor, views);
  draw_jumps(drawing, scene.packing, motion, factor, views);
}
} // namespace Voussoir
