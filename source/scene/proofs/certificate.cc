// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/scene/proofs/certificate.h>
#include <voussoir/scene/proofs/displacement_jumps.h>
#include <voussoir/scene/proofs/utilisation.h>

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
/**
 * An imbalance of a cell, over the reference force, that is rounding; and what
 * solvers leave of cells without load, which feel others only. A load is light
 * if it is that far below the reference force.
 */
constexpr double rounding_of_imbalance = 1e-14, noise_of_imbalance = 1e-12,
                 light_load = 1e-6;

/** Those of a scene. */
std::vector<double> reference_forces(const Scene &scene,
                                     const InterfaceForces &forces)
{
  double largest_force = 0.;
  for (unsigned int e = 0; e < forces.normal.size(); ++e)
    largest_force = std::max({largest_force, std::abs(forces.normal[e]),
                              std::abs(forces.tangential[e])});
  for (const double force : forces.in_links)
    largest_force = std::max(largest_force, std::abs(force));
  return Voussoir::reference_forces(
      linked_groups(scene.packing, scene.links, Ground::separates),
      largest_loads(scene), largest_force);
}

bool are_finite(const InterfaceForces &forces)
{
  for (unsigned int e = 0; e < forces.normal.size(); ++e)
  {
    double sum = forces.normal[e] + forces.tangential[e];
    if (!forces.at_ends.empty())
      sum += forces.at_ends[e][0] + forces.at_ends[e][1];
    if (!std::isfinite(sum))
      return false;
  }
  return std::all_of(forces.in_links.begin(), forces.in_links.end(),
                     [](const double force) { return std::isfinite(force); });
}

/** The excess of the forces of an interface over their limits. */
double violation(const Scene &scene,
                 const InterfaceForces &forces,
                 const unsigned int e)
{
  const JointLimits limits = scene.limits(e);
  return std::max(limits.excess(forces.ends(e)),
                  std::abs(forces.tangential[e]) -
                      limits.shear_strength(forces.normal[e]));
}

/**
 * UnbalancedCell::own_force of each cell, and whether there is a light load on
 * it or beside it.
 */
struct OwnForces
{
  OwnForces(const Scene &scene,
            const InterfaceForces &forces,
            const std::vector<double> &reference)
      : size(scene.load_size), near_light(size.size(), false)
  {
    const Packing<2> &packing = scene.packing;
    std::vector<double> beside(size.size() + 1, 0.), pressed(beside);
    const auto light = [&](const unsigned int c) {
      return c != packing.ground() &&
                     scene.load_size[c] <= light_load * reference[c]
                 ? scene.load_size[c]
                 : 0.;
    };
    for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
    {
      const Packing<2>::Interface &i = packing.interfaces()[e];
      const double force = std::hypot(forces.normal[e], forces.tangential[e]);
      for (const auto &[c, other] : {std::pair(i.cell_minus, i.cell_plus),
                                     std::pair(i.cell_plus, i.cell_minus)})
      {
        pressed[c] = std::max(pressed[c], force);
        beside[c] = std::max(beside[c], light(other));
      }
    }
    for (unsigned int k = 0; k < scene.links.size(); ++k)
      for (const auto &[c, other] :
           {std::pair(scene.links[k].cell_minus, scene.links[k].cell_plus),
            std::pair(scene.links[k].cell_plus, scene.links[k].cell_minus)})
      {
        pressed[c] = std::max(pressed[c], std::abs(forces.in_links[k]));
        beside[c] = std::max(beside[c], light(other));
      }
    for (unsigned int c = 0; c < size.size(); ++c)
    {
      near_light[c] = light(c) > 0. || beside[c] > 0.;
      if (!(size[c] > 0.))
        size[c] = beside[c] > 0. ? beside[c] : pressed[c];
    }
  }

  std::vector<double> size;
  std::vector<bool> near_light;
};

/**
 * The imbalance of each cell that rounding leaves of forces that balance: n
 * forces F that are rounded, as are the two products of each and their sum,
 * leave at most (n + 4) / 2 times the precision times the sum of |F|, and of
 * torques that of |F| times the arm and the coordinates that it is from.
 */
std::vector<double> rounding_of_forces(const Scene &scene,
                                       const InterfaceForces &forces)
{
  const Packing<2> &packing = scene.packing;
  std::vector<double> sum = scene.load_size, torques(sum.size(), 0.);
  std::vector<unsigned int> n(sum.size(), 1);
  for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
  {
    const Packing<2>::Interface &i = packing.interfaces()[e];
    const std::array<double, 2> ends = forces.ends(e);
    const double size =
        std::abs(ends[0]) + std::abs(ends[1]) + std::abs(forces.tangential[e]);
    for (const unsigned int c : {i.cell_minus, i.cell_plus})
      if (c != packing.ground())
      {
        ++n[c];
        sum[c] += size;
        torques[c] += size *
                      (std::max(i.start.distance(packing.centre(c)),
                                i.end.distance(packing.centre(c))) +
                       i.midpoint().norm()) /
                      std::sqrt(packing.area(c));
      }
  }
  for (unsigned int k = 0; k < scene.links.size(); ++k)
  {
    const Link &link = scene.links[k];
    const double size = std::abs(forces.in_links[k]);
    for (const auto &[c, x] : {std::pair(link.cell_minus, link.on_minus),
                               std::pair(link.cell_plus, link.on_plus)})
      if (c != packing.ground())
      {
        ++n[c];
        sum[c] += size;
        torques[c] += size * (x.distance(packing.centre(c)) + x.norm()) /
                      std::sqrt(packing.area(c));
      }
  }
  for (unsigned int c = 0; c < sum.size(); ++c)
    sum[c] = std::numeric_limits<double>::epsilon() * 0.5 * (n[c] + 4.) *
             (scene.turns() ? std::max(sum[c], torques[c]) : sum[c]);
  return sum;
}

/**
 * The cells that are out of balance by their own measure.
 *
 * @param sum of all forces on each cell.
 * @param torques of all forces on each cell.
 * @param reference force of each cell.
 */
std::vector<UnbalancedCell>
unbalanced_cells(const Scene &scene,
                 const InterfaceForces &forces,
                 const std::vector<Tensor<1, 2>> &sum,
                 const std::vector<double> &torques,
                 const std::vector<double> &reference)
{
  const OwnForces own(scene, forces, reference);
  std::vector<double> defect;
  for (const Tensor<1, 2> &left : sum)
    defect.push_back(left.norm());
  if (scene.turns())
    for (unsigned int c = 0; c < torques.size(); ++c)
      defect[c] = std::max(defect[c], std::abs(torques[c]) /
                                          std::sqrt(scene.packing.area(c)));
  for (unsigned int e = 0; e < forces.normal.size(); ++e)
  {
    const Packing<2>::Interface &i = scene.packing.interfaces()[e];
    for (const unsigned int c : {i.cell_minus, i.cell_plus})
      defect[c] = std::max(defect[c], violation(scene, forces, e));
  }
  for (unsigned int k = 0; k < scene.links.size(); ++k)
    for (const unsigned int c :
         {scene.links[k].cell_minus, scene.links[k].cell_plus})
      defect[c] =
          std::max(defect[c], scene.links[k].excess(forces.in_links[k]));
  const std::vector<double> rounded = rounding_of_forces(scene, forces);
  std::vector<UnbalancedCell> unbalanced;
  for (unsigned int c = 0; c < own.size.size(); ++c)
  {
    const double rounding =
        own.near_light[c] ? rounding_of_imbalance : noise_of_imbalance;
    if (defect[c] > largest_accepted_error * own.size[c] &&
        defect[c] > std::max(rounding * reference[c], rounded[c]))
      unbalanced.push_back({c, defect[c], own.size[c]});
  }
  return unbalanced;
}
} // namespace

Certificate certify(const Scene &scene, const InterfaceForces &forces)
{
  if (!are_finite(forces))
  {
    Certificate wrong = infinitely_wrong();
    wrong.load_residual = scene.load_residual;
    return wrong;
  }
  using Kind = LargestError::Kind;
  const Packing<2> &packing = scene.packing;
  const std::vector<double> reference = reference_forces(scene, forces);
  Certificate certificate;
  RelativeErrors errors = {reference, scene.turns(), certificate};

  const Utilisation utilisation(scene, forces);
  std::vector<Tensor<1, 2>> sum = scene.load;
  sum.emplace_back(); // of the ground, which takes any force
  for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
  {
    const Packing<2>::Interface &i = packing.interfaces()[e];
    const Tensor<1, 2> f = forces.on_cell_minus(i, e);
    sum[i.cell_minus] += f;
    sum[i.cell_plus] -= f;
    errors.add(certificate.admissibility_violation, Kind::limit,
               violation(scene, forces, e), i.cell_minus);
    certificate.max_utilisation =
        std::max(certificate.max_utilisation, utilisation(e));
  }

  for (unsigned int k = 0; k < scene.links.size(); ++k)
  {
    const Link &link = scene.links[k];
    const Tensor<1, 2> f = forces.in_links[k] * link.direction;
    sum[link.cell_minus] += f;
    sum[link.cell_plus] -= f;
    errors.add(certificate.admissibility_violation, Kind::limit,
               link.excess(forces.in_links[k]), link.cell_minus);
  }

  const std::vector<double> torques = residual_torques(scene, forces);
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    errors.add(certificate.equilibrium_residual, Kind::balance, sum[c].norm(),
               c);
    errors.add(certificate.max_torque, Kind::moment,
               std::abs(torques[c]) / std::sqrt(packing.area(c)), c);
  }
  if (scene.turns())
    certificate.moment_residual = certificate.max_torque;
  certificate.load_residual = scene.load_residual;
  certificate.unbalanced =
      unbalanced_cells(scene, forces, sum, torques, reference);
  return certificate;
}

namespace
{
double largest_load(const Scene &scene)
{
  const std::vector<double> of_cells = largest_loads(scene);
  return of_cells.empty() ? 0.
                          : *std::max_element(of_cells.begin(), of_cells.end());
}

WorkOfMotion work_in_joints(const Scene &scene, const Motion &motion)
{
  const InterfaceJumps jumps = jumps_of(scene.packing, motion);
  WorkOfMotion of;
  of.largest = jumps.largest_displacement;
  for (unsigned int e = 0; e < jumps.sliding.size(); ++e)
  {
    const JointLimits::Resistance joint =
        scene.limits(e).resistance(jumps.openings[e], jumps.sliding[e]);
    of.dissipation += joint.dissipation;
    of.closing = std::max(of.closing, joint.closing);
    of.all_closings += joint.closing;
  }
  for (unsigned int k = 0; k < scene.links.size(); ++k)
    of.dissipation += scene.links[k].dissipation(elongation(scene, k, motion));
  return of;
}
} // namespace

MechanismCertificate certify_mechanism(const Scene &scene, const Motion &motion)
{
  MechanismCertificate certificate =
      certificate_of(work_in_joints(scene, motion),
                     work_of_loads(scene, motion), largest_load(scene));
  certificate.load_residual = scene.load_residual;
  return certificate;
}

FactorBound
bound_of_factor(const Scene &dead, const Scene &live, const Motion &motion)
{
  return bound_by(work_in_joints(dead, motion), work_of_loads(dead, motion),
                  work_of_loads(live, motion));
}
} // namespace Voussoir
