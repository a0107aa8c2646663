// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_samples_state_samples_h
#define voussoir_analyses_samples_state_samples_h

#include <voussoir/scene/scene.h>
#include <voussoir/terminal/terminal.h>

#include <vector>

namespace Voussoir
{
/** How many states are drawn; see draw_samples(). */
struct SamplesWanted
{
  /** The number of independent states that their means are to be worth. */
  unsigned int n = 0;
  /** The number of steps from one to the next; 0: as many as that takes. */
  unsigned int n_steps = 0;
  /** The largest number of steps, if it is not given. */
  unsigned int most_steps = 256;
  /** Of the random numbers. */
  unsigned int seed = 1;
};

/** The mean and the spread of a force; S L. */
struct Moments
{
  /** The mean. */
  double mean = 0.;
  /** The standard deviation. */
  double deviation = 0.;
  /** The standard error of the mean; see ChainDiagnosis. */
  double error = 0.;
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
  /** True if that was given, and not found. */
  bool is_given = false;
  /** ExtremeStates::dimension(). */
  unsigned int dimension = 0;
  /** The least ChainDiagnosis::effective of all forces. */
  double effective = 0.;
  /** The largest ChainDiagnosis::mixing of all forces. */
  double mixing = 1.;
  /** The largest Moments::error of all forces; S L. */
  double largest_error = 0.;
  /** The largest Certificate::error() of the last states of the chains. */
  double error_of_states = 0.;

  /** The largest mixing of chains that have settled. */
  static constexpr double largest_mixing = 1.1;
  /** The least effective number of samples that they have. */
  static constexpr double least_effective = 100.;
  /** False if the moments tell of the chains, and not of the states. */
  bool have_settled() const
  {
    return mixing <= largest_mixing && effective >= least_effective;
  }
};

/**
 * Whether states of a scene can be drawn, known before any is found.
 *
 * @throws InputError if interfaces bear tension or crush, or there are too many
 *   forces.
 */
void check_can_be_sampled(const Scene &scene);

/**
 * Draw them by four BilliardWalks beside each other, from near different
 * vertices of the polytope of states. A quarter as many as are counted is left
 * out first. Unless the number of steps from one sample to the next is given,
 * twice as many samples as are wanted are drawn at one step, and then again,
 * going on from there, at more, until for each force the effective number of
 * samples is the one that is wanted.
 *
 * Equal seeds give equal numbers, on any number of threads or processes.
 *
 * @param scene whose loads are carried.
 * @param wanted how many.
 * @param terminal sees the progress.
 * @throws InputError as check_can_be_sampled() does, and if forces have no
 *   bound, so that there is no such measure.
 * @throws SolverError as ExtremeStates and DikinEllipsoid do.
 */
StateSamples draw_samples(const Scene &scene,
                          const SamplesWanted &wanted,
                          Terminal &terminal);
} // namespace Voussoir

#endif
