// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/contact/contact_points.h>
#include <voussoir/statics/problem/discretise.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace Voussoir
{
using dealii::Tensor;

namespace
{
Tensor<1, 3> in_space(const Tensor<1, 2> &x)
{
  Tensor<1, 3> result;
  std::copy_n(x.begin_raw(), 2, result.begin_raw());
  return result;
}

/** A joint as its two bodies see it; nondimensional. */
struct JointFrame
{
  /** n_e, from c- to c+, and t_e. */
  Tensor<1, 2> normal, tangent;
  /** The ends of the joint, start and end along t_e, from the centre of a body.
   */
  std::array<Tensor<1, 2>, 2> from_minus, from_plus;

  /** The row of a point, in the direction @p d. */
  ContactRow row(const ContactPoint &point, const Tensor<1, 2> &d) const
  {
    const auto turn = [&](const std::array<Tensor<1, 2>, 2> &ends) {
      return cross((1. - point.place) * ends[0] + point.place * ends[1], d);
    };
    return {{{d[0], d[1], 0.}}, {{turn(from_minus)}}, {{turn(from_plus)}}};
  }

  /** Let the other body be c-. */
  void exchange_bodies()
  {
    normal *= -1.;
    tangent *= -1.;
    std::swap(from_minus, from_plus);
    std::swap(from_minus[0], from_minus[1]);
    std::swap(from_plus[0], from_plus[1]);
  }
};

/** Makes a problem of a scene. */
class Discretisation
{
public:
  Discretisation(const Scene &scene, const std::vector<bool> &moves);
  DiscreteProblem::Data data;

private:
  void choose_scales(const std::vector<bool> &moves);
  void add_interface(unsigned int interface);
  void add_link(const Link &link);
  /** True if contact @p k of an interface is at an open end. */
  bool is_open(const unsigned int interface, const unsigned int k) const
  {
    return !scene.open_ends.empty() && scene.open_ends[interface][k];
  }

  bool is_whole(const unsigned int interface) const
  {
    return !is_open(interface, 0) && !is_open(interface, 1);
  }

  const Scene &scene;
  dealii::Point<2> centroid;
  /** The body of each cell, and of the ground. */
  std::vector<unsigned int> body;
  /** Of one joint, where they are not allocated again for the next. */
  std::vector<ContactRow> rows;
};

/** Set the load of a cell, n_unknowns() numbers. */
void find_load(const Scene &scene,
               const unsigned int cell,
               const double length_unit,
               const double stress_unit,
               double *load)
{
  const Tensor<1, 2> force = scene.load[cell] / (stress_unit * length_unit);
  std::copy_n(force.begin_raw(), 2, load);
  if (scene.turns())
    load[2] =
        scene.load_torque[cell] / (stress_unit * length_unit * length_unit);
}

/**
 * Add the force of rest of a link to the loads on the cells at its ends.
 *
 * @param of_cell gives the load of a cell, n_unknowns() numbers, or null.
 */
template <typename LoadOfCell>
void add_rest(const Scene &scene,
              const Link &link,
              const double length_unit,
              const double stress_unit,
              const LoadOfCell &of_cell)
{
  const auto add = [&](const unsigned int cell, const dealii::Point<2> &x,
                       const double sign) {
    double *const load =
        cell == scene.packing.ground() ? nullptr : of_cell(cell);
    if (!load)
      return;
    const Tensor<1, 2> force =
        sign * link.rest() / (stress_unit * length_unit) * link.direction;
    for (unsigned int i = 0; i < 2; ++i)
      load[i] += force[i];
    if (scene.turns())
      load[2] += cross((x - scene.packing.centre(cell)) / length_unit, force);
  };
  add(link.cell_minus, link.on_minus, 1.);
  add(link.cell_plus, link.on_plus, -1.);
}

Discretisation::Discretisation(const Scene &scene,
                               const std::vector<bool> &moves)
    : scene(scene), body(scene.packing.n_cells() + 1)
{
  choose_scales(moves);
  const Packing<2> &packing = scene.packing;
  const double area = packing.area();
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    centroid += packing.area(c) / area * packing.centre(c);
  Structure::Part &part = data.part;
  part.kinematics = *scene.kinematics;
  const unsigned int n = part.kinematics.n_unknowns();
  part.centres.reserve(packing.n_cells() + 1);
  part.loads.reserve(n * (packing.n_cells() + 1));
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    if (moves[c])
    {
      body[c] = data.n_cells++;
      part.centres.push_back(
          in_space((packing.centre(c) - centroid) / data.length_unit));
      part.loads.resize(n * data.n_cells);
      find_load(scene, c, data.length_unit, data.stress_unit,
                &part.loads[n * body[c]]);
    }
  for (unsigned int c = 0; c <= packing.n_cells(); ++c)
    if (c == packing.ground() || !moves[c])
      body[c] = data.n_cells;
  const std::size_t n_interfaces = packing.interfaces().size();
  part.joints.reserve(n_interfaces + scene.links.size(),
                      n_interfaces *
                          (contact_points(scene.turns()).pressure.size() + 1),
                      part.kinematics);
  bool rests_on_ground = false;
  for (unsigned int e = 0; e < n_interfaces; ++e)
  {
    add_interface(e);
    rests_on_ground |= !part.joints.list.empty() &&
                       part.joints.list.back().cell_plus == data.n_cells;
  }
  for (const Link &link : scene.links)
    rests_on_ground |=
        body[link.cell_minus] != body[link.cell_plus] &&
        std::max(body[link.cell_minus], body[link.cell_plus]) == data.n_cells;
  if (rests_on_ground)
  {
    part.centres.emplace_back();
    part.loads.resize(part.loads.size() + n);
  }
  for (const Link &link : scene.links)
    add_link(link);
}

/** Joints with the ground have it as c+; those within it are none. */
void Discretisation::add_interface(const unsigned int interface)
{
  const Packing<2>::Interface &i = scene.packing.interfaces()[interface];
  unsigned int minus = body[i.cell_minus], plus = body[i.cell_plus];
  if (minus == data.n_cells && plus == data.n_cells)
    return;
  JointFrame frame = {i.normal, i.tangent(), {}, {}};
  const std::array<dealii::Point<2>, 2> ends = {{i.start, i.end}};
  const auto from = [&](const unsigned int cell, const unsigned int b,
                        const unsigned int k) {
    return b == data.n_cells
               ? (ends[k] - centroid) / data.length_unit
               : (ends[k] - scene.packing.centre(cell)) / data.length_unit;
  };
  for (unsigned int k = 0; k < 2; ++k)
  {
    frame.from_minus[k] = from(i.cell_minus, minus, k);
    frame.from_plus[k] = from(i.cell_plus, plus, k);
  }
  if (minus == data.n_cells)
  {
    std::swap(minus, plus);
    frame.exchange_bodies();
  }
  const ContactPoints &points = contact_points(scene.turns());
  rows.clear();
  for (unsigned int k = 0; k < points.pressure.size(); ++k)
    if (!is_open(interface, k))
      rows.push_back(frame.row(points.pressure[k], frame.normal));
  rows.push_back(frame.row(points.friction, frame.tangent));
  const double length = i.length / data.length_unit;
  data.part.joints.add(
      {minus, plus, length, scene.packing.distance(i) / data.length_unit,
       is_whole(interface)
           ? scene.strength[interface] / data.stress_unit * length
           : 0.,
       scene.coefficient.empty() ? 0. : scene.coefficient[interface]},
      rows, data.part.kinematics);
  if (!scene.open_ends.empty())
    data.open_ends.push_back(scene.open_ends[interface]);
  if (!scene.has_normal_limits() && scene.links.empty())
    return;
  const JointLimits limits = scene.limits(interface);
  const double force_unit = data.stress_unit * data.length_unit;
  data.limits.push_back(
      {limits.tension / force_unit, limits.crushing / force_unit});
}

/**
 * A tie is a contact that is pressed where its ends draw apart, and a prop one
 * where they draw together; each bears the smaller of its two bounds as
 * tension.
 */
void Discretisation::add_link(const Link &link)
{
  const double force_unit = data.stress_unit * data.length_unit;
  const double rest = link.rest() / force_unit;
  const double most = link.most / force_unit - rest;
  const double least = link.least / force_unit - rest;
  const bool is_tie = most >= -least;
  data.links.push_back({rest, is_tie ? -1. : 1.});
  unsigned int minus = body[link.cell_minus], plus = body[link.cell_plus];
  if (minus == plus)
    return;
  const auto arm = [&](const unsigned int cell, const unsigned int b,
                       const dealii::Point<2> &x) {
    return (x - (b == data.n_cells ? centroid : scene.packing.centre(cell))) /
           data.length_unit;
  };
  const Tensor<1, 2> from_minus = arm(link.cell_minus, minus, link.on_minus),
                     from_plus = arm(link.cell_plus, plus, link.on_plus);
  const Tensor<1, 2> normal = is_tie ? -link.direction : link.direction;
  // All of it is at one place of each body.
  JointFrame frame = {normal,
                      Tensor<1, 2>({-normal[1], normal[0]}),
                      {{from_minus, from_minus}},
                      {{from_plus, from_plus}}};
  if (minus == data.n_cells)
  {
    std::swap(minus, plus);
    frame.exchange_bodies();
  }
  Structure::Part &part = data.part;
  add_rest(
      scene, link, data.length_unit, data.stress_unit,
      [&](const unsigned int cell) {
        return body[cell] == data.n_cells
                   ? nullptr
                   : &part.loads[part.kinematics.n_unknowns() * body[cell]];
      });
  if (!(most > least))
    return;
  data.links.back().joint = part.joints.list.size();
  const ContactPoint &place = contact_points(false).friction;
  rows = {frame.row(place, frame.normal), frame.row(place, frame.tangent)};
  const double length = link.on_minus.distance(link.on_plus) / data.length_unit;
  part.joints.add({minus, plus, 1., length > 0. ? length : 1., 0.}, rows,
                  part.kinematics);
  data.limits.push_back({std::min(most, -least), std::max(most, -least)});
}

void Discretisation::choose_scales(const std::vector<bool> &moves)
{
  const double area = scene.packing.area();
  data.length_unit = std::sqrt(area / scene.packing.n_cells());
  double largest = 0.;
  for (const Packing<2>::Interface &i : scene.packing.interfaces())
    for (const dealii::Point<2> &x : {i.start, i.end})
      largest = std::max({largest, std::abs(x[0]), std::abs(x[1])});
  data.coordinate_rounding =
      std::numeric_limits<double>::epsilon() * largest / data.length_unit;

  // All forces on the packing over its size: of the order of the boundary
  // traction, or of the pressure at the foot of a wall under its own weight.
  double total = 0.;
  for (unsigned int c = 0; c < moves.size(); ++c)
    if (moves[c])
      total += scene.load[c].norm() +
               (scene.load_torque.empty()
                    ? 0.
                    : std::abs(scene.load_torque[c]) / data.length_unit);
  for (const Link &link : scene.links)
    total += std::abs(link.rest());
  data.is_loaded = total > 0.;
  if (data.is_loaded)
    data.stress_unit = total / std::sqrt(area);
}
} // namespace

DiscreteProblem discretise(const Scene &scene)
{
  return discretise(scene, std::vector<bool>(scene.packing.n_cells(), true));
}

DiscreteProblem discretise(const Scene &scene, const std::vector<bool> &moves)
{
  return DiscreteProblem(Discretisation(scene, moves).data);
}

std::vector<double> discretise_loads(const DiscreteProblem &problem,
                                     const Scene &scene)
{
  std::vector<double> loads(problem.n_dofs());
  for (unsigned int c = 0; c < problem.n_cells(); ++c)
    find_load(scene, c, problem.length_scale(), problem.stress_scale(),
              &loads[problem.dof(c, 0)]);
  for (const Link &link : scene.links)
    add_rest(scene, link, problem.length_scale(), problem.stress_scale(),
             [&](const unsigned int c) { return &loads[problem.dof(c, 0)]; });
  return loads;
}
} // namespace Voussoir
