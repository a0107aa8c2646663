// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_energy_face_joint_h
#define voussoir_statics_energy_face_joint_h

#include <voussoir/algebra/joint_law.h>
#include <voussoir/algebra/structure.h>

#include <utility>
#include <vector>

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
  /**
   * @param structure in space; it must outlive this object.
   * @param tension the largest of each of its joints, nondimensional.
   */
  FaceJoint(const Structure &structure, std::vector<double> tension)
      : structure(structure), tension(std::move(tension))
  {}

  void find_forces(unsigned int e,
                   const double *jumps,
                   double *forces) const override;
  bool find_second_derivatives(unsigned int e,
                               const double *jumps,
                               double *second) const override;

private:
  template <typename F>
  void for_each_law(unsigned int e, const F &f) const;

  const Structure &structure;
  const std::vector<double> tension;
};
} // namespace Voussoir

#endif
