// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_factors_divided_strengths_h
#define voussoir_analyses_factors_divided_strengths_h

#include <voussoir/analyses/factors/load_factor.h>
#include <voussoir/statics/conic/blended_loads.h>
#include <voussoir/statics/conic/proven_factor.h>

#include <optional>
#include <utility>
#include <vector>

namespace Voussoir
{
/** What is known of the loads with strengths that are divided by a number f. */
struct ShareOfLoads
{
  /** @{ */
  /** Whether all of them are carried, or collapse; neither if not known. */
  bool is_carried = false, collapses = false;
  /** @} */
  /** @{ */
  /**
   * The greatest share t of BlendedLoads, one at the limit, and its derivative
   * with -log f: the work of friction in the mechanism in which the live loads
   * do the work one. Zero if they are not known.
   */
  double t = 0., slope = 0.;
  /** @} */
};

/**
 * Says of divisors whether the loads are carried or collapse, and keeps the
 * best proof of either: forces, with the greatest divisor that they are within
 * their limits with, and a mechanism with the least that it proves the collapse
 * of.
 */
template <typename SceneOf>
class DividedStrengths
{
public:
  /** What is asked of a divisor. */
  enum class Question
  {
    /** The share, as accurate as a step of Newton's method needs it. */
    share,
    /** Whether it is more than one or less. */
    side
  };

  /** All must outlive this object. */
  DividedStrengths(const SceneOf &scene,
                   const LoadFactorControls &controls,
                   Terminal &terminal);

  /** Look at one divisor, which may be infinite. */
  ShareOfLoads judge(double divisor, Question question);
  /**
   * Where by Newton's method t is one. Zero if nothing is known; infinite if no
   * strengths are needed.
   */
  double newton(double divisor, const ShareOfLoads &share) const;
  /** The best proofs, and the iterations of all divisors. */
  const FactorOf<SceneOf> &best() const { return found; }
  /** The same, to be kept; this object is not used any more. */
  FactorOf<SceneOf> take() { return std::move(found); }

private:
  /** The programme of one divisor. */
  struct Divided
  {
    Divided(const SceneOf &scene, double divisor);
    ShareOfLoads share();
    double carried() const;

    const double divisor;
    const SceneOf scene;
    const DiscreteProblem problem;
    BlendedLoads blend;
    std::optional<ProvenFactor> factor = {};
  };
  bool is_enough(Divided &divided, Question question) const;
  bool find(Divided &divided, Question question, double tolerance);
  void keep_forces(const Divided &divided, std::vector<double> forces);
  bool keep_mechanism(Divided &divided);
  double greatest_divisor(const Divided &divided,
                          const typename SceneOf::Forces &forces) const;
  double least_divisor(double divisor,
                       const typename SceneOf::MotionOfBlocks &motion) const;

  const SceneOf &scene;
  const LoadFactorControls &controls;
  Terminal &terminal;
  FactorOf<SceneOf> found;
  /** The way to the share of the last divisor, which the next begins with. */
  ProvenFactor::Course course;
  double divisor_of_course = 1.;
};

/** @{ */
/** Whether strengths grow with the pressure. */
bool has_coefficient(const Scene &scene);
bool has_coefficient(const SpaceScene &scene);
/** @} */
} // namespace Voussoir

#endif
