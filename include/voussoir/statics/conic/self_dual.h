// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_conic_self_dual_h
#define voussoir_statics_conic_self_dual_h

#include <voussoir/statics/conic/bounded_forces.h>

#include <vector>

namespace Voussoir
{
/**
 * The simplified homogeneous self-dual embedding of
 *
 *     maximise    sense alpha
 *     subject to  A x + alpha f_1 + f_0 = 0,  x within its bounds,
 *
 * solved by an interior-point method, step by step: Xu, Hung and Ye, *Annals of
 * Operations Research* 62 (1996), 151, with the predictor and corrector of
 * Mehrotra and the corrections of Gondzio, *Computational Optimization and
 * Applications* 6 (1996), 137. A problem without an optimum has an answer, too:
 * a ray of forces that grow without bound, or a mechanism that no factor stops.
 *
 * x are the forces of BoundedForces, with slacks s >= 0 of their bounds; the
 * displacement u, with multipliers z >= 0 of the bounds, are the multipliers of
 * the balance, with the work sense of f_1: where z is the opening and the
 * sliding either way, u is a mechanism. All of them are over tau, which goes to
 * zero where there is no optimum.
 */
class SelfDual
{
public:
  /** The loads, n_dofs() numbers each, zero for held bodies. */
  struct Loads
  {
    /** f_0. */
    std::vector<double> dead;
    /** f_1; empty to look for any forces that balance f_0. */
    std::vector<double> live;
    /** 1 for the greatest alpha, -1 for the least. */
    double sense;
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
   * @param loads on the bodies.
   */
  SelfDual(BoundedForces &forces, Loads loads);

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
    /** The slacks and the multipliers, a number for each bound. */
    std::vector<double> s, z;
    /** @} */
    /** The factor. */
    double alpha;
  };
  /** The present point. */
  Point point() const;
  /**
   * The largest of all errors: the gap between the two objectives, relative to
   * alpha, and of the balance of forces, the bounds and the multipliers.
   */
  double merit() const { return error; }
  /** The factor at present. */
  double alpha() const { return now.alpha / now.tau; }
  /** The number of steps taken. */
  unsigned int n_iterations() const { return iterations; }

private:
  /** Point and tau, kappa; also of a step. */
  struct Variables
  {
    std::vector<double> x, u, s, z;
    double alpha, tau, kappa;
  };
  using Step = Variables;
  /** The residuals of the five groups of equations. */
  struct Residuals
  {
    std::vector<double> balance, bounds, multipliers;
    double live_work, gap;
  };

  Residuals residuals() const;
  double mean_product() const;
  State judge();
  bool prepare();
  void solve_bordered(const std::vector<double> &r1,
                      const std::vector<double> &balance,
                      double live_work,
                      Variables &found);
  Step direction(const std::vector<double> &products,
                 double last_product,
                 double part);
  double longest(const Step &step) const;
  void find_products(const Step &step,
                     double length,
                     std::vector<double> &products,
                     double &last) const;
  double keep_products_near(const Step &step, double length) const;

  BoundedForces &forces;
  const Loads loads;
  /** The largest component of all loads. */
  const double size_of_loads;
  /** The factor below which differences are absolute. */
  double unit_of_alpha = 0.;
  Variables now;
  Residuals residual;
  double error = 0.;
  unsigned int iterations = 0;
  double least_product;
  unsigned int iteration_of_least = 0;

  // Of a step:
  /** z / s of each bound; the coefficient of each row. */
  std::vector<double> ratio, stiffness;
  /** The solution for f_1. */
  std::vector<double> u_of_live;
  double work_of_live = 0.;
  /** The derivative by tau. */
  Step by_tau;
  double slope_of_tau = 0.;
};
} // namespace Voussoir

#endif
