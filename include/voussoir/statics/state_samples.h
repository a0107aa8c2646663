// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_state_samples_h
#define voussoir_statics_state_samples_h

#include <voussoir/scene/range_parameters.h>
#include <voussoir/scene/scene.h>
#include <voussoir/terminal/terminal.h>

#include <vector>

namespace Voussoir
{
/** The mean and the spread of a force; S L. */
struct Moments
{
  /** The mean. */
  double mean = 0.;
  /** The standard deviation. */
  double deviation = 0.;
};

/**
 * Forces drawn from all admissible states of a scene with equal probability for
 * equal volumes of the set of them, the flat measure of the force network
 * ensemble (Snoeijer, Vlugt, van Hecke and van Saarloos, *Physical Review
 * Letters* 92 (2004) 054302): of f_e^n and f_e^t of each interface, or where
 * blocks turn of the normal forces at both ends.
 */
struct StateSamples
{
  /** @{ */
  /** f_e^n and f_e^t of each interface. */
  std::vector<Moments> normal, tangential;
  /** @} */
  /** The coefficient of correlation of -f_e^n and f_e^t; zero without spread.
   */
  std::vector<double> correlation;
  /** The number of samples. */
  unsigned int n = 0;
  /** The number of steps from one to the next. */
  unsigned int n_steps = 0;
  /**
   * The dimension of the set: the number of forces that vary, less that of the
   * balances that they are in. More, if some of these follow from others.
   */
  unsigned int dimension = 0;
  /**
   * The largest ratio, over all forces, of the spread of all chains together to
   * that within each, after Gelman and Rubin (*Statistical Science* 7 (1992)
   * 457): one if the chains have forgotten where they began.
   */
  double mixing = 1.;
  /** The largest Certificate::error() of the last states of the chains. */
  double error_of_states = 0.;
};

/** StateSamples::mixing above which the chains are too short. */
constexpr double largest_mixing = 1.1;

/**
 * Whether states of a scene can be drawn, known before any is found.
 *
 * @throws InputError if interfaces bear tension or crush.
 */
void check_can_be_sampled(const Scene &scene);

/**
 * Draw them by hit-and-run (Smith, *Operations Research* 32 (1984) 1296): from
 * a state go a random way along a random direction that changes no balance. The
 * directions are scaled by the spread of each force among some extreme states.
 * Equal seeds give equal numbers, on any number of threads or processes.
 *
 * @param scene whose loads are carried.
 * @param wanted how many.
 * @param terminal sees the progress.
 * @throws InputError as check_can_be_sampled() does, and if forces have no
 *   bound, so that there is no such measure.
 * @throws SolverError as AllStates does, or if friction is at its limit in all
 *   states.
 */
StateSamples draw_samples(const Scene &scene,
                          const SamplesWanted &wanted,
                          Terminal &terminal);
} // namespace Voussoir

#endif
