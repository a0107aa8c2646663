// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_proofs_point_limits_h
#define voussoir_scene_proofs_point_limits_h

#include <voussoir/scene/space/space_scene.h>

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
/** The part of @p v across @p normal, which has the length one. */
inline dealii::Tensor<1, 3> across(const dealii::Tensor<1, 3> &v,
                                   const dealii::Tensor<1, 3> &normal)
{
  return v - (v * normal) * normal;
}

/** What the points of an interface in space admit, for certificates; S L^2. */
struct PointLimits
{
  /** Of interface @p e. */
  PointLimits(const SpaceBlocks &blocks, const unsigned int e)
      : coefficient(blocks.coefficient(e))
  {
    const double area = blocks.packing.interfaces()[e].area;
    tension = blocks.tensile(e) * area;
    strength = blocks.strength_under_tension(e) * area;
    crushing = blocks.strengths.compressive.empty()
                   ? std::numeric_limits<double>::infinity()
                   : blocks.strengths.compressive[e] * area;
  }
  /** @{ */
  /** mu_e, f_t |e|, what is left of c_e |e| at f_t, and f_c |e|. */
  double coefficient, tension, strength, crushing;
  /** @} */

  /** What @p force at a point of pressure has beyond full tension. */
  double pressure(const dealii::Tensor<1, 3> &force,
                  const dealii::Tensor<1, 3> &normal,
                  const double share) const
  {
    return tension * share - force * normal;
  }
  /** The excess of a force at a point of pressure. */
  double excess_of_pressure(const dealii::Tensor<1, 3> &force,
                            const dealii::Tensor<1, 3> &normal,
                            const double share) const
  {
    const double p = pressure(force, normal, share);
    const double friction = across(force, normal).norm();
    return std::max({-p, -(force * normal) - crushing * share,
                     friction - coefficient * std::max(p, 0.)});
  }
  /** The excess of a force at a point of friction. */
  double excess_of_friction(const dealii::Tensor<1, 3> &force,
                            const dealii::Tensor<1, 3> &normal,
                            const double share) const
  {
    return std::max(std::abs(force * normal),
                    across(force, normal).norm() - strength * share);
  }
};
} // namespace Voussoir

#endif
