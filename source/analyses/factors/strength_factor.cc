// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/factors/strength_factor.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/conic/feasible_state.h>
#include <voussoir/statics/problem/discretise.h>

#include <cmath>
#include <utility>

namespace Voussoir
{
namespace
{
/** Strengths that much smaller, or greater, are none, or any. */
constexpr double largest_divisor = 1e6;

/** The search by bisection. */
class StrengthSearch
{
public:
  StrengthSearch(const Scene &scene,
                 const LoadFactorControls &controls,
                 Terminal &terminal)
      : scene(scene), controls(controls), terminal(terminal)
  {}

  LoadFactorAnswer find();

private:
  enum class Verdict
  {
    carried,
    collapse,
    unknown
  };
  Verdict judge(double divisor);
  void bracket();
  void bisect();

  const Scene &scene;
  const LoadFactorControls &controls;
  Terminal &terminal;
  LoadFactor found;
};

/** What happens with the strengths divided, kept if it is a better proof. */
StrengthSearch::Verdict StrengthSearch::judge(const double divisor)
{
  const Scene divided = with_strengths_divided(scene, divisor);
  const DiscreteProblem problem = discretise(divided);
  Solution any =
      find_state_or_collapse(problem, controls.n_max_iterations, terminal);
  found.n_iterations += any.n_iterations;
  terminal.iteration("Strength factor", text("divided by ", divisor, ": ",
                                             any.mechanism     ? "collapse"
                                             : any.converged() ? "carried"
                                                               : "not known"));
  if (any.mechanism)
  {
    Motion motion = dimensional_motion(problem, *any.mechanism);
    const MechanismCertificate proof = certify_mechanism(divided, motion);
    if (!proves_collapse(proof))
      return Verdict::unknown;
    found.mechanism = std::move(motion);
    found.bound = divisor;
    found.proof = {divisor, 0., proof.closing_violation};
    return Verdict::collapse;
  }
  if (!any.converged())
    return Verdict::unknown;
  found.forces = dimensional_forces(problem, any);
  found.carried = divisor;
  return Verdict::carried;
}

/** Find a divisor that is carried, and one that is not. */
void StrengthSearch::bracket()
{
  const Verdict at_one = judge(1.);
  if (at_one != Verdict::carried)
    for (double divisor = 0.5; divisor * largest_divisor >= 1.; divisor *= 0.5)
      if (judge(divisor) == Verdict::carried)
        break;
  if (at_one != Verdict::collapse)
    for (double divisor = 2.; divisor <= largest_divisor; divisor *= 2.)
      if (judge(divisor) == Verdict::collapse)
        break;
}

void StrengthSearch::bisect()
{
  const auto middle = [](const double a, const double b) {
    return std::sqrt(a * b);
  };
  double not_carried = found.bound;
  while (not_carried / found.carried - 1. > controls.tolerance)
    if (const double divisor = middle(found.carried, not_carried);
        judge(divisor) != Verdict::carried)
      not_carried = divisor;
  // The same, unless it is not known what happens there.
  double no_collapse = not_carried;
  while (found.bound / no_collapse - 1. > controls.tolerance)
    if (const double divisor = middle(no_collapse, found.bound);
        judge(divisor) != Verdict::collapse)
      no_collapse = divisor;
}

LoadFactorAnswer StrengthSearch::find()
{
  found.carried = 0.;
  found.bound = std::numeric_limits<double>::infinity();
  LoadFactorAnswer answer;
  if (judge(std::numeric_limits<double>::infinity()) == Verdict::carried)
  {
    // Pressure alone carries the loads, with any strengths.
    found.is_unbounded = true;
    found.carried = 1.;
    found.stop = Stop::Reason::converged;
    answer.factor = std::move(found);
    return answer;
  }
  found.bound = std::numeric_limits<double>::infinity();
  found.mechanism = {};
  bracket();
  if (!(found.carried > 0.) && found.has_mechanism())
  {
    answer.collapse = std::move(found.mechanism);
    return answer;
  }
  if (!(found.carried > 0.))
    throw SolverError("The strength factor was not found: neither forces nor a "
                      "mechanism prove anything, whatever the strengths. Try a "
                      "larger 'Solver/Maximum iterations'.");
  if (found.has_mechanism())
    bisect();
  found.stop = found.width() <= controls.tolerance ? Stop::Reason::converged
                                                   : Stop::Reason::rounding;
  answer.factor = std::move(found);
  return answer;
}
} // namespace

Scene with_strengths_divided(const Scene &scene, const double divisor)
{
  Scene divided = scene;
  for (auto *const strengths : {&divided.strength, &divided.coefficient})
    for (double &strength : *strengths)
      strength /= divisor;
  return divided;
}

void check_strength_factor(const Scene &scene,
                           const LoadFactorControls &controls)
{
  if (!scene.dilates)
    throw InputError("'Load factor/Factor' is 'strength', and 'Friction/Law' "
                     "is 'Coulomb', for which what is carried with some "
                     "strengths need not be so with greater ones; set the law "
                     "to 'associated Coulomb', or the factor to one of loads.");
  if (!controls.greatest)
    throw InputError("'Load factor/Direction' is 'least', but strengths may be "
                     "multiplied by any number: set it to 'greatest', or "
                     "'Factor' to one of loads.");
  if (!scene.is_loaded())
    throw InputError("'Load factor/Factor' is 'strength', and there are no "
                     "loads to be carried: 'Loads' gives them.");
}

LoadFactorAnswer find_strength_factor(const Scene &scene,
                                      const LoadFactorControls &controls,
                                      Terminal &terminal)
{
  return StrengthSearch(scene, controls, terminal).find();
}
} // namespace Voussoir
