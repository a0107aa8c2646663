// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_limited_least_energy_h
#define voussoir_statics_limited_least_energy_h

#include <voussoir/statics/formulation.h>

namespace Voussoir
{
/**
 * LeastEnergy of joints that bear tension or crush, with Tresca's friction: the
 * state of elastic joints that yield.
 *
 * Joints that crush are cut into equal strips, see BoundedRows. Each row has
 * its share of the stiffness of the joint and is perfectly plastic beyond its
 * bounds. Newton's method minimises the energy. Where it gets stuck, which it
 * does beyond the limit load, find_state_or_collapse() says whether there is a
 * state: then the strips are cut anew, or else its answer is taken.
 */
class LimitedLeastEnergy : public Formulation
{
public:
  std::string name() const override { return "least energy"; }
  std::string meaning() const override
  {
    return "the least energy of elastic joints that yield.";
  }
  std::string selection() const override
  {
    return "least energy: the least sum of d_e/|e| times the square of the "
           "force on the interface";
  }

private:
  Solution select(const DiscreteProblem &problem,
                  const SolverControls &controls,
                  Terminal &terminal) const override;
};
} // namespace Voussoir

#endif
