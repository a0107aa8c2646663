// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_conic_interior_point_h
#define voussoir_statics_conic_interior_point_h

#include <voussoir/algebra/linear/joint_system.h>
#include <voussoir/statics/conic/friction_cone.h>
#include <voussoir/statics/problem/discrete_problem.h>

#include <vector>

namespace Voussoir
{
/** The cost of the forces of one joint; nondimensional. See InteriorPoint. */
struct JointCost
{
  /** c^n of each contact, not negative. */
  double normal_compliance = 0.;
  /** c^t, not negative. */
  double tangential_compliance = 0.;
  /** eps, not negative. */
  double smoothing = 0.;
};

/**
 * A primal-dual interior-point method for the forces, step by step.
 *
 * It looks for the admissible and balanced forces with the least
 *
 *     sum_e (c_e^n p_e^2 / 2 + c_e^t q_e^2 / 2 - eps_e (b_e^2 - q_e^2)^(1/2)),
 *
 * with the forces p_e >= 0 of each contact and b_e = s_e |e|: with c^n = n
 * d_e/|e| for n contacts, c^t = d_e/|e| and eps = 0 least energy, with that
 * c^n, c^t = 0 and eps = s_e d_e smoothed friction with compliant contact. Or,
 * where nothing has a cost, for the load factor: the largest alpha for which
 * the load alpha F is carried. Displacements are the multipliers of the
 * balance. p_e has the multiplier z_e >= 0, which is [u]_e . n_e + c_e^n p_e in
 * the end; friction is a FrictionCone, whose sliding is [u]_e . t_e - c_e^t q_e
 * in the end. All p_e z_e and s_e . lambda_e go to zero, in proportion to |e|
 * d_e, while the forces find their balance.
 *
 * Forces and displacements are unknowns of equal right, so that no digits of
 * the forces are lost when many joints slide far: the method needs some dozens
 * of linear systems, of the same kind as Newton's, however close the load is to
 * its limit. Forces are admissible all the way, and balance to rounding after
 * the first full step.
 */
class InteriorPoint
{
public:
  /** The optimum that is looked for. */
  enum class Aim
  {
    /** The forces that cost the least. */
    least_cost,
    /**
     * Near the least cost in less than half the steps, by predictor and
     * corrector (Mehrotra), and with some digits less in the end.
     */
    near_least_cost,
    /** The load factor; nothing has a cost. */
    load_factor
  };

  /**
   * @param problem must outlive this object.
   * @param costs of each of its joints.
   */
  InteriorPoint(const DiscreteProblem &problem,
                const std::vector<JointCost> &costs,
                Aim aim);

  /**
   * Take one step.
   *
   * @return false if rounding allows none; all stays as it was.
   */
  bool step();

  /** The displacement: n_dofs() numbers. */
  const std::vector<double> &u() const { return displacement; }
  /** Of each row of each joint, as in Structure. */
  std::vector<double> forces() const;
  /** The factor of the loads; one unless it is looked for. */
  double load_factor() const { return alpha; }
  /** The largest component of the sum of all forces on a body. */
  double imbalance() const;
  /** The mean product of a force and its multiplier, over |e| d_e. */
  double product() const;
  /** The number of steps taken. */
  unsigned int n_iterations() const { return iterations; }
  /** The time of the linear systems so far, in seconds; see JointSystem. */
  double seconds_of_systems() const { return system.seconds(); }

private:
  /** One contact. */
  struct Contact
  {
    /** The share in |e| d_e of its joint. */
    double weight;
    double p, z;
    /** The shortfall of z. */
    double short_z = 0.;
    /** What the predictor leaves out: the product of its two changes. */
    double second_order = 0.;
  };
  /** One joint, but for its contacts. */
  struct State
  {
    JointCost cost;
    /**
     * The compliance added to the cost in steps that lose digits without it.
     */
    double extra_compliance;
    /** |e| d_e. */
    double weight;
    FrictionCone friction;
    /** The shortfall of the sliding. */
    double short_v = 0.;
    /** The compliance of a contact in a step. */
    double normal_compliance() const
    {
      return cost.normal_compliance + extra_compliance;
    }
  };
  struct ContactStep
  {
    double p, z;
  };
  struct Step
  {
    std::vector<double> u;
    std::vector<ContactStep> contacts;
    std::vector<FrictionCone::Step> frictions;
    double load_factor;
  };
  /** Parts of a step. */
  struct Parts
  {
    double of_forces, of_displacements;
  };

  std::vector<double> missing_forces() const;
  void find_shortages();
  bool prepare();
  std::vector<double> solve(const std::vector<double> &right);
  Step direction(double target);
  void correct_for(const Step &predictor);
  Parts longest(const Step &step, double fraction) const;
  bool take(const Step &step, const Parts &parts);

  const DiscreteProblem &problem;
  const Aim aim;
  JointSystem system;
  std::vector<State> states;
  /** Joint by joint. */
  std::vector<Contact> contacts;
  std::vector<double> displacement;
  double alpha;
  /** The coefficients of the linear system. */
  JointStiffnesses stiffness;
  /** Its solution for the loads. */
  std::vector<double> u_of_load;
  unsigned int iterations = 0;
};
} // namespace Voussoir

#endif
