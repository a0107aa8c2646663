// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/report/layers.h>
#include <voussoir/output/report/load_arrows.h>
#include <voussoir/scene/proofs/displacement_jumps.h>
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

/** A jump, over the largest displacement, that is one. */
constexpr double least_jump = 1e-6;

class Layer
{
public:
  Layer(Drawing &drawing, const std::string &id, const std::string &views)
      : drawing(drawing)
  {
    drawing.open("id=\"" + id + "\" class=\"layer " + views + '"');
  }
  ~Layer() { drawing.close(); }

private:
  Drawing &drawing;
};

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

/** Where a point of a cell is after the motion, turned by the whole angle. */
Point<2> moved(const Packing<2> &packing,
               const Motion &motion,
               const double factor,
               const unsigned int c,
               const Point<2> &x)
{
  const Point<2> &centre = packing.centre(c);
  const double angle = motion.rotation.empty() ? 0. : motion.rotation[c];
  const double turn = factor * angle;
  const Tensor<1, 2> arm = x - centre;
  Point<2> place = centre + factor * motion.displacement[c];
  place[0] += std::cos(turn) * arm[0] - std::sin(turn) * arm[1];
  place[1] += std::sin(turn) * arm[0] + std::cos(turn) * arm[1];
  return place;
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
    drawing.line(link.on_minus, link.on_plus, kind);
    if (!link.is_of_fill)
      for (const Point<2> &x : {link.on_minus, link.on_plus})
        drawing.dot(x, "anchor");
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
                 forces.normal[e] > 0. ? "resultant tension" : "resultant");
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
  std::vector<Point<2>> bearing;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    bearing.clear();
    for (const Packing<2>::Side &side : packing.sides(c))
      if (!side.on_boundary &&
          all[side.index].force.norm() > least_force * largest)
        bearing.push_back(all[side.index].place);
    if (bearing.size() == 2)
      drawing.line(bearing[0], bearing[1], "thrust");
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

void draw_motion(Drawing &drawing,
                 const Packing<2> &packing,
                 const Motion &motion,
                 const double factor,
                 const std::string &views)
{
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
    const bool start = jumps.openings[e][0] > least,
               end = jumps.openings[e][1] > least;
    if (start || end)
      drawing.line(place(i.start), place(i.end), "opens");
    else if (std::abs(jumps.sliding[e]) > least)
      drawing.line(place(i.start), place(i.end), "slides");
    if (start != end)
      drawing.dot(place(start ? i.end : i.start), "hinge");
  }
}
} // namespace Voussoir
