// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/samples/billiard_walk.h>
#include <voussoir/analyses/samples/chain_diagnosis.h>
#include <voussoir/analyses/samples/state_samples.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/contact/contact_points.h>
#include <voussoir/scene/proofs/certificate.h>
#include <voussoir/statics/problem/discretise.h>

#include <deal.II/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <mutex>

namespace Voussoir
{
namespace
{
/** The number of chains, which run beside each other. */
constexpr unsigned int n_chains = 4;
/** How close to a vertex each begins. */
constexpr double share_of_way = 0.9;
/** The share of the samples that is drawn first and left out. */
constexpr double share_left_out = 0.25;
/** The samples that are drawn for one that is wanted, not to be in need of all
 * of them being independent. */
constexpr unsigned int n_for_one = 2;
/**
 * The least number of samples that is drawn: a hundred of each chain, without
 * which its halves tell nothing (Vehtari and others, see ChainDiagnosis).
 */
constexpr unsigned int least_number = 400;
/** How much more, and how many times as many steps are taken next time. */
constexpr double more = 1.25;
constexpr double least_growth = 2., largest_growth = 8.;
/** Of forces of order one: no spread of them. */
constexpr double no_force_in_samples = 1e-8;
/** The number of forces of which the square fits into a gigabyte or so. */
constexpr std::size_t most_forces = 12000;

/** What the chains have of the forces of one interface, less the first. */
struct Series
{
  std::vector<std::vector<double>> p, q;
};

/** Chains, and the samples that they have drawn last. */
class Chains
{
public:
  Chains(const StatePolytope &polytope,
         const ExtremeStates &extremes,
         const DikinEllipsoid &ellipsoid,
         unsigned int seed)
      : polytope(polytope), centre(ellipsoid.centre())
  {
    for (unsigned int c = 0; c < n_chains; ++c)
      walks.push_back(std::make_unique<BilliardWalk>(
          polytope, extremes, ellipsoid,
          ellipsoid.towards(extremes.vertices()[c], share_of_way),
          n_chains * (seed + 1) + c));
    drawn.resize(n_chains);
  }

  /** Draw @p n samples of each chain, @p n_steps apart. */
  void draw(unsigned int n, unsigned int n_steps, Terminal &terminal);
  /** What was drawn, of interface @p e. */
  Series series(unsigned int e) const;
  /** Where each chain is. */
  const std::vector<std::unique_ptr<BilliardWalk>> &of() const { return walks; }

private:
  void keep(unsigned int c);

  const StatePolytope &polytope;
  const std::vector<double> &centre;
  std::vector<std::unique_ptr<BilliardWalk>> walks;
  /** Of each chain, sample by sample, p and q of each interface. */
  std::vector<std::vector<double>> drawn;
};

void Chains::draw(const unsigned int n,
                  const unsigned int n_steps,
                  Terminal &terminal)
{
  const unsigned int n_first = std::ceil(share_left_out * n);
  std::mutex mutex;
  std::size_t n_done = 0;
  const std::string what =
      text("samples, ", counted(n_steps, "step"), " apart");
  const auto walk = [&](const unsigned int c) {
    drawn[c].clear();
    for (unsigned int k = 0; k < n_first + n; ++k)
    {
      walks[c]->go(n_steps);
      if (k < n_first)
        continue;
      keep(c);
      const std::lock_guard<std::mutex> lock(mutex);
      terminal.progress(++n_done, std::size_t(n) * n_chains, what);
    }
  };
  dealii::parallel::apply_to_subranges(
      0U, n_chains,
      [&](const unsigned int begin, const unsigned int end) {
        for (unsigned int c = begin; c < end; ++c)
          walk(c);
      },
      1);
}

/** From the centre, so that no digits cancel. */
void Chains::keep(const unsigned int c)
{
  const std::vector<double> &x = walks[c]->state();
  const DiscreteProblem &problem = polytope.problem();
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    const std::size_t r = problem.first_row(e);
    const unsigned int n_contacts = problem.n_contacts(e);
    double p = 0.;
    for (unsigned int k = 0; k < n_contacts; ++k)
      p += centre[r + k] - x[r + k];
    drawn[c].push_back(p);
    drawn[c].push_back(x[r + n_contacts] - centre[r + n_contacts]);
  }
}

Series Chains::series(const unsigned int e) const
{
  Series of;
  const std::size_t n = 2 * polytope.problem().joints().size();
  for (const std::vector<double> &chain : drawn)
  {
    of.p.emplace_back();
    of.q.emplace_back();
    for (std::size_t k = 2 * std::size_t(e); k < chain.size(); k += n)
    {
      of.p.back().push_back(chain[k]);
      of.q.back().push_back(chain[k + 1]);
    }
  }
  return of;
}

double correlation_of(const Series &series,
                      const ChainDiagnosis &p,
                      const ChainDiagnosis &q)
{
  if (!(p.deviation > 0.) || !(q.deviation > 0.))
    return 0.;
  double sum = 0.;
  std::size_t n = 0;
  for (unsigned int c = 0; c < series.p.size(); ++c)
    for (std::size_t k = 0; k < series.p[c].size(); ++k, ++n)
      sum += (series.p[c][k] - p.mean) * (series.q[c][k] - q.mean);
  return sum / (n * p.deviation * q.deviation);
}

/** What was drawn of each force; @p unit is that of forces. */
StateSamples
moments_of(const Chains &chains, const StatePolytope &polytope, double unit)
{
  StateSamples samples;
  samples.effective = std::numeric_limits<double>::infinity();
  const unsigned int n_joints = polytope.problem().joints().size();
  samples.normal.resize(n_joints);
  samples.tangential.resize(n_joints);
  samples.correlation.resize(n_joints);
  std::mutex mutex;
  const auto find = [&](const unsigned int e) {
    const Series series = chains.series(e);
    const ChainDiagnosis p = diagnose(series.p, no_force_in_samples);
    const ChainDiagnosis q = diagnose(series.q, no_force_in_samples);
    // From the centre, and pressure is positive.
    samples.normal[e] = {-unit * p.mean, unit * p.deviation, unit * p.error()};
    samples.tangential[e] = {unit * q.mean, unit * q.deviation,
                             unit * q.error()};
    samples.correlation[e] = correlation_of(series, p, q);
    const std::lock_guard<std::mutex> lock(mutex);
    for (const ChainDiagnosis &of : {p, q})
    {
      samples.effective = std::min(samples.effective, of.effective);
      samples.mixing = std::max(samples.mixing, of.mixing);
      samples.largest_error =
          std::max(samples.largest_error, unit * of.error());
    }
  };
  constexpr unsigned int a_few = 8;
  dealii::parallel::apply_to_subranges(
      0U, n_joints,
      [&](const unsigned int begin, const unsigned int end) {
        for (unsigned int e = begin; e < end; ++e)
          find(e);
      },
      a_few);
  return samples;
}

/** Draw as is wanted; the means are those of differences from the centre. */
StateSamples draw_from(Chains &chains,
                       const StatePolytope &polytope,
                       const double unit,
                       const SamplesWanted &wanted,
                       Terminal &terminal)
{
  const unsigned int n_wanted = std::max(wanted.n, least_number);
  const bool is_given = wanted.n_steps > 0;
  const unsigned int n_all = is_given ? n_wanted : n_for_one * n_wanted;
  const unsigned int n = (n_all + n_chains - 1) / n_chains;
  for (unsigned int n_steps = is_given ? wanted.n_steps : 1;;)
  {
    chains.draw(n, n_steps, terminal);
    StateSamples samples = moments_of(chains, polytope, unit);
    samples.n = n * n_chains;
    samples.n_steps = n_steps;
    samples.is_given = is_given;
    if (is_given || n_steps >= wanted.most_steps ||
        (samples.effective >= n_wanted && samples.have_settled()))
      return samples;
    const double growth = std::clamp(more * n_wanted / samples.effective,
                                     least_growth, largest_growth);
    n_steps =
        std::min<unsigned int>(std::ceil(growth * n_steps), wanted.most_steps);
  }
}

/** Add the forces of the state @p x to the means. */
void add_state(const StatePolytope &polytope,
               const std::vector<double> &x,
               const double unit,
               StateSamples &samples)
{
  for (unsigned int e = 0; e < samples.normal.size(); ++e)
  {
    const unsigned int n = polytope.problem().n_contacts(e);
    const double *of = &x[polytope.problem().first_row(e)];
    for (unsigned int k = 0; k < n; ++k)
      samples.normal[e].mean += unit * of[k];
    samples.tangential[e].mean += unit * of[n];
  }
}

double error_of_state(const Scene &scene,
                      const StatePolytope &polytope,
                      const std::vector<double> &x)
{
  Solution state;
  state.forces = x;
  return certify(scene, dimensional_forces(polytope.problem(), state)).error();
}

/** The samples of a set that is a point. */
StateSamples samples_of_point(const Scene &scene,
                              const StatePolytope &polytope,
                              const std::vector<double> &x,
                              const unsigned int n)
{
  StateSamples samples;
  samples.normal.resize(polytope.problem().joints().size());
  samples.tangential.resize(samples.normal.size());
  samples.correlation.assign(samples.normal.size(), 0.);
  samples.n = n;
  samples.effective = n;
  samples.error_of_states = error_of_state(scene, polytope, x);
  return samples;
}
} // namespace

void check_can_be_sampled(const Scene &scene)
{
  if (scene.has_normal_limits())
    throw InputError("'Ranges/Samples' draws states of interfaces that neither "
                     "bear tension nor crush, and 'Contact' gives them "
                     "strengths; set 'Ranges/Samples = 0', or leave these "
                     "out.");
  if (!scene.links.empty())
    throw InputError("'Ranges/Samples' draws the forces of interfaces alone, "
                     "and there are 'Ties' or 'Fill'; set 'Ranges/Samples = "
                     "0', or leave these out.");
  const std::size_t of_each = contact_points(scene.turns()).pressure.size() + 1;
  const std::size_t n = scene.packing.interfaces().size() * of_each;
  if (n > most_forces)
    throw InputError(text("'Ranges/Samples' draws states of at most ",
                          most_forces, " forces, and this packing has ", n,
                          ", ", of_each,
                          " on each interface; set 'Ranges/Samples = 0', or "
                          "take fewer blocks."));
}

StateSamples draw_samples(const Scene &scene,
                          const SamplesWanted &wanted,
                          Terminal &terminal)
{
  check_can_be_sampled(scene);
  const StatePolytope polytope(scene);
  const double unit =
      polytope.problem().stress_scale() * polytope.problem().length_scale();
  const ExtremeStates extremes(scene, polytope, wanted.seed);
  StateSamples samples;
  std::vector<double> origin = extremes.middle();
  if (extremes.dimension() == 0)
    samples = samples_of_point(scene, polytope, origin,
                               std::max(wanted.n, least_number));
  else
  {
    const DikinEllipsoid ellipsoid(polytope, extremes);
    Chains chains(polytope, extremes, ellipsoid, wanted.seed);
    samples = draw_from(chains, polytope, unit, wanted, terminal);
    samples.dimension = extremes.dimension();
    for (const auto &chain : chains.of())
      samples.error_of_states =
          std::max(samples.error_of_states,
                   error_of_state(scene, polytope, chain->state()));
    origin = ellipsoid.centre();
  }
  add_state(polytope, origin, unit, samples);
  return samples;
}
} // namespace Voussoir
