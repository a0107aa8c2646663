// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_energy_barrier_joint_h
#define voussoir_statics_energy_barrier_joint_h

#include <voussoir/algebra/joint_law.h>

#include <vector>

namespace Voussoir
{
/** The weights w_e of the logarithms; see BarrierJoint. */
enum class BarrierWeights
{
  /** w_e = 1. */
  equal,
  /** w_e = |e| d_e, nondimensional. */
  edge_area
};

/**
 * The energy of a joint in the barrier problem of the linear program.
 *
 * That program is
 *
 *     minimise sum_e s_e |e| v_e - sum_c F_c . u_c
 *     subject to y_e >= 0 and v_e >= |x_e|,
 *
 * with y the jump of a contact and x the tangential one. Each inequality has
 * the barrier -w_e log(.); v_e is eliminated, which leaves, with b = s_e |e|
 * and r = sqrt(w_e^2 + b^2 x^2),
 *
 *     -w_e log y + r - w_e log(w_e + r),
 *
 * and the forces p = w_e / y and q = b^2 x / (w_e + r), inside the admissible
 * ones. The weights w_e are one (`equal`) or |e| d_e (`edge area`, twice the
 * area between the joint and the two centres), which the contacts of a joint
 * share.
 */
class BarrierJoint : public JointLaw
{
public:
  /** @param structure has the joints; it must outlive this object. */
  BarrierJoint(const Structure &structure, const BarrierWeights weights)
      : fixed(structure.n_all_rows(), 0), structure(&structure),
        weights(weights)
  {}

  void find_forces(unsigned int e,
                   const double *jumps,
                   double *forces) const override;
  bool find_second_derivatives(unsigned int e,
                               const double *jumps,
                               double *second) const override;
  double longest_step(unsigned int e,
                      const double *jumps,
                      const double *steps) const override;

  /** The weight w_e of the friction, nondimensional. */
  double weight(const unsigned int e) const
  {
    const Structure::Joint &joint = structure->joints()[e];
    return weights == BarrierWeights::equal ? 1.
                                            : joint.length * joint.distance;
  }

  /** The weight of each contact. */
  double contact_weight(const unsigned int e) const
  {
    return weights == BarrierWeights::equal
               ? 1.
               : weight(e) / structure->n_contacts(e);
  }

  /** The rest of the strength, s_e |e| - |q_e|, without cancellation. */
  double slack(unsigned int e, double sliding) const;

  /**
   * The forces that all admissible and balanced states have in common, for each
   * row of each joint: zero where there is none, and else one of a contact that
   * is never pressed, p = 0, and +1 or -1 where q = +b or q = -b. At first
   * nothing is fixed.
   */
  std::vector<signed char> fixed;

private:
  const Structure *structure;
  BarrierWeights weights;
};
} // namespace Voussoir

#endif
