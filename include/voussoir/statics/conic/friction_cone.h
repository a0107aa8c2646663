// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_conic_friction_cone_h
#define voussoir_statics_conic_friction_cone_h

namespace Voussoir
{
/**
 * The friction of one joint as an interior-point method sees it; see
 * InteriorPoint. All nondimensional.
 *
 * With the strength b = s_e |e| and the smoothing length eps, two vectors lie
 * inside the cone of all (a, b, c) with a > sqrt(b^2 + c^2):
 *
 *     s = (r, v, eps),  lambda = (b, -q, -w).
 *
 * v is the part of the sliding that friction resists, r stands for
 * sqrt(v^2 + eps^2), q is the tangential force and w what it leaves of the
 * strength. s . lambda = r b - v q - eps w is positive, and where it vanishes
 * q = b v / sqrt(v^2 + eps^2): smoothed friction, or with eps = 0 Tresca's own.
 *
 * The linearisation is that of Nesterov and Todd, *SIAM Journal on
 * Optimization* 8 (1998), 324, whose compliance is positive wherever s and
 * lambda are in the cone.
 */
class FrictionCone
{
public:
  /**
   * Without sliding and without force.
   *
   * @param strength b, not negative; without strength there is no friction.
   * @param smoothing eps, not negative.
   * @param product s . lambda, positive.
   */
  FrictionCone(double strength, double smoothing, double product);

  /** True if there is friction. */
  bool exists() const { return b > 0.; }
  /** The force q. */
  double force() const { return q; }
  /** The sliding v. */
  double sliding() const { return v; }
  /** s . lambda; zero if there is no friction. */
  double product() const { return r * b - v * q - eps * w; }

  /** Find the linearisation at the present point; before all below. */
  void linearise();
  /** dv = compliance() dq + constant() in a step to the product @p target. */
  double compliance() const { return slope; }
  /** The constant beside compliance(). */
  double constant(const double target) const
  {
    const double of_v = target * (q / room) - v;
    const double of_eps = target * (w / room) - eps;
    return of_v - h12 / h22 * of_eps + second_of_v;
  }

  /** A step, by what changes in it. */
  struct Step
  {
    double q; /**< the force */
    double w; /**< what it leaves of the strength */
    double v; /**< the sliding */
    double r; /**< its smoothed size */
  };
  /** The step to the product @p target whose change of force is @p dq. */
  Step step(double target, double dq) const;
  /**
   * Let the next steps, until linearise(), make up for the products of changes
   * that the linearisation leaves out of the step @p predictor (Mehrotra, *SIAM
   * Journal on Optimization* 2 (1992), 575); without smoothing only.
   */
  void correct_for(const Step &predictor);
  /** The multiple of the step that lambda may take. */
  double longest_of_force(const Step &step) const;
  /** The multiple of the step that s may take. */
  double longest_of_sliding(const Step &step) const;
  /** Take parts of the step, of lambda and of s. */
  void take(const Step &step,
            const double part_of_force,
            const double part_of_sliding)
  {
    q += part_of_force * step.q;
    w += part_of_force * step.w;
    v += part_of_sliding * step.v;
    r += part_of_sliding * step.r;
  }

private:
  double b, eps;
  double q = 0., w = 0., v = 0., r = 0.;
  /** b^2 - q^2 - w^2. */
  double room = 0.;
  /** The matrix that takes a change of lambda to minus that of s. */
  double h01 = 0., h02 = 0., h11 = 0., h12 = 0., h22 = 1.;
  double slope = 0.;
  /** What correct_for() adds to a step. */
  double second_of_v = 0., second_of_r = 0.;
};
} // namespace Voussoir

#endif
