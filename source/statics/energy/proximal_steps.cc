// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/energy/proximal_steps.h>

#include <algorithm>

namespace Voussoir
{
namespace
{
/** The shortest cut of Newton's own steps with which they are still good. */
constexpr double shortest_good_step = 0.01;
constexpr unsigned int n_own_steps = 15;
/** The first proximal term of weight, relative to stiffnesses of order one. */
constexpr double first_proximal_shift = 1e-3;
/**
 * The imbalance with the proximal term, over that without, below which the
 * centre of that term moves.
 */
constexpr double inner_reduction = 0.1;
/** The factor by which the imbalance must fall for a smaller shift. */
constexpr double outer_reduction = 0.7;
/**
 * Steps to a proximal minimum that make it an easy and a hard one, and minima
 * after which to try a smaller shift even so.
 */
constexpr unsigned int n_easy = 5, n_hard = 20, n_patience = 4;
} // namespace

double ProximalSteps::advance()
{
  const double length = newton.step(shift, centre);
  ++n_inner;
  if (shift == least_shift)
  {
    centre = newton.u();
    if (length < shortest_good_step || n_inner >= n_own_steps)
      restart(first_proximal_shift);
  }
  else if (newton.imbalance(shift, centre) <=
           inner_reduction * newton.imbalance())
    move_centre();
  else if (n_inner > n_hard)
    restart(10. * shift);
  return length;
}

void ProximalSteps::move_centre()
{
  ++n_outer;
  const bool better = newton.imbalance() < outer_reduction * previous_imbalance;
  previous_imbalance = newton.imbalance();
  double smaller = shift;
  if (better || n_outer >= n_patience)
    smaller = n_inner <= n_easy ? shift / 100. : shift / 10.;
  if (smaller < shift)
    n_outer = 0;
  restart(std::max(smaller, 2. * least_shift));
}

void ProximalSteps::restart(const double new_shift)
{
  shift = new_shift;
  centre = newton.u();
  n_inner = 0;
}
} // namespace Voussoir
