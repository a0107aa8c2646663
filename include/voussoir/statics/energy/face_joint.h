// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_energy_face_joint_h
#define voussoir_statics_energy_face_joint_h

#include <voussoir/algebra/joint_law.h>
#include <voussoir/statics/problem/discrete_problem.h>

namespace Voussoir
{
/**
 * The law of elastic joints in space that open, slide and bear tension, by the
 * sets of their rows: the stiffness k_e = |e| / d_e has each by its share, and
 * the force is the nearest one that the set admits, in the energy, to that of a
 * joint that neither opens nor slides. Without friction that grows with the
 * pressure these are min(k y, 0) and Huber's law; with it, the projection on
 * the cone |q| <= mu p, so that blocks that slide lift off (associated
 * friction).
 *
 * Joints do not crush.
 */
class FaceJoint : public JointLaw
{
public:
  /** @param problem in space; it must outlive this object. */
  explicit FaceJoint(const DiscreteProblem &problem) : problem(problem) {}

  void find_forces(unsigned int e,
                   const double *jumps,
                   double *forces) const override;
  bool find_second_derivatives(unsigned int e,
                               const double *jumps,
                               double *second) const override;

private:
  const DiscreteProblem &problem;
};
} // namespace Voussoir

#endif
