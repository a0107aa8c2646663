// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/connected_groups.h>
#include <voussoir/scene/proofs/space_certificate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace Voussoir
{
using dealii::Tensor;

namespace
{
constexpr double infinity_of_errors = std::numeric_limits<double>::infinity();

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

/** The part of @p v across @p normal. */
Tensor<1, 3> across(const Tensor<1, 3> &v, const Tensor<1, 3> &normal)
{
  return v - (v * normal) * normal;
}

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

/** What the points of an interface admit; S L^2. */
struct PointLimits
{
  PointLimits(const SpaceBlocks &blocks, const unsigned int e)
      : coefficient(blocks.coefficient(e))
  {
    const double area = blocks.packing.interfaces()[e].area;
    tension = blocks.tensile(e) * area;
    strength = blocks.strength_under_tension(e) * area;
    crushing = blocks.strengths.compressive.empty()
                   ? infinity_of_errors
                   : blocks.strengths.compressive[e] * area;
  }
  double coefficient, tension, strength, crushing;

  /** The excess of a force at a point of pressure. */
  double excess_of_pressure(const Tensor<1, 3> &force,
                            const Tensor<1, 3> &normal,
                            const double share) const
  {
    const double pressure = -(force * normal) + tension * share;
    const double friction = across(force, normal).norm();
    return std::max({-pressure, -(force * normal) - crushing * share,
                     friction - coefficient * std::max(pressure, 0.)});
  }
  /** The excess of a force at a point of friction. */
  double excess_of_friction(const Tensor<1, 3> &force,
                            const Tensor<1, 3> &normal,
                            const double share) const
  {
    return std::max(std::abs(force * normal),
                    across(force, normal).norm() - strength * share);
  }
};

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

namespace
{
/** The displacement of c+ relative to c- at a place of an interface. */
Tensor<1, 3> jump_at(const Packing<3> &packing,
                     const SpaceMotion &motion,
                     const Packing<3>::Interface &i,
                     const dealii::Point<3> &place)
{
  const Tensor<1, 3> minus =
      motion.at(i.cell_minus, place - packing.centre(i.cell_minus));
  return i.cell_plus == packing.ground()
             ? -minus
             : motion.at(i.cell_plus, place - packing.centre(i.cell_plus)) -
                   minus;
}

/** Half of the integral of |x| over the triangle of the origin and a side. */
double moment_of_side(const Tensor<1, 3> &from,
                      const Tensor<1, 3> &to,
                      const Tensor<1, 3> &normal)
{
  const Tensor<1, 3> side = to - from;
  const double length = side.norm();
  if (!(length > 0.))
    return 0.;
  const Tensor<1, 3> along = side / length;
  const double h = cross_product_3d(from, along) * normal;
  if (h == 0.)
    return 0.;
  const auto at = [&](const Tensor<1, 3> &x) {
    const double t = (x * along) / std::abs(h);
    return t * std::sqrt(1. + t * t) + std::asinh(t);
  };
  return std::copysign(std::pow(std::abs(h), 3) / 6., h) * (at(to) - at(from));
}

/** The integral of the size of the slip over the whole of an interface. */
double integral_of_slip(const Packing<3> &packing,
                        const SpaceMotion &motion,
                        const unsigned int e)
{
  const Packing<3>::Interface &i = packing.interfaces()[e];
  const Tensor<1, 3> slip =
      across(jump_at(packing, motion, i, i.centroid), i.normal);
  double spin = 0.;
  if (!motion.rotation.empty())
    spin = ((i.cell_plus == packing.ground() ? Tensor<1, 3>()
                                             : motion.rotation[i.cell_plus]) -
            motion.rotation[i.cell_minus]) *
           i.normal;
  const auto polygon = packing.polygon(e);
  double reach = 0.;
  for (const dealii::Point<3> &x : polygon)
    reach = std::max(reach, x.distance(i.centroid));
  // Too far away the point about which it spins is lost in rounding.
  if (!(std::abs(spin) * reach > 1e-6 * slip.norm()))
    return slip.norm() * i.area;
  // slip + spin n x (x - c) = 0 at c + n x slip / spin.
  const dealii::Point<3> about =
      i.centroid + cross_product_3d(i.normal, slip) / spin;
  double sum = 0.;
  for (unsigned int k = 0; k < polygon.size(); ++k)
    sum += moment_of_side(polygon[k] - about,
                          polygon[(k + 1) % polygon.size()] - about, i.normal);
  return std::abs(spin) * std::abs(sum);
}

WorkOfMotion work_in_faces(const SpaceScene &scene,
                           const SpaceMotion &motion,
                           const bool are_continuous = false)
{
  const SpaceBlocks &blocks = *scene.blocks;
  const Packing<3> &packing = blocks.packing;
  WorkOfMotion of;
  for (const Tensor<1, 3> &u : motion.displacement)
    of.largest = std::max(of.largest, u.norm());
  for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
  {
    const Packing<3>::Interface &i = packing.interfaces()[e];
    const PointLimits limits(blocks, e);
    double closing = 0.;
    for (const FacePoint &point : blocks.points[e].pressure)
    {
      const Tensor<1, 3> jump = jump_at(packing, motion, i, point.place);
      of.largest = std::max(
          of.largest,
          motion.at(i.cell_minus, point.place - packing.centre(i.cell_minus))
              .norm());
      const double opening = jump * i.normal;
      const double resisted = std::max(
          limits.coefficient * across(jump, i.normal).norm() - opening, 0.);
      of.dissipation += limits.tension * point.share * opening;
      if (std::isfinite(limits.crushing))
        of.dissipation +=
            (limits.crushing + limits.tension) * point.share * resisted;
      else
        closing = std::max(closing, resisted);
    }
    of.closing = std::max(of.closing, closing);
    of.all_closings += closing;
    if (!(limits.strength > 0.))
      continue;
    if (are_continuous)
      of.dissipation +=
          limits.strength / i.area * integral_of_slip(packing, motion, e);
    else
      for (const FacePoint &point : blocks.points[e].friction)
        of.dissipation +=
            limits.strength * point.share *
            across(jump_at(packing, motion, i, point.place), i.normal).norm();
  }
  return of;
}
} // namespace

double work_of_loads(const SpaceScene &scene, const SpaceMotion &motion)
{
  long double work = 0.;
  for (unsigned int c = 0; c < motion.displacement.size(); ++c)
  {
    work += scene.loads.force[c] * motion.displacement[c];
    if (!motion.rotation.empty())
      work += scene.loads.torque[c] * motion.rotation[c];
  }
  return static_cast<double>(work);
}

std::vector<FaceJump> jumps_of_faces(const SpaceBlocks &blocks,
                                     const SpaceMotion &motion)
{
  const Packing<3> &packing = blocks.packing;
  std::vector<FaceJump> jumps;
  jumps.reserve(packing.interfaces().size());
  for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
  {
    const Packing<3>::Interface &i = packing.interfaces()[e];
    FaceJump of = {jump_at(packing, motion, i, i.centroid), infinity_of_errors,
                   0.};
    for (const dealii::Point<3> &x : packing.polygon(e))
    {
      const Tensor<1, 3> jump = jump_at(packing, motion, i, x);
      of.least_opening = std::min(of.least_opening, jump * i.normal);
      of.largest_slip =
          std::max(of.largest_slip, across(jump, i.normal).norm());
    }
    jumps.push_back(of);
  }
  return jumps;
}

MechanismCertificate certify_mechanism(const SpaceScene &scene,
                                       const SpaceMotion &motion)
{
  double largest_load = 0.;
  for (const Tensor<1, 3> &f : scene.loads.force)
    largest_load = std::max(largest_load, f.norm());
  return certificate_of(work_in_faces(scene, motion),
                        work_of_loads(scene, motion), largest_load);
}

FactorBound bound_of_factor(const SpaceScene &dead,
                            const SpaceScene &live,
                            const SpaceMotion &motion)
{
  return bound_by(work_in_faces(dead, motion), work_of_loads(dead, motion),
                  work_of_loads(live, motion));
}

FactorBound bound_of_continuous_faces(const SpaceScene &dead,
                                      const SpaceScene &live,
                                      const SpaceMotion &motion)
{
  return bound_by(work_in_faces(dead, motion, true),
                  work_of_loads(dead, motion), work_of_loads(live, motion));
}
} // namespace Voussoir
