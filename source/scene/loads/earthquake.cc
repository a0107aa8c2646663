// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/scene/loads/earthquake.h>
#include <voussoir/scene/loads/segment_tractions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/** Weights, over their sum of sizes, that add up to nothing. */
constexpr double least_weight = 1e-12;

/** The lowest vertex of the blocks. */
double lowest(const Packing<2> &packing)
{
  double y = std::numeric_limits<double>::infinity();
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
      y = std::min(y, packing.vertex(c, i)[1]);
  return y;
}

/** The weights of a packing by height, and the loads made of them. */
class Inertia
{
public:
  Inertia(const Packing<2> &packing, const Loads &dead, const bool by_height)
      : packing(packing), dead(dead), base(lowest(packing)),
        by_height(by_height)
  {
    for (unsigned int c = 0; c < packing.n_cells(); ++c)
      add(-dead.body.force(packing, c)[1], height_of_body(c));
    for (const CellForce &of : dead.on_cells)
      for (const unsigned int c : of.cells)
        add(-of.force[1], of.place_in(packing, c)[1] - base);
    for (unsigned int b = 0; b < dead.traction.size(); ++b)
    {
      const auto &edge = packing.boundary_edges()[b];
      add(-edge.length * dead.traction[b][1], edge.midpoint()[1] - base);
    }
  }

  bool has_weight() const { return weight > least_weight * size; }
  bool has_height() const { return weight_by_height > 0.; }

  /** All weights, turned into the unit vector @p direction. */
  Loads along(const Tensor<1, 2> &direction) const
  {
    const Tensor<2, 2> turn({{0., -direction[0]}, {0., -direction[1]}});
    Loads loads = no_loads(packing);
    add_body(turn, loads);
    add_forces(turn, loads);
    add_tractions(turn, loads);
    return loads;
  }

private:
  void add(const double of, const double height)
  {
    weight += of;
    size += std::abs(of);
    weight_by_height += of * height;
  }
  void add_body(const Tensor<2, 2> &turn, Loads &loads) const
  {
    std::vector<double> share(packing.n_cells());
    for (unsigned int c = 0; c < packing.n_cells(); ++c)
    {
      share[c] = share_at(height_of_body(c));
      const Tensor<2, 2> moment = share[c] * (turn * dead.body.moment(c));
      loads.requested->add(packing.centre(c),
                           share[c] * (turn * dead.body.force(packing, c)),
                           moment[1][0] - moment[0][1]);
    }
    loads.body = dead.body.transformed(packing, turn, share);
  }
  void add_forces(const Tensor<2, 2> &turn, Loads &loads) const
  {
    for (const CellForce &of : dead.on_cells)
      for (const unsigned int c : of.cells)
      {
        const Point<2> place = of.place_in(packing, c);
        const Tensor<1, 2> force =
            share_at(place[1] - base) * (turn * of.force);
        loads.on_cells.push_back({of.name, {c}, force, of.place});
        loads.requested->add(place, force);
      }
  }
  void add_tractions(const Tensor<2, 2> &turn, Loads &loads) const
  {
    loads.traction_moment.resize(dead.traction_moment.size());
    for (unsigned int b = 0; b < dead.traction.size(); ++b)
    {
      const auto &edge = packing.boundary_edges()[b];
      const Tensor<2, 2> A = share_at(edge.midpoint()[1] - base) * turn;
      loads.traction[b] = A * dead.traction[b];
      Tensor<1, 2> first_moment;
      if (!dead.traction_moment.empty())
        first_moment = loads.traction_moment[b] = A * dead.traction_moment[b];
      loads.requested->add(edge, loads.traction[b], first_moment);
    }
  }
  /** The height of the centre of the body force's weight on a cell. */
  double height_of_body(const unsigned int c) const
  {
    const double of = dead.body.force(packing, c)[1];
    const double above = of != 0. ? dead.body.moment(c)[1][1] / of : 0.;
    return packing.centre(c)[1] + above - base;
  }
  /** What weights at a height are multiplied with; one in the mean. */
  double share_at(const double height) const
  {
    return by_height ? height * weight / weight_by_height : 1.;
  }

  const Packing<2> &packing;
  const Loads &dead;
  const double base;
  const bool by_height;
  double weight = 0., size = 0., weight_by_height = 0.;
};
} // namespace

void Earthquake::add_parameters(dealii::ParameterHandler &prm)
{
  prm.enter_subsection("Live loads");
  prm.enter_subsection("Earthquake");
  add_choice<Pattern>(
      prm, "Pattern", pattern,
      {{Pattern::none, "none", "none."},
       {Pattern::mass, "mass",
        "in proportion to the weights: the factor is the acceleration in "
        "shares of gravity.",
        "Direction"},
       {Pattern::mass_and_height, "mass and height",
        "in proportion to the weights times their heights above the lowest "
        "point of the blocks, in all as large as the weights: the factor is "
        "the base shear over the weight.",
        "Direction"}},
      "Live loads that are made of what acts downwards in 'Loads', with its "
      "combination: the body force of each block, the forces on cells and the "
      "tractions, each where it acts. 'Fill' has no part in it.");
  prm.add_parameter("Direction", direction,
                    "Where they act to, \"x, y\", of any size. With 'Load "
                    "factor/Direction = least' they act the other way.",
                    dealii::Patterns::Anything());
  prm.leave_subsection();
  prm.leave_subsection();
}

Loads Earthquake::loads(const Packing<2> &packing, const Loads &dead) const
{
  const std::string section = "Live loads/Earthquake/";
  const auto along = pair_of_text(direction);
  if (!along || !(along->norm() > 0.))
    throw InputError("The parameter '" + section + "Direction' is '" +
                     direction +
                     "'; two finite numbers \"x, y\" are expected, not both "
                     "zero.");
  const Inertia inertia(packing, dead, pattern == Pattern::mass_and_height);
  if (!inertia.has_weight())
    throw InputError("'" + section +
                     "Pattern' needs weights, and what 'Loads' has does not "
                     "act downwards in all; give them in 'Loads/Body force', "
                     "as in 0; -20.");
  if (pattern == Pattern::mass_and_height && !inertia.has_height())
    throw InputError("'" + section +
                     "Pattern' is 'mass and height', and the weights in "
                     "'Loads' are not above the lowest point of the blocks; "
                     "take 'mass'.");
  return inertia.along(static_cast<const Tensor<1, 2> &>(*along) /
                       along->norm());
}
} // namespace Voussoir
