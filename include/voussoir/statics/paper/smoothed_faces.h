// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_paper_smoothed_faces_h
#define voussoir_statics_paper_smoothed_faces_h

#include <voussoir/statics/paper/joint_energy_program.h>
#include <voussoir/statics/problem/formulation.h>

namespace Voussoir
{
/**
 * The energy of a joint in space with compliant contact and Tresca's smoothed
 * friction: with the jumps x_i along the interface at the centroids of its
 * cells and y_k across it at its pressures it is
 *
 *     sum_i s_e a_i (sqrt(|x_i|^2 + eps_e^2) - eps_e)
 *       + sum_k w_k k_e min(y_k, 0)^2 / 2,   eps_e = s_e d_e,
 *
 * as SmoothedJoint in the plane. The tangential forces never exceed the
 * strengths s_e a_i of their cells. All nondimensional.
 */
class SmoothedFace : public EnergyLaw
{
public:
  /** @param problem in space; it must outlive this object. */
  explicit SmoothedFace(const DiscreteProblem &problem) : problem(problem) {}

  double energy(unsigned int e, const double *jumps) const override;
  void find_forces(unsigned int e,
                   const double *jumps,
                   double *forces) const override;
  bool find_second_derivatives(unsigned int e,
                               const double *jumps,
                               double *second) const override;

private:
  /** eps_e. */
  double smoothing(const unsigned int e) const
  {
    const Joint &joint = problem.joints()[e];
    return joint.strength / joint.length * joint.distance;
  }

  const DiscreteProblem &problem;
};

/**
 * The displacement problem in space with smoothed friction and compliant
 * contact, solved by Ipopt with MUMPS, for Tresca's friction alone. Ipopt
 * starts where a few steps of Newton's method end.
 */
class SmoothedFaces : public Formulation
{
public:
  std::string name() const override { return "smoothed friction"; }
  std::string meaning() const override
  {
    return "the displacement problem with |.| smoothed on each cell of "
           "friction and compliant contact, solved by Ipopt; with Tresca's "
           "friction alone, other laws take 'least energy'.";
  }
  std::string selection() const override
  {
    return "smoothed friction with compliant contact: least energy of the "
           "contact springs, with the most even use of friction";
  }

private:
  Solution select(const DiscreteProblem &problem,
                  const SolverControls &controls,
                  Terminal &terminal) const override;
};
} // namespace Voussoir

#endif
