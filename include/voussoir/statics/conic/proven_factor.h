// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_conic_proven_factor_h
#define voussoir_statics_conic_proven_factor_h

#include <voussoir/statics/conic/kept_factor.h>
#include <voussoir/terminal/terminal.h>

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace Voussoir
{
/** The largest FactorState::residual of forces that balance the loads. */
inline constexpr double largest_residual_of_state = 1e-11;
/** The largest SelfDual::merit() of a point worth correcting to a proof. */
inline constexpr double merit_worth_correcting = 1e-2;
/** The largest FactorMotion::closing of a motion that is a proof. */
inline constexpr double largest_closing_of_factor = 1e-12;

/**
 * The greatest alpha of a program of SelfDual with live loads, or the least,
 * between two proofs: forces within their limits that balance the loads at a
 * factor, and a mechanism that bounds all factors. The dead loads need not be
 * carried without the live ones.
 *
 * Points of SelfDual are corrected to proofs as soon as they are near enough.
 */
class ProvenFactor
{
public:
  /** When to stop. */
  struct Controls
  {
    /** The distance of both proofs, over the factor or `small`. */
    double tolerance;
    /** The factor below which differences are absolute. */
    double small;
    /** The number of iterations after which to give up. */
    unsigned int n_max_iterations;
    /** The factor in the user's terms, over alpha. */
    double unit = 1.;
    /** Where it keeps what it knows on its way, or null. */
    Journal *journal = nullptr;
    /** Its name there, among all of the computation. */
    std::string name = {};
  };

  /**
   * @param forces of the joints; it must outlive this object.
   * @param program with live loads and without a cost.
   * @param controls say when to stop.
   * @param terminal sees the iterations.
   */
  ProvenFactor(ConicForces &forces,
               SelfDual::Program program,
               const Controls &controls,
               Terminal &terminal);

  /** Forces far from their limits, at any alpha, or none. */
  using KnownForces = std::function<std::optional<FactorState>()>;
  /** Take these, which prove their own factor, from where they are needed. */
  void set_carried(KnownForces forces) { known = std::move(forces); }
  /** Points of the way to an optimum, each with its error. */
  struct Course
  {
    /** One of them. */
    struct Stop
    {
      /** SelfDual::merit(). */
      double error;
      /** Where. */
      SelfDual::Variables at;
    };
    /** In their order. */
    std::vector<Stop> stops;
    /** Leave the points before the first one with an error below @p least. */
    void cut(double least);
  };
  /**
   * Go on from the last point of @p course, if it has any, the way of another
   * program of the same joints with other strengths, and add this one's.
   */
  void follow(Course &course) { followed = &course; }
  /** Look for both proofs, or until @p is_enough. */
  void find(const std::function<bool()> &is_enough = [] { return false; });

  /** What is known of the program. */
  SelfDual::State state() const { return state_of_program; }
  /** The forces with the best factor; none if there are no proven ones. */
  const std::optional<FactorState> &carried() const { return found.best_state; }
  /** False if that is only what set_carried() had. */
  bool has_found_state() const { return found.has_state; }
  /** The mechanism with the best bound. */
  const std::optional<FactorMotion> &mechanism() const
  {
    return found.best_motion;
  }
  /** What it proves; infinite without one. */
  double bound() const { return found.least_bound; }
  /**
   * The mechanism that proves that no factor is carried, of any size, or near
   * one, if state() is infeasible; or if it is unbounded, as where more of the
   * live loads can always be carried, one that is looked for without regard to
   * the factor.
   *
   * @return nothing if none is found.
   */
  std::optional<FactorMotion> mechanism_of_all();
  /** The number of iterations. */
  unsigned int n_iterations() const { return iterations; }

private:
  double width() const;
  double alpha_of_carried() const
  {
    return found.best_state
               ? found.best_state->alpha
               : -program.sense * std::numeric_limits<double>::infinity();
  }
  void keep(const SelfDual &search);
  void go_on(KeptFactor from, SelfDual &search);
  void take_known();
  void find_anchors(const SelfDual::Point &point);
  void look_near(const SelfDual::Point &point, double near_enough);
  void look_farther(const SelfDual::Point &point);
  void keep_if_carried(FactorState state);
  void keep_if_bound(FactorMotion motion);

  ConicForces &forces;
  const SelfDual::Program program;
  const Controls controls;
  Terminal &terminal;
  KnownForces known;
  Course *followed = nullptr;
  SelfDual::State state_of_program = SelfDual::State::running;
  KeptFactor found;
  /** The last point, of a ray. */
  SelfDual::Point ray;
  unsigned int iterations = 0;
};
} // namespace Voussoir

#endif
