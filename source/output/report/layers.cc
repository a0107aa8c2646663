// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/report/layer.h>
#include <voussoir/output/report/layers.h>
#include <voussoir/output/report/load_arrows.h>
#include <voussoir/stress/stress_invariants.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
using dealii::Point;
using dealii::Tensor;

/** The thickness of the ground that is drawn, over the extent. */
constexpr double ground_depth = 0.012;

/** The longest arrow of a load, in cells, and its bounds over the extent. */
constexpr double arrow_in_cells = 1.5, shortest_arrow = 0.03,
                 longest_arrow = 0.12;

/** The longest resultant and cross, in cells. */
constexpr double resultant_in_cells = 1.2, cross_in_cells = 0.8;

/** A force, over the largest, that bears nothing to look at. */
constexpr double least_force = 1e-3;

/** The widths of lines of force. */
constexpr unsigned int n_widths = 5;

/** What further joints bear, over the second most, beside which a block has two
 * that matter. */
constexpr double least_beside_two = 0.1;

/** The resultant on the cell c- of an interface, and where it acts. */
struct JointResultant
{
  JointResultant(const Packing<2>::Interface &interface,
                 const InterfaceForces &forces,
                 const unsigned int e)
      : force(forces.on_cell_minus(interface, e)),
        place(interface.midpoint() + forces.eccentricity(interface, e) *
                                         (interface.end - interface.start))
  {}

  Tensor<1, 2> force;
  Point<2> place;
};

/** The class of the width of a line that shows the size of a force. */
std::string width_of(const double force, const double largest)
{
  const double share = largest > 0. ? force / largest : 0.;
  return text(
      'w', std::clamp<unsigned int>(std::ceil(n_widths * share), 1, n_widths));
}

std::vector<JointResultant> resultants_of(const Packing<2> &packing,
                                          const InterfaceForces &forces,
                                          double &largest)
{
  const auto &interfaces = packing.interfaces();
  std::vector<JointResultant> all;
  all.reserve(interfaces.size());
  largest = 0.;
  for (unsigned int e = 0; e < interfaces.size(); ++e)
  {
    all.emplace_back(interfaces[e], forces, e);
    largest = std::max(largest, all.back().force.norm());
  }
  return all;
}

} // namespace

dealii::BoundingBox<2> box_of(const Scene &scene)
{
  auto corners = scene.packing.box().get_boundary_points();
  const auto add = [&](const Point<2> &x) {
    for (unsigned int d = 0; d < 2; ++d)
    {
      corners.first[d] = std::min(corners.first[d], x[d]);
      corners.second[d] = std::max(corners.second[d], x[d]);
    }
  };
  for (const Link &link : scene.links)
    for (const Point<2> &x : {link.on_minus, link.on_plus})
      add(x);
  for (const auto &column : scene.fill_columns)
    for (const Point<2> &x : column)
      add(x);
  return {corners};
}

double typical_size(const Packing<2> &packing)
{
  return std::sqrt(packing.area() / packing.n_cells());
}

void draw_supports(Drawing &drawing,
                   const Packing<2> &packing,
                   const std::string &views)
{
  const Layer layer(drawing, "supports", views);
  const auto &interfaces = packing.interfaces();
  for (unsigned int e = interfaces.size() - packing.n_supports();
       e < interfaces.size(); ++e)
  {
    const Packing<2>::Interface &i = interfaces[e];
    const Tensor<1, 2> below = ground_depth * drawing.extent() * i.normal;
    drawing.polygon({i.start, i.end, i.end + below, i.start + below}, "ground");
    drawing.line(i.start, i.end, "support");
  }
}

void draw_links(Drawing &drawing,
                const Scene &scene,
                const InterfaceForces *const forces,
                const std::string &views)
{
  if (scene.links.empty())
    return;
  const Layer layer(drawing, forces ? "link-forces" : "links", views);
  for (unsigned int k = 0; k < scene.links.size(); ++k)
  {
    const Link &link = scene.links[k];
    std::string kind = "link";
    if (forces)
    {
      const double used = link.utilisation(forces->in_links[k]);
      if (used > least_force)
        kind += forces->in_links[k] > 0. ? " pulls" : " pushes";
      if (used > 1. - least_force)
        kind += " yields";
    }
    const std::string number = text("data-link=\"", k, '"');
    drawing.line(link.on_minus, link.on_plus, kind, number);
    if (!link.is_of_fill)
      for (const Point<2> &x : {link.on_minus, link.on_plus})
        drawing.dot(x, "anchor", number);
  }
}

void draw_fill(Drawing &drawing, const Scene &scene, const std::string &views)
{
  if (scene.fill_columns.empty())
    return;
  const Layer layer(drawing, "fill", views);
  for (const auto &column : scene.fill_columns)
    drawing.polygon({column.begin(), column.end()}, "fill");
}

void draw_gaps(Drawing &drawing,
               const Packing<2> &packing,
               const std::string &views)
{
  const Layer layer(drawing, "gaps", views);
  for (const Gap &gap : packing.gaps())
    drawing.polygon({gap.outline.begin(), gap.outline.end()}, "gap");
}

double
draw_loads(Drawing &drawing, const Scene &scene, const std::string &views)
{
  const std::vector<LoadArrow> arrows = load_arrows(scene);
  double largest = 0.;
  for (const LoadArrow &arrow : arrows)
    largest = std::max(largest, arrow.force.norm());
  const Layer layer(drawing, "loads", views);
  const double longest = std::clamp(
      arrow_in_cells * typical_size(scene.packing),
      shortest_arrow * drawing.extent(), longest_arrow * drawing.extent());
  for (const LoadArrow &arrow : arrows)
  {
    const Tensor<1, 2> along = longest / largest * arrow.force;
    if (along.norm() < least_force * longest)
      continue;
    const char *kind = arrow.kind == LoadArrow::Kind::traction ? "load traction"
                       : arrow.kind == LoadArrow::Kind::body_force
                           ? "load weight"
                           : "load force";
    if (arrow.pushes)
      drawing.line(arrow.place - along, arrow.place, kind);
    else
      drawing.line(arrow.place, arrow.place + along, kind);
  }
  return largest;
}

double draw_resultants(Drawing &drawing,
                       const Scene &scene,
                       const InterfaceForces &forces,
                       const std::string &views)
{
  double largest;
  const std::vector<JointResultant> all =
      resultants_of(scene.packing, forces, largest);
  const Layer layer(drawing, "resultants", views);
  const double longest = resultant_in_cells * typical_size(scene.packing);
  for (unsigned int e = 0; e < all.size(); ++e)
  {
    if (all[e].force.norm() <= least_force * largest)
      continue;
    const Tensor<1, 2> half = 0.5 * longest / largest * all[e].force;
    drawing.line(all[e].place - half, all[e].place + half,
                 (forces.normal[e] > 0. ? "resultant tension " : "resultant ") +
                     width_of(all[e].force.norm(), largest));
  }
  return largest;
}

void draw_line_of_thrust(Drawing &drawing,
                         const Scene &scene,
                         const InterfaceForces &forces,
                         const std::string &views)
{
  const Layer layer(drawing, "thrust", views);
  if (!scene.turns())
    return;
  const Packing<2> &packing = scene.packing;
  double largest;
  const std::vector<JointResultant> all =
      resultants_of(packing, forces, largest);
  // The joints of a block by the sizes of their resultants.
  std::vector<std::pair<double, unsigned int>> bearing;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    bearing.clear();
    for (const Packing<2>::Side &side : packing.sides(c))
      if (!side.on_boundary)
        bearing.emplace_back(all[side.index].force.norm(), side.index);
    std::sort(bearing.rbegin(), bearing.rend());
    if (bearing.size() < 2 || bearing[1].first <= least_force * largest ||
        (bearing.size() > 2 &&
         bearing[2].first > least_beside_two * bearing[1].first))
      continue;
    drawing.line(all[bearing[0].second].place, all[bearing[1].second].place,
                 "thrust " + width_of(bearing[0].first, largest));
  }
}

void draw_principal_stresses(Drawing &drawing,
                             const Packing<2> &packing,
                             const std::vector<Tensor<2, 2>> &stresses,
                             const std::string &views)
{
  double largest = 0.;
  for (const Tensor<2, 2> &stress : stresses)
  {
    const StressInvariants of(stress);
    largest =
        std::max({largest, std::abs(of.principal_1), std::abs(of.principal_2)});
  }
  const Layer layer(drawing, "crosses", views);
  for (unsigned int c = 0; c < stresses.size(); ++c)
  {
    const Tensor<2, 2> &s = stresses[c];
    const StressInvariants of(s);
    // Of the axis of the larger principal stress, by Mohr's circle.
    const double angle = 0.5 * std::atan2(s[0][1] + s[1][0], s[0][0] - s[1][1]);
    const double size = cross_in_cells * std::sqrt(packing.area(c));
    // Blocks are the darker the larger their stress.
    const bool is_dark = std::max(std::abs(of.principal_1),
                                  std::abs(of.principal_2)) > 0.5 * largest;
    const std::string shade = is_dark ? " on-dark" : "";
    for (const auto &[value, turn] :
         {std::pair(of.principal_1, angle),
          std::pair(of.principal_2, angle + 0.5 * dealii::numbers::PI)})
    {
      if (std::abs(value) <= least_force * largest)
        continue;
      const Tensor<1, 2> half = 0.5 * size * std::abs(value) / largest *
                                Point<2>(std::cos(turn), std::sin(turn));
      drawing.line(packing.centre(c) - half, packing.centre(c) + half,
                   (value > 0. ? "cross tension" : "cross") + shade);
    }
  }
}

} // namespace Voussoir
