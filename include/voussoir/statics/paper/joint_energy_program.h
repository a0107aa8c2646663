// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_paper_joint_energy_program_h
#define voussoir_statics_paper_joint_energy_program_h

#include <voussoir/algebra/joint_law.h>
#include <voussoir/algebra/linear/joint_blocks.h>
#include <voussoir/statics/paper/displacement_program.h>

#include <limits>
#include <vector>

namespace Voussoir
{
/** A law of joints whose energy is known, and not its derivatives alone. */
class EnergyLaw : public JointLaw
{
public:
  /** The energy of joint @p e. */
  virtual double energy(unsigned int e, const double *jumps) const = 0;
};

/**
 * Of the points that a search without constraints has seen, whose gradients are
 * the imbalance of forces, the one with the best balance; and whether it will
 * do.
 */
class BestBalance
{
public:
  /** See the gradient at @p x. */
  void see(const double *x, const std::vector<double> &gradient);
  /** To be asked once an iteration: converged, stopped by rounding, or none. */
  Stop verdict(unsigned int iteration, double tolerance);
  /** The point; empty if none was seen. */
  const std::vector<double> &point() const { return best; }
  /** The largest component of the gradient there. */
  double imbalance() const { return least; }

private:
  std::vector<double> best;
  double least = std::numeric_limits<double>::infinity();
  double before = std::numeric_limits<double>::infinity();
  unsigned int iteration_of_best = 0;
};

/**
 * Minimise the energy of joints less the work of the loads; the unknowns are
 * the displacements alone, and there are no constraints.
 */
class JointEnergyProgram : public DisplacementProgram
{
public:
  /**
   * @param problem has the joints and the loads.
   * @param law of the joints; both must outlive this object.
   */
  JointEnergyProgram(const DiscreteProblem &problem, const EnergyLaw &law);

  double value(const double *x) override;
  std::vector<double> gradient(const double *x) override;
  std::vector<Entry> hessian(const double *x) const override;
  unsigned int n_constraints() const override { return 0; }
  std::vector<Entry> constraints() const override { return {}; }

protected:
  /** The forces at @p x, of each row of each joint. */
  std::vector<double> forces_at(const std::vector<double> &x) const;

private:
  const DiscreteProblem &of_loads;
  const EnergyLaw &of_energy;
  const JointBlocks blocks_of_joints;
  /** Of one joint. */
  mutable std::vector<double> jumps, forces;
};
} // namespace Voussoir

#endif
