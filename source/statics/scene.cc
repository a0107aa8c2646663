// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/scene.h>

#include <cmath>
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

/** The same for what is left of the forces on one cell where they cancel. */
constexpr double cancellation_tolerance = 1e-14;

/** @param size the sum of the sizes of the forces on each cell. */
void check_balance(const Scene &scene, const std::vector<double> &size)
{
  const std::vector<unsigned int> group = connected_groups(scene.packing);
  std::vector<Tensor<1, 2>> total(group.size());
  std::vector<double> sizes(group.size(), 0.);
  for (unsigned int c = 0; c < group.size(); ++c)
  {
    total[group[c]] += scene.load[c];
    sizes[group[c]] += size[c];
  }

  bool connected = true;
  for (const unsigned int g : group)
    connected &= (g == 0);
  for (unsigned int g = 0; g < group.size(); ++g)
    if (total[g].norm() > balance_tolerance * sizes[g])
      throw InputError(text(
          "The loads are not balanced: on ",
          connected ? "the packing"
                    : text("the connected group of cells around cell ", g,
                           " at ", text_of_point(scene.packing.centre(g))),
          " their sum is (", total[g][0], ", ", total[g][1], "), ",
          total[g].norm() / sizes[g],
          " of the sum of their sizes. Nothing supports the packing, so the "
          "total force must be zero; change the loads, or raise "
          "'Loads/Quadrature points' if they vary within an edge."));
}

/** Torque (x - centre) x f about the centre, positive counterclockwise. */
double torque(const dealii::Point<2> &x,
              const dealii::Point<2> &centre,
              const Tensor<1, 2> &f)
{
  const Tensor<1, 2> arm = x - centre;
  return arm[0] * f[1] - arm[1] * f[0];
}
} // namespace

Scene::Scene(Packing packing_in,
             std::vector<double> strength_in,
             std::vector<Tensor<1, 2>> traction_in)
    : packing(std::move(packing_in)), strength(std::move(strength_in)),
      traction(std::move(traction_in)), load(packing.n_cells())
{
  const auto &boundary = packing.boundary_edges();
  std::vector<double> size(packing.n_cells(), 0.);
  for (unsigned int b = 0; b < boundary.size(); ++b)
  {
    const Tensor<1, 2> force = boundary[b].length * traction[b];
    const bool none = traction[b][0] == 0. && traction[b][1] == 0.;
    if (!std::isfinite(force.norm()) || (!none && !(force.norm() > 0.)))
      throw InputError(
          text("The traction on the boundary edge at ",
               text_of_point(boundary[b].midpoint()), " of cell ",
               boundary[b].cell, " is (", traction[b][0], ", ", traction[b][1],
               "), a force whose square is beyond the computer's numbers. "
               "Choose units in which it is between 1e-150 and 1e150."));
    load[boundary[b].cell] += force;
    size[boundary[b].cell] += force.norm();
  }
  // Rounding must not pass for a load where all forces on a cell cancel.
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    if (load[c].norm() <= cancellation_tolerance * size[c])
      load[c] = 0.;
  check_balance(*this, size);

  // A cell by itself carries nothing: what is left of its load is rounding.
  const std::vector<unsigned int> group = connected_groups(packing);
  std::vector<unsigned int> n_cells(group.size(), 0);
  for (const unsigned int g : group)
    ++n_cells[g];
  for (unsigned int c = 0; c < group.size(); ++c)
    if (n_cells[group[c]] == 1)
      load[c] = 0.;
}

Tensor<1, 2> InterfaceForces::on_cell_minus(const Packing::Interface &interface,
                                            const unsigned int e) const
{
  return normal[e] * interface.normal + tangential[e] * interface.tangent();
}

double utilisation(const Scene &scene,
                   const InterfaceForces &forces,
                   const unsigned int e)
{
  const double q = std::abs(forces.tangential[e]);
  return q > 0. ? q / (scene.strength[e] * scene.packing.interfaces()[e].length)
                : 0.;
}

std::vector<double> residual_torques(const Scene &scene,
                                     const InterfaceForces &forces)
{
  const Packing &packing = scene.packing;
  std::vector<double> torques(packing.n_cells(), 0.);
  for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
  {
    const Packing::Interface &i = packing.interfaces()[e];
    const Tensor<1, 2> f = forces.on_cell_minus(i, e);
    torques[i.cell_minus] +=
        torque(i.midpoint(), packing.centre(i.cell_minus), f);
    torques[i.cell_plus] -=
        torque(i.midpoint(), packing.centre(i.cell_plus), f);
  }
  for (unsigned int b = 0; b < packing.boundary_edges().size(); ++b)
  {
    const Packing::BoundaryEdge &edge = packing.boundary_edges()[b];
    torques[edge.cell] += torque(edge.midpoint(), packing.centre(edge.cell),
                                 edge.length * scene.traction[b]);
  }
  return torques;
}
} // namespace Voussoir
