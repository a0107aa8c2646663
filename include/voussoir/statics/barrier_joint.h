// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_barrier_joint_h
#define voussoir_statics_barrier_joint_h

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
 * with y and x the normal and the tangential jump. Each inequality has the
 * barrier -w_e log(.); v_e is eliminated, which leaves, with b = s_e |e| and
 * r = sqrt(w_e^2 + b^2 x^2),
 *
 *     -w_e log y + r - w_e log(w_e + r),
 *
 * and the forces p = w_e / y and q = b^2 x / (w_e + r), inside the admissible
 * ones. The weights w_e are one (`equal`) or |e| d_e (`edge area`, twice the
 * area between the joint and the two centres).
 */
class BarrierJoint : public JointLaw
{
public:
  /**
   * The forces that all admissible and balanced states have in common at a
   * joint.
   */
  struct Fixed
  {
    /** p = 0: the joint has no barrier for it. */
    bool never_pressed = false;
    /** +1 or -1 where q = +b or q = -b. */
    int sliding = 0;
  };

  /** @param structure has the joints; it must outlive this object. */
  BarrierJoint(const Structure &structure, BarrierWeights weights);

  Jump force(unsigned int e, const Jump &jump) const override;
  Jump second_derivative(unsigned int e, const Jump &jump) const override;
  double longest_step(unsigned int e,
                      const Jump &jump,
                      const Jump &step) const override;

  /** The weight w_e, nondimensional. */
  double weight(unsigned int e) const;

  /** The rest of the strength, s_e |e| - |q_e|, without cancellation. */
  double slack(unsigned int e, const Jump &jump) const;

  /** One entry per joint; at first nothing is fixed. */
  std::vector<Fixed> fixed;

private:
  const Structure *structure;
  BarrierWeights weights;
};
} // namespace Voussoir

#endif
