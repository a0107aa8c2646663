// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/connected_groups.h>
#include <voussoir/scene/proofs/point_limits.h>
#include <voussoir/scene/proofs/space_certificate.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Voussoir
{
using dealii::Tensor;

namespace
{
/** A sum of vectors, with more digits. */
struct LongSum
{
  std::array<long double, 3> of = {};
  void add(const Tensor<1, 3> &v)
  {
    for (unsigned int i = 0; i < 3; ++i)
      of[i] += v[i];
  }
  /** Add a x b. */
  void add_product(const Tensor<1, 3> &a, const Tensor<1, 3> &b)
  {
    for (unsigned int i = 0; i < 3; ++i)
    {
      const unsigned int j = (i + 1) % 3, k = (i + 2) % 3;
      of[i] += static_cast<long double>(a[j]) * b[k] -
               static_cast<long double>(a[k]) * b[j];
    }
  }
  double norm() const
  {
    return static_cast<double>(
        std::sqrt(of[0] * of[0] + of[1] * of[1] + of[2] * of[2]));
  }
};

/** Those of a scene; a torque counts over the size of its cell. */
std::vector<double> reference_forces(const SpaceScene &scene,
                                     const FaceForces &forces)
{
  const Packing<3> &packing = scene.packing();
  std::vector<double> load;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    load.push_back(
        std::max(scene.loads.force[c].norm(),
                 scene.loads.torque[c].norm() / std::cbrt(packing.volume(c))));
  double largest_force = 0.;
  for (const PointForce &force : forces.list)
    largest_force = std::max(largest_force, force.force.norm());
  return Voussoir::reference_forces(
      connected_groups(packing, Ground::separates), load, largest_force);
}

double largest_excess(const SpaceBlocks &blocks,
                      const FaceForces &forces,
                      const unsigned int e)
{
  const PointLimits limits(blocks, e);
  const Tensor<1, 3> &normal = blocks.packing.interfaces()[e].normal;
  double excess = 0.;
  unsigned int k = forces.first[e];
  for (const FacePoint &point : blocks.points[e].pressure)
    excess = std::max(excess, limits.excess_of_pressure(forces.list[k++].force,
                                                        normal, point.share));
  if (k < forces.first[e + 1])
    for (const FacePoint &point : blocks.points[e].friction)
      excess =
          std::max(excess, limits.excess_of_friction(forces.list[k++].force,
                                                     normal, point.share));
  return excess;
}

bool are_finite(const FaceForces &forces)
{
  return std::all_of(
      forces.list.begin(), forces.list.end(), [](const PointForce &of) {
        return std::isfinite(of.force[0] + of.force[1] + of.force[2]);
      });
}
} // namespace

Certificate certify(const SpaceScene &scene, const FaceForces &forces)
{
  if (!are_finite(forces))
    return infinitely_wrong();
  using Kind = LargestError::Kind;
  const Packing<3> &packing = scene.packing();
  const std::vector<double> reference = reference_forces(scene, forces);
  std::vector<LongSum> sum(packing.n_cells()), moment(packing.n_cells());
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    sum[c].add(scene.loads.force[c]);
    moment[c].add(scene.loads.torque[c]);
  }
  Certificate certificate;
  RelativeErrors errors = {reference, scene.blocks->turns(), certificate};
  for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
  {
    const Packing<3>::Interface &i = packing.interfaces()[e];
    for (unsigned int k = forces.first[e]; k < forces.first[e + 1]; ++k)
    {
      const PointForce &of = forces.list[k];
      sum[i.cell_minus].add(of.force);
      moment[i.cell_minus].add_product(of.place - packing.centre(i.cell_minus),
                                       of.force);
      if (i.cell_plus == packing.ground())
        continue;
      sum[i.cell_plus].add(-of.force);
      moment[i.cell_plus].add_product(of.place - packing.centre(i.cell_plus),
                                      -of.force);
    }
    errors.add(certificate.admissibility_violation, Kind::limit,
               largest_excess(*scene.blocks, forces, e), i.cell_minus);
    certificate.max_utilisation =
        std::max(certificate.max_utilisation,
                 utilisation_of_face(*scene.blocks, forces, e));
  }
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    errors.add(certificate.equilibrium_residual, Kind::balance, sum[c].norm(),
               c);
    errors.add(certificate.max_torque, Kind::moment,
               moment[c].norm() / std::cbrt(packing.volume(c)), c);
  }
  if (scene.blocks->turns())
    certificate.moment_residual = certificate.max_torque;
  return certificate;
}

double utilisation_of_face(const SpaceBlocks &blocks,
                           const FaceForces &forces,
                           const unsigned int e)
{
  const Tensor<1, 3> force = forces.resultant(blocks.packing, e).force;
  const Tensor<1, 3> &normal = blocks.packing.interfaces()[e].normal;
  const double shear = across(force, normal).norm();
  const PointLimits limits(blocks, e);
  const double strength =
      limits.strength +
      limits.coefficient * std::max(limits.tension - force * normal, 0.);
  if (strength > 0.)
    return shear / strength;
  return shear > 0. ? 1. : 0.;
}
} // namespace Voussoir
