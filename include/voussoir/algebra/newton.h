// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_newton_h
#define voussoir_algebra_newton_h

#include <voussoir/algebra/joint_law.h>
#include <voussoir/algebra/linear/joint_system.h>
#include <voussoir/base/exceptions.h>

#include <vector>

namespace Voussoir
{
/** Newton's method has no next step. */
class NewtonFailure : public SolverError
{
public:
  /** The reason. */
  enum class Cause
  {
    /** A second derivative of the energy is no number. */
    stiffness,
    /** The linear system has no solution that leads downhill. */
    linear_system
  };
  /** @param cause the reason, which the message says. */
  explicit NewtonFailure(const Cause cause)
      : SolverError(cause == Cause::stiffness
                        ? "The stiffness of a joint is beyond all numbers: its "
                          "strength is too far above the load."
                        : "A linear system of Newton's method cannot be "
                          "solved: the strengths or the sizes of the "
                          "interfaces differ by too much."),
        cause(cause)
  {}
  /** The reason. */
  const Cause cause;
};

/**
 * Newton's method for the displacement, step by step.
 *
 * It looks for the minimum of
 *
 *     sum_e energy_e([u]_e) - sum_c F_c . u_c,
 *
 * in the semismooth sense where the forces have kinks. A formulation decides on
 * the course.
 *
 * A step aims at the minimum with the proximal term shift / 2 |v - centre|^2
 * added, which bounds it where no joint holds a cell. A line search follows
 * until the slope of the energy has nearly vanished; it uses forces only, since
 * energies cancel.
 *
 * If several processes share the structure all take the same steps together;
 * what is asked of all bodies or joints is that of all processes.
 */
class Newton
{
public:
  /**
   * The references must outlive this object.
   *
   * @param structure has bodies, joints and loads.
   * @param law of the joints.
   * @param system solves the linear systems.
   * @param u the starting point, n_dofs() numbers with the ghosts; the energy
   *   must be finite there.
   */
  Newton(const Structure &structure,
         const JointLaw &law,
         JointSystem &system,
         std::vector<double> u);

  /**
   * Take one step.
   *
   * @return the length of the step, in units of Newton's own.
   * @throws NewtonFailure if the linear system cannot be solved.
   */
  double step(double shift, const std::vector<double> &centre);

  /**
   * Take Newton's own step, with the least shift, to its full length or the end
   * of the energy's domain: close to the minimum, where rounding decides what a
   * line search finds.
   *
   * @throws NewtonFailure if the linear system cannot be solved.
   */
  void full_step();

  /** Go on from @p u, n_dofs() numbers with the ghosts. */
  void restart(std::vector<double> u);

  /** The displacement: n_dofs() numbers, with the ghosts. */
  const std::vector<double> &u() const { return present.u; }
  /** Of each row of each joint of this process. */
  const std::vector<double> &jumps() const { return present.jumps; }
  /** Of each row of each joint of this process. */
  const std::vector<double> &forces() const { return present.forces; }
  /** The largest component of the sum of all forces on a cell. */
  double imbalance() const;
  /** The imbalance with the force -shift (u - centre) of the proximal term. */
  double imbalance(double shift, const std::vector<double> &centre) const;
  /**
   * The size of the last step, measured by the energy.
   *
   * It is (r . A^{-1} r)^(1/2), where r is what the step had to balance.
   */
  double decrement() const { return last_decrement; }
  /** The largest change of a force in the last step. */
  double force_change() const { return last_force_change; }
  /** The number of steps taken. */
  unsigned int n_iterations() const { return iterations; }
  /** The number of evaluations of the forces. */
  unsigned int n_evaluations() const { return evaluations; }
  /** The time of the linear systems so far, in seconds; see JointSystem. */
  double seconds_of_systems() const { return system.seconds(); }

private:
  /** A displacement and what follows from it. */
  struct State
  {
    std::vector<double> u;
    /**
     * The jumps of u, but summed up from those of the steps: differences of u
     * itself would lose, in a stiff joint, the digits of its force.
     */
    std::vector<double> jumps;
    std::vector<double> forces;
    /** Minus the sum of all forces on each cell. */
    std::vector<double> gradient;
  };

  /** A step from the present state. */
  struct Direction
  {
    std::vector<double> u;
    /** The jumps of u. */
    std::vector<double> jumps;
    /** The longest multiple with finite energy, with a margin. */
    double longest;
  };
  /** The slope of the energy along a step, as a function of its length. */
  class Slope;

  /** Find forces and gradient from the jumps. */
  void evaluate(State &state);
  /** The second derivatives of the energy. */
  JointStiffnesses stiffnesses() const;
  Direction direction(double shift, const std::vector<double> &centre);
  std::vector<double> solve(double shift, const std::vector<double> &right);
  void refine(const JointStiffnesses &second,
              const std::vector<double> &right,
              std::vector<double> &d);
  /** Find @p trial at @p t steps in a direction. */
  void go(const Direction &direction, double t, State &trial);
  void accept(State trial);
  double search(const Direction &direction,
                double shift,
                const std::vector<double> &centre);

  const Structure &structure;
  const JointLaw &law;
  JointSystem &system;
  State present;
  double last_decrement;
  double last_force_change;
  unsigned int iterations = 0;
  unsigned int evaluations = 0;
};
} // namespace Voussoir

#endif
