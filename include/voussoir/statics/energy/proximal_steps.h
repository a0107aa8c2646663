// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_energy_proximal_steps_h
#define voussoir_statics_energy_proximal_steps_h

#include <voussoir/algebra/newton.h>

#include <limits>
#include <vector>

namespace Voussoir
{
/**
 * The course of Newton's method for elastic joints that open and slide: its own
 * steps with hardly any proximal term, which solve in one if no joint opens or
 * slides. When many joints slide these steps are cut short. Then the proximal
 * point method: minimise with a term around a centre, move the centre there,
 * and make the term smaller as long as that goes well.
 */
class ProximalSteps
{
public:
  /** @param newton where it is now; it must outlive this object. */
  explicit ProximalSteps(Newton &newton) : newton(newton), centre(newton.u()) {}

  /**
   * Take a step.
   *
   * @return its length.
   * @throws NewtonFailure as Newton::step() does.
   */
  double advance();

private:
  void move_centre();
  void restart(double new_shift);

  Newton &newton;
  std::vector<double> centre;
  double shift = least_shift;
  unsigned int n_inner = 0, n_outer = 0;
  double previous_imbalance = std::numeric_limits<double>::infinity();
};
} // namespace Voussoir

#endif
