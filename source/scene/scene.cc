// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/geometry.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/cell_tree.h>
#include <voussoir/packing/connected_groups.h>
#include <voussoir/scene/scene.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace Voussoir
{
using dealii::Tensor;

namespace
{
/**
 * The largest total force, relative to the sum of the sizes of all forces on a
 * group of cells, that counts as rounding.
 */
constexpr double balance_tolerance = 1e-10;

/** The sum of forces on one cell, over their sizes, that counts as cancelled.
 */
constexpr double cancellation_tolerance = 1e-14;

/** The largest number of unbalanced groups that a message names. */
constexpr unsigned int n_named_groups = 5;

/** Refuse a force whose square cannot be computed. */
template <typename What>
void check_size(const Tensor<1, 2> &force, const What &what)
{
  const bool is_zero = force[0] == 0. && force[1] == 0.;
  if (!std::isfinite(force.norm()) || (!is_zero && !(force.norm() > 0.)))
    throw InputError(
        text(what(), " is (", force[0], ", ", force[1],
             "), a force whose square is beyond the computer's numbers. Choose "
             "units in which it is between 1e-150 and 1e150."));
}

/** The load on a connected group of cells. */
struct GroupLoad
{
  Tensor<1, 2> total;
  /** The sum of the sizes of all forces. */
  double size = 0.;
  unsigned int n_members = 0;
};

/** The distance from any other cell, over the size, that is a contact. */
constexpr double touches = 1e-9;

/** The width of what may be a joint, over the size of a cell. */
constexpr double widest_joint = 0.2;

/** A sentence on the cell that is the nearest to a connected group of cells. */
std::string describe_nearest(const Packing<2> &packing,
                             const std::vector<unsigned int> &group,
                             const unsigned int g)
{
  std::vector<std::vector<dealii::Point<2>>> rings(packing.n_cells());
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
      rings[c].push_back(packing.vertex(c, i));
  const CellTree cells(std::move(rings));
  std::optional<NearestCell> found;
  unsigned int of = g;
  for (const Packing<2>::BoundaryEdge &edge : packing.boundary_edges())
  {
    if (group[edge.cell] != g)
      continue;
    const auto nearest = cells.nearest(
        edge.cell, [&](const unsigned int c) { return group[c] != g; });
    if (nearest && (!found || nearest->distance < found->distance))
    {
      found = nearest;
      of = edge.cell;
    }
  }
  if (!found)
    return "";
  const std::string place =
      text(packing.describe(found->cell), " at ", text_of_point(found->place));
  if (found->distance <= touches * std::sqrt(packing.area(of)))
    return text(" Cell ", of, " meets ", place,
                " in a point only, which carries nothing; with 'Rotations = "
                "true' a corner on a side does.");
  return text(" The nearest to it is ", place, ", where cell ", of, " is ",
              found->distance, " away",
              found->distance > widest_joint * std::sqrt(packing.area(of))
                  ? "."
                  : "; if that is a joint of a drawing, set "
                    "'Packing/polygons/Joint width' to at least that.");
}

/** How much of the loads on blocks @p share of the sum of their sizes is. */
std::string share_in_words(const double share)
{
  return share > 1. - balance_tolerance
             ? "nothing balances any of them."
             : text(100. * share, " per cent of them are not balanced.");
}

/** The message that the groups @p floating, by their first cells, move. */
std::string describe_unbalanced(const Packing<2> &packing,
                                const std::vector<GroupLoad> &loads,
                                const std::vector<unsigned int> &group,
                                const std::vector<unsigned int> &floating)
{
  const GroupLoad &first = loads[floating.front()];
  const auto name = [&](const unsigned int g) {
    return text(loads[g].n_members > 1 ? "the connected group of cells around "
                                       : "",
                packing.describe(g), " at ", text_of_point(packing.centre(g)));
  };
  const bool is_all = first.n_members == packing.n_cells();
  std::string message =
      text("The loads are not balanced: on ",
           is_all ? "the packing" : name(floating.front()),
           first.n_members == 1 && !is_all ? ", which touches no other," : "",
           " their sum is (", first.total[0], ", ", first.total[1],
           "): ", share_in_words(first.total.norm() / first.size));
  if (floating.size() > 1)
    message += text(" So it is on ", floating.size() - 1, " more:");
  for (unsigned int k = 1; k < floating.size() && k < n_named_groups; ++k)
    message += text(k > 1 ? "; " : " ", name(floating[k]));
  if (floating.size() > 1)
    message += floating.size() > n_named_groups ? "; ...." : ".";
  return message +
         (packing.n_supports() == 0
              ? " Nothing supports the packing, so the total force must be "
                "zero; change the loads, or choose 'Supports/Where'."
              : " What floats touches neither the ground nor what rests on it: "
                "support it by 'Supports/Where', balance its loads, or close "
                "the gap around it." +
                    describe_nearest(packing, group, floating.front()));
}

/** The largest distance of a point of a cell from its centre. */
double reach(const Packing<2> &packing, const unsigned int c)
{
  double largest = 0.;
  for (unsigned int i = 0; i < packing.n_sides(c); ++i)
    largest =
        std::max(largest, packing.vertex(c, i).distance(packing.centre(c)));
  return largest;
}
} // namespace

Scene::Scene(Packing<2> packing_in,
             std::vector<double> strength_in,
             Loads loads,
             const Kinematics &kinematics_in,
             std::vector<Link> links_in)
    : packing(std::move(packing_in)), strength(std::move(strength_in)),
      kinematics(&kinematics_in), links(std::move(links_in)),
      traction(std::move(loads.traction)),
      traction_moment(std::move(loads.traction_moment)),
      on_cells(std::move(loads.on_cells)), body(std::move(loads.body)),
      has_body_force(!body.empty()), load(packing.n_cells()),
      load_size(packing.n_cells(), 0.), group(linked_groups(packing, links))
{
  for (const Link &link : links)
    link_names.push_back(link.name);
  traction_moment.resize(packing.boundary_edges().size());
  for (const CellForce &f : on_cells)
    for (const unsigned int c : f.cells)
      if (f.place)
        body.add(packing, c, f.force, *f.place);
      else
        body.add(packing, c, f.force);
  add_up_loads();
  check_balance();
  if (turns())
    check_moments();
  clear_single_cells();
  if (loads.requested)
    load_residual = residual_of_loads(*loads.requested);
}

void Scene::add_up_loads()
{
  const auto add = [&](const unsigned int c, const Tensor<1, 2> &force,
                       const auto &what) {
    check_size(force, what);
    load[c] += force;
    load_size[c] += force.norm();
  };
  const auto &boundary = packing.boundary_edges();
  for (unsigned int b = 0; b < boundary.size(); ++b)
    add(boundary[b].cell, boundary[b].length * traction[b], [&] {
      return text("The traction on the boundary edge at ",
                  text_of_point(boundary[b].midpoint()), " of cell ",
                  boundary[b].cell);
    });
  if (!body.empty())
    for (unsigned int c = 0; c < packing.n_cells(); ++c)
      add(c, body.force(packing, c), [&] {
        return text("The force inside ", packing.describe(c), " at ",
                    text_of_point(packing.centre(c)));
      });

  // Rounding must not pass for a load where all forces on a cell cancel.
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    if (load[c].norm() <= cancellation_tolerance * load_size[c])
      load[c] = 0.;
  if (!turns())
    return;
  load_torque = residual_torques(*this, no_forces(*this));
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    if (std::abs(load_torque[c]) <=
        cancellation_tolerance * load_size[c] * reach(packing, c))
      load_torque[c] = 0.;
}

void Scene::check_balance() const
{
  std::vector<GroupLoad> loads(group.size());
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    loads[group[c]].total += load[c];
    loads[group[c]].size += load_size[c];
    ++loads[group[c]].n_members;
  }
  std::vector<unsigned int> floating;
  for (unsigned int g = 0; g < packing.n_cells(); ++g)
    if (g != group[packing.ground()] &&
        loads[g].total.norm() > balance_tolerance * loads[g].size)
      floating.push_back(g);
  if (!floating.empty())
    throw InputError(describe_unbalanced(packing, loads, group, floating));
}

/**
 * Check that the moments balance, about the centre of the lowest cell of each
 * group; the forces are balanced.
 */
void Scene::check_moments() const
{
  std::vector<double> moment(group.size(), 0.), size(group.size(), 0.);
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    const unsigned int g = group[c];
    const dealii::Point<2> &about = packing.centre(g);
    moment[g] += load_torque[c] + cross(packing.centre(c) - about, load[c]);
    size[g] +=
        load_size[c] * (reach(packing, c) + packing.centre(c).distance(about));
  }
  for (unsigned int g = 0; g < packing.n_cells(); ++g)
    if (g != group[packing.ground()] &&
        std::abs(moment[g]) > balance_tolerance * size[g])
      throw InputError(text(
          "The moments of the loads are not balanced, and 'Rotations' is true: "
          "about ",
          text_of_point(packing.centre(g)), ", the centre of ",
          packing.describe(g), ", they add up to ", moment[g],
          " on blocks that nothing supports, ",
          100. * std::abs(moment[g]) / size[g],
          " per cent of the largest that such loads can have. Change the "
          "loads, choose 'Supports/Where', or set 'Rotations = false'."));
}

/** A cell by itself carries nothing: what is left of its load is rounding. */
void Scene::clear_single_cells()
{
  std::vector<unsigned int> n_members(group.size(), 0);
  for (const unsigned int g : group)
    ++n_members[g];
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    if (n_members[group[c]] == 1)
    {
      load[c] = 0.;
      if (turns())
        load_torque[c] = 0.;
    }
}

double Scene::residual_of_loads(const Resultant &requested) const
{
  // What acts on edges and in cells, of which the files and the stress are; and
  // what is balanced, in which a force has a place only where blocks turn.
  Resultant acting(reference_point(packing)), balanced = acting;
  for (unsigned int b = 0; b < packing.boundary_edges().size(); ++b)
    acting.add(packing.boundary_edges()[b], traction[b], traction_moment[b]);
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    if (!body.empty())
      acting.add(packing.centre(c), body.force(packing, c), body.torque(c));
    balanced.add(packing.centre(c), load[c], turns() ? load_torque[c] : 0.);
  }
  const double size = std::max(requested.size(), acting.size());
  if (!(size > 0.))
    return 0.;
  const dealii::BoundingBox<2> box = packing.box();
  const double diagonal = std::hypot(box.side_length(0), box.side_length(1));
  const auto difference = [&](const Resultant &sum, const bool has_moment) {
    const double force = (sum.force() - requested.force()).norm();
    const double moment = std::abs(sum.moment() - requested.moment());
    return std::max(force, has_moment ? moment / diagonal : 0.);
  };
  return std::max(difference(acting, true), difference(balanced, turns())) /
         size;
}

Scene loaded_by_links(Scene scene, const InterfaceForces &forces)
{
  const auto add = [&](const unsigned int c, const dealii::Point<2> &x,
                       const Tensor<1, 2> &force) {
    if (c == scene.packing.ground())
      return;
    scene.body.add(scene.packing, c, force, x);
    scene.load[c] += force;
    scene.load_size[c] += force.norm();
    if (scene.turns())
      scene.load_torque[c] += cross(x - scene.packing.centre(c), force);
  };
  for (unsigned int k = 0; k < scene.links.size(); ++k)
  {
    const Link &link = scene.links[k];
    const Tensor<1, 2> force = forces.in_links[k] * link.direction;
    add(link.cell_minus, link.on_minus, force);
    add(link.cell_plus, link.on_plus, -force);
  }
  scene.links.clear();
  return scene;
}

std::vector<double> largest_loads(const Scene &scene)
{
  std::vector<double> largest;
  largest.reserve(scene.load.size());
  for (const Tensor<1, 2> &force : scene.load)
    largest.push_back(force.norm());
  for (const Link &link : scene.links)
    for (const unsigned int c : {link.cell_minus, link.cell_plus})
      if (c != scene.packing.ground())
        largest[c] = std::max(largest[c], std::abs(link.rest()));
  return largest;
}

InterfaceForces no_forces(const Scene &scene)
{
  InterfaceForces none;
  none.normal.resize(scene.packing.interfaces().size());
  none.tangential.resize(scene.packing.interfaces().size());
  none.in_links.resize(scene.links.size());
  return none;
}

std::vector<double> residual_torques(const Scene &scene,
                                     const InterfaceForces &forces)
{
  const Packing<2> &packing = scene.packing;
  std::vector<double> torques(packing.n_cells(), 0.);
  for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
  {
    const Packing<2>::Interface &i = packing.interfaces()[e];
    torques[i.cell_minus] +=
        forces.torque_on_cell_minus(i, e, packing.centre(i.cell_minus));
    if (i.cell_plus != packing.ground())
      torques[i.cell_plus] -=
          forces.torque_on_cell_minus(i, e, packing.centre(i.cell_plus));
  }
  for (unsigned int k = 0; k < scene.links.size(); ++k)
  {
    const Link &link = scene.links[k];
    const auto torque = [&](const unsigned int c, const dealii::Point<2> &x) {
      return forces.in_links[k] * cross(x - packing.centre(c), link.direction);
    };
    torques[link.cell_minus] += torque(link.cell_minus, link.on_minus);
    if (link.cell_plus != packing.ground())
      torques[link.cell_plus] -= torque(link.cell_plus, link.on_plus);
  }
  for (unsigned int b = 0; b < packing.boundary_edges().size(); ++b)
  {
    const Packing<2>::BoundaryEdge &edge = packing.boundary_edges()[b];
    torques[edge.cell] +=
        cross(edge.midpoint() - packing.centre(edge.cell),
              edge.length * scene.traction[b]) +
        cross((edge.end - edge.start) / edge.length, scene.traction_moment[b]);
  }
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    torques[c] += scene.body.torque(c);
  return torques;
}
} // namespace Voussoir
