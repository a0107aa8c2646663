// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_conic_self_dual_h
#define voussoir_statics_conic_self_dual_h

#include <voussoir/statics/conic/conic_forces.h>

#include <vector>

namespace Voussoir
{
/**
 * The simplified homogeneous self-dual embedding of
 *
 *     minimise    x^T Q x / 2 + c . x - sense alpha
 *     subject to  A x + alpha f_1 + f_0 = 0,  s = h - B x in its cones,
 *
 * solved by an interior-point method, step by step: Xu, Hung and Ye, *Annals of
 * Operations Research* 62 (1996), 151, with the predictor and corrector of
 * Mehrotra, the corrections of Gondzio, *Computational Optimization and
 * Applications* 6 (1996), 137, and the scaling of QuadraticCone. A problem
 * without an optimum has an answer, too: a ray of forces that grow without
 * bound, or a mechanism that no factor stops.
 *
 * x are the forces of ConicForces, with their slacks s; the displacement u,
 * with multipliers z of the slacks, are the multipliers of the balance: in the
 * optimum Q x + c + A^T u + B^T z = 0, and f_1 has the work sense. Without a
 * cost z is the opening and the sliding either way, and u is a mechanism. All
 * of them are over tau, which goes to zero where there is no optimum.
 */
class SelfDual
{
public:
  /** What is to be balanced, and at what cost. */
  struct Program
  {
    /** f_0, n_dofs() numbers, zero for held bodies. */
    std::vector<double> dead;
    /** f_1, the same; empty if there is no alpha. */
    std::vector<double> live = {};
    /** 1 for the greatest alpha, -1 for the least. */
    double sense = 1.;
    /** c, a number for each row; empty if it is zero. */
    std::vector<double> cost = {};
    /** True if Q counts, ConicForces::curvature(). */
    bool has_curvature = false;
    /** True if what counts is whether the loads are carried, however closely;
     * there is no quadratic cost then. */
    bool is_verdict = false;
    /**
     * The first slack, over the root of the stiffness or the whole range:
     * forces far inside their bounds, so that joints need hardly open to begin
     * with. What the program leaves open stays about as large. With a quadratic
     * cost it is that root, of elastic forces.
     */
    double first_slack = 100.;
  };

  /** A point and tau, kappa. */
  struct Variables
  {
    /** @{ */
    /** As in Point, times tau. */
    std::vector<double> x, u, s, z;
    double alpha, tau, kappa;
    /** @} */
  };

  /** Where a search is, all that its next steps depend on. */
  struct Progress
  {
    /** The variables(). */
    Variables at;
    /** @{ */
    /** How many steps were taken, and how many until the last that counts as
     * progress, with the mean product then. */
    unsigned int iterations, iteration_of_least;
    double least_mean;
    /** @} */
  };

  /** What is known. */
  enum class State
  {
    /** To be continued. */
    running,
    /** No better optimum can be had by more steps. */
    optimal,
    /** Forces balance f_1 alone: u is of no meaning. */
    unbounded,
    /** A mechanism, u, collapses under f_0, and f_1 does no work along it. */
    infeasible,
    /** There is no progress. */
    stalled
  };

  /**
   * @param forces of the joints; it must outlive this object.
   * @param program what is asked of them.
   * @param start the variables() of a program with the same joints and other
   *   strengths or loads, to go on from; null for the usual start.
   */
  SelfDual(ConicForces &forces,
           Program program,
           const Variables *start = nullptr);

  /** Where it is. */
  Progress where() const
  {
    return {now, iterations, iteration_of_least, least_mean};
  }
  /** Go on from where a search of the same program was. */
  void go_on(Progress from);

  /** Take a step; what is known then. */
  State step();

  /** The present point, over tau, or of a ray over its gain. */
  struct Point
  {
    /** The forces, a number for each row. */
    std::vector<double> x;
    /** The displacement, n_dofs() numbers. */
    std::vector<double> u;
    /** @{ */
    /** The slacks and the multipliers. */
    std::vector<double> s, z;
    /** @} */
    /** The factor. */
    double alpha;
  };
  /** The present point. */
  Point point() const;
  /** The same, not over tau. */
  const Variables &variables() const { return now; }
  /**
   * The largest of all errors: the gap between the two objectives, relative to
   * alpha, and of the balance of forces, the bounds and the multipliers.
   */
  double merit() const { return error; }
  /** The factor at present. */
  double alpha() const { return now.alpha / now.tau; }
  /** What x costs at present, less what alpha is worth. */
  double objective() const;
  /** kappa over tau, which grows where there is no optimum. */
  double doubt() const { return now.kappa / now.tau; }
  /** What the loads gain along u, if there is no other balance. */
  double gain() const;
  /** The number of steps taken. */
  unsigned int n_iterations() const { return iterations; }

private:
  /** A step of one cone: W^-1 s and W z. */
  struct ScaledStep
  {
    QuadraticCone::Vector s, z;
  };
  /** A step of all variables. */
  struct Step : Variables
  {
    std::vector<ScaledStep> scaled = {};
  };
  /** The residuals of the five groups of equations. */
  struct Residuals
  {
    std::vector<double> balance, bounds, multipliers;
    double live_work, gap;
  };

  void take_usual_start();
  void take_start_of_slacks();
  std::vector<double> slacks_of_forces() const;
  Residuals residuals() const;
  double curvature_of(const std::vector<double> &x,
                      const std::vector<double> &y) const;
  double mean_product() const;
  double find_error(double primal, double dual) const;
  State judge();
  State judge_ray(double primal, double gain) const;
  bool prepare();
  void solve_bordered(const std::vector<double> &r1,
                      const std::vector<double> &balance,
                      double live_work,
                      double reduction,
                      Variables &found) const;
  void balance_forces(const std::vector<double> &balance,
                      double live_work,
                      double enough,
                      Variables &found) const;
  void find_by_tau();
  Step change(const std::vector<double> &products,
              double part,
              double reduction) const;
  void complete(const std::vector<double> &products,
                double last_product,
                double part,
                Step &step) const;
  Step predictor(const std::vector<double> &products, double last_product);
  Step direction(const std::vector<double> &products,
                 double last_product,
                 double part) const;
  std::vector<double> over_squares(const std::vector<double> &v) const;
  std::vector<double> multipliers_of(const std::vector<double> &r1,
                                     const Variables &found) const;
  void find_scaling();
  double longest(const Step &step) const;
  void find_products(const Step &step,
                     double length,
                     std::vector<double> &products,
                     double &last) const;
  void add_second_order(const Step &step,
                        double target,
                        std::vector<double> &products) const;
  void pull_back(double target, std::vector<double> &products) const;
  double least_product(const Step &step, double length) const;
  double keep_products_near(const Step &step, double length) const;

  ConicForces &forces;
  const Program program;
  /** h. */
  const std::vector<double> limits;
  const std::size_t n_bounds;
  /** The largest component of all loads. */
  const double size_of_loads;
  /** The objective below which differences are absolute. */
  double unit = 1.;
  Variables now;
  Residuals residual;
  double error = 0.;
  unsigned int iterations = 0;
  double least_mean;
  unsigned int iteration_of_least = 0;

  // Of a step:
  /** z / s of each bound, and W of each cone. */
  ConicForces::Weights weights;
  /** W z of each cone. */
  std::vector<QuadraticCone::Vector> lambda;
  /** The derivative by tau. */
  Step by_tau;
  double slope_of_tau = 0.;
};
} // namespace Voussoir

#endif
