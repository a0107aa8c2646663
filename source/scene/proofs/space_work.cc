// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/scene/proofs/point_limits.h>
#include <voussoir/scene/proofs/space_certificate.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace Voussoir
{
using dealii::Tensor;

namespace
{
/** How the ground moves below support @p e; null if it is at rest. */
const SpaceSupportMotion *motion_of_ground(const Packing<3> &packing,
                                           const SpaceMotion &motion,
                                           const unsigned int e)
{
  const unsigned int first = packing.interfaces().size() - packing.n_supports();
  return motion.of_supports.empty() ? nullptr : &motion.of_supports[e - first];
}

/** The displacement of c+ relative to c- at a place of an interface. */
Tensor<1, 3> jump_at(const Packing<3> &packing,
                     const SpaceMotion &motion,
                     const unsigned int e,
                     const dealii::Point<3> &place)
{
  const Packing<3>::Interface &i = packing.interfaces()[e];
  const Tensor<1, 3> minus =
      motion.at(i.cell_minus, place - packing.centre(i.cell_minus));
  if (i.cell_plus != packing.ground())
    return motion.at(i.cell_plus, place - packing.centre(i.cell_plus)) - minus;
  const SpaceSupportMotion *const ground = motion_of_ground(packing, motion, e);
  return ground ? ground->at(place - i.centroid) - minus : -minus;
}

/** The angle by which c+ turns relative to c-. */
Tensor<1, 3> turn_between(const Packing<3> &packing,
                          const SpaceMotion &motion,
                          const unsigned int e)
{
  const Packing<3>::Interface &i = packing.interfaces()[e];
  if (motion.rotation.empty())
    return {};
  const Tensor<1, 3> &minus = motion.rotation[i.cell_minus];
  if (i.cell_plus != packing.ground())
    return motion.rotation[i.cell_plus] - minus;
  const SpaceSupportMotion *const ground = motion_of_ground(packing, motion, e);
  return ground ? ground->rotation - minus : -minus;
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
      across(jump_at(packing, motion, e, i.centroid), i.normal);
  const double spin = turn_between(packing, motion, e) * i.normal;
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

/** What a motion does, with all that may be special about it. */
struct MotionToJudge
{
  const SpaceScene &scene;
  const SpaceMotion &motion;
  /** True if friction without pressure acts all over the interfaces. */
  bool are_continuous = false;
  /** Forces whose pressures alone say how much friction there is, or null. */
  const FaceForces *own = nullptr;
  /** Whose motion of the interfaces comes besides, or null. */
  const FaceFunction *besides = nullptr;

  WorkOfMotion work() const;

private:
  void add_pressures(unsigned int e,
                     const FaceFunction::Term *term,
                     WorkOfMotion &of) const;
  void add_friction(unsigned int e,
                    const FaceFunction::Term *term,
                    WorkOfMotion &of) const;
  Tensor<1, 3> jump(const unsigned int e,
                    const dealii::Point<3> &place,
                    const FaceFunction::Term *const term) const
  {
    const Tensor<1, 3> moved = jump_at(scene.packing(), motion, e, place);
    return term ? moved + term->at(place) : moved;
  }
};

/** Add what the points of pressure of an interface do. */
void MotionToJudge::add_pressures(const unsigned int e,
                                  const FaceFunction::Term *const term,
                                  WorkOfMotion &of) const
{
  const Packing<3> &packing = scene.packing();
  const Packing<3>::Interface &i = packing.interfaces()[e];
  const PointLimits limits(*scene.blocks, e);
  double closing = 0.;
  unsigned int k = own ? own->first[e] : 0;
  for (const FacePoint &point : scene.blocks->points[e].pressure)
  {
    const Tensor<1, 3> jumped = jump(e, point.place, term);
    const Tensor<1, 3> arm = point.place - packing.centre(i.cell_minus);
    of.largest = std::max(of.largest, motion.at(i.cell_minus, arm).norm());
    if (term)
      of.largest = std::max(of.largest, term->at(point.place).norm());
    const double opening = jumped * i.normal;
    double slip = limits.coefficient * across(jumped, i.normal).norm();
    if (own)
    {
      of.dissipation += slip * std::max(limits.pressure(own->list[k++].force,
                                                        i.normal, point.share),
                                        0.);
      slip = 0.;
    }
    const double resisted = std::max(slip - opening, 0.);
    of.dissipation += limits.tension * point.share * opening;
    if (std::isfinite(limits.crushing))
      of.dissipation +=
          (limits.crushing + limits.tension) * point.share * resisted;
    else
      closing = std::max(closing, resisted);
  }
  of.closing = std::max(of.closing, closing);
  of.all_closings += closing;
}

/** Add what the points of friction of an interface do. */
void MotionToJudge::add_friction(const unsigned int e,
                                 const FaceFunction::Term *const term,
                                 WorkOfMotion &of) const
{
  const PointLimits limits(*scene.blocks, e);
  if (!(limits.strength > 0.))
    return;
  const Packing<3>::Interface &i = scene.packing().interfaces()[e];
  if (are_continuous)
    of.dissipation +=
        limits.strength / i.area * integral_of_slip(scene.packing(), motion, e);
  else
    for (const FacePoint &point : scene.blocks->points[e].friction)
      of.dissipation += limits.strength * point.share *
                        across(jump(e, point.place, term), i.normal).norm();
}

WorkOfMotion MotionToJudge::work() const
{
  WorkOfMotion of;
  for (const Tensor<1, 3> &u : motion.displacement)
    of.largest = std::max(of.largest, u.norm());
  const std::size_t n = scene.packing().interfaces().size();
  const std::vector<const FaceFunction::Term *> terms =
      besides ? besides->by_interface(n)
              : std::vector<const FaceFunction::Term *>(n, nullptr);
  for (unsigned int e = 0; e < n; ++e)
  {
    add_pressures(e, terms[e], of);
    add_friction(e, terms[e], of);
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
    constexpr double infinity = std::numeric_limits<double>::infinity();
    FaceJump of = {jump_at(packing, motion, e, i.centroid), infinity, -infinity,
                   0.};
    for (const dealii::Point<3> &x : packing.polygon(e))
    {
      const Tensor<1, 3> jump = jump_at(packing, motion, e, x);
      of.least_opening = std::min(of.least_opening, jump * i.normal);
      of.greatest_opening = std::max(of.greatest_opening, jump * i.normal);
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
  return certificate_of(MotionToJudge{scene, motion}.work(),
                        work_of_loads(scene, motion), largest_load);
}

FactorBound bound_of_factor(const SpaceScene &dead,
                            const SpaceScene &live,
                            const SpaceMotion &motion)
{
  return bound_by(MotionToJudge{dead, motion}.work(),
                  work_of_loads(dead, motion), work_of_loads(live, motion));
}

FactorBound bound_of_continuous_faces(const SpaceScene &dead,
                                      const SpaceScene &live,
                                      const SpaceMotion &motion)
{
  return bound_by(MotionToJudge{dead, motion, true}.work(),
                  work_of_loads(dead, motion), work_of_loads(live, motion));
}

FactorBound bound_with_own_strengths(const SpaceScene &dead,
                                     const SpaceScene &live,
                                     const FaceForces &forces,
                                     const SpaceMotion &motion)
{
  return bound_by(MotionToJudge{dead, motion, false, &forces}.work(),
                  work_of_loads(dead, motion), work_of_loads(live, motion));
}

ForceBound bound_of(const SpaceScene &scene,
                    const FaceFunction &function,
                    const SpaceMotion &motion)
{
  const WorkOfMotion of =
      MotionToJudge{scene, motion, false, nullptr, &function}.work();
  return {of.dissipation - work_of_loads(scene, motion),
          of.closing_violation()};
}
} // namespace Voussoir
