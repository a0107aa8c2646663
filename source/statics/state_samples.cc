// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/random.h>
#include <voussoir/base/text.h>
#include <voussoir/scene/certificate.h>
#include <voussoir/statics/all_states.h>
#include <voussoir/statics/any_state.h>
#include <voussoir/statics/state_samples.h>

#include <deal.II/base/parallel.h>

#include <mutex>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <utility>

namespace Voussoir
{
namespace
{
/** The number of chains, which run beside each other. */
constexpr unsigned int n_chains = 4;
/** The number of states from which the spread of forces is estimated. */
constexpr unsigned int n_extremes = 24;
/** The share of the samples that is drawn first and left out. */
constexpr double share_left_out = 0.25;
/** Of forces of order one: what is none, and no spread of them. */
constexpr double no_force = 1e-8;
/** What a direction may leave on a body, and how often that is improved. */
constexpr double enough = 1e-14;
constexpr unsigned int n_gradients = 10;

constexpr double infinity = std::numeric_limits<double>::infinity();

using Vector = std::vector<double>;

/**
 * The forces of a problem as rows, n_contacts() normal ones of each joint, not
 * positive, and the tangential one, without the limits on them.
 */
class Rows
{
public:
  explicit Rows(const Scene &scene)
      : scaled(scene), joints(scaled.joints().begin(), scaled.joints().end()),
        unlimited(scaled.with_tresca(with_friction(scaled)))
  {}

  const DiscreteProblem &problem() const { return unlimited; }
  std::size_t n_joints() const { return joints.size(); }
  unsigned int n_contacts() const { return scaled.n_contacts(); }
  unsigned int n_rows() const { return n_contacts() + 1; }
  /** What friction admits beyond f_e^t and -f_e^t of joint @p e, at @p x. */
  std::array<double, 2> room(const unsigned int e, const double *x) const
  {
    double admitted = joints[e].strength;
    for (unsigned int k = 0; k < n_contacts(); ++k)
      admitted -= joints[e].coefficient * x[k];
    return {{admitted - x[n_contacts()], admitted + x[n_contacts()]}};
  }
  /** What room() changes by along @p d. */
  std::array<double, 2> change_of_room(const unsigned int e,
                                       const double *d) const
  {
    double admitted = 0.;
    for (unsigned int k = 0; k < n_contacts(); ++k)
      admitted -= joints[e].coefficient * d[k];
    return {{admitted - d[n_contacts()], admitted + d[n_contacts()]}};
  }
  /** True if friction admits more where joint @p e is pressed more. */
  bool is_coulomb(const unsigned int e) const
  {
    return joints[e].coefficient > 0.;
  }

private:
  static Vector with_friction(const DiscreteProblem &problem)
  {
    Vector limits;
    for (const auto &joint : problem.joints())
      limits.push_back(joint.strength > 0. || joint.coefficient > 0. ? 1. : 0.);
    return limits;
  }

  const DiscreteProblem scaled;
  const std::vector<Structure::Joint> joints;
  const DiscreteProblem unlimited;
};

/** Some extreme states, their mean, and the spread of each force among them. */
class Extremes
{
public:
  Extremes(const Scene &scene, const Rows &rows, unsigned int seed);

  /** A state inside all limits but for those that no state is inside of. */
  Vector centre;
  /** Of each row; zero where all states have the same force. */
  Vector spread;

private:
  void add(const ForceFunction &function);
  void add_random(unsigned int seed);
  void leave_limits();
  void find_mean();

  const Scene &scene;
  const Rows &rows;
  const AllStates states;
  StateProgram program;
  std::vector<Vector> extremes;
};

Extremes::Extremes(const Scene &scene,
                   const Rows &rows,
                   const unsigned int seed)
    : scene(scene), rows(rows), states(scene), program(states.program())
{
  add_random(seed);
  find_mean();
  leave_limits();
  find_mean();
}

void Extremes::add(const ForceFunction &function)
{
  const GreatestValue value = states.greatest(program, function);
  if (!value.is_bounded())
    throw InputError("'Ranges/Samples' asks for states of equal probability, "
                     "and some forces have no bound: they balance by "
                     "themselves. Let fewer edges be supports, or set "
                     "'Ranges/Samples = 0'.");
  extremes.push_back(nondimensional_forces(rows.problem(), value.forces));
}

/** In directions that are all alike. */
void Extremes::add_random(const unsigned int seed)
{
  Random random(seed);
  for (unsigned int k = 0; k < n_extremes; ++k)
  {
    ForceFunction function;
    for (unsigned int e = 0; e < rows.n_joints(); ++e)
    {
      const double start = random.normal(), end = random.normal();
      function.terms.push_back(
          {e, {{start, scene.turns() ? end : start}}, random.normal()});
    }
    add(function);
  }
}

void Extremes::find_mean()
{
  const double n = extremes.size();
  centre.assign(extremes[0].size(), 0.);
  spread.assign(extremes[0].size(), 0.);
  for (const Vector &x : extremes)
    Voussoir::add(centre, 1. / n, x);
  for (const Vector &x : extremes)
    for (std::size_t r = 0; r < x.size(); ++r)
      spread[r] += (x[r] - centre[r]) * (x[r] - centre[r]) / n;
  for (double &of_row : spread)
  {
    of_row = std::sqrt(of_row);
    if (of_row < no_force)
      of_row = 0.;
  }
}

/**
 * Where the mean is at a limit, look whether any state is not; the limits at
 * which all states are belong to forces without spread.
 */
void Extremes::leave_limits()
{
  const unsigned int n = rows.n_contacts();
  for (unsigned int e = 0; e < rows.n_joints(); ++e)
  {
    const double *x = &centre[e * rows.n_rows()];
    for (unsigned int k = 0; k < n; ++k)
      if (x[k] > -no_force)
        add({{{e,
               {{k == 0 || n == 1 ? -1. : 0., k == 1 || n == 1 ? -1. : 0.}},
               0.}}});
    const std::array<double, 2> room = rows.room(e, x);
    for (unsigned int k = 0; k < 2; ++k)
      if (room[k] < no_force)
      {
        const double mu = scene.limits(e).coefficient;
        add({{{e, {{-mu, -mu}}, k == 0 ? -1. : 1.}}});
      }
  }
}

/** What a chain has seen of each joint: sums over its samples. */
struct Sums
{
  struct OfJoint
  {
    double p = 0., q = 0., pp = 0., qq = 0., pq = 0.;
  };
  std::vector<OfJoint> of_joints;
  unsigned int n = 0;
};

/** A walk through the states. */
class Chain
{
public:
  Chain(const Rows &rows, const Extremes &extremes, unsigned int seed);

  /** Take @p n steps. */
  void go(unsigned int n);
  /** Count where it is. */
  void count();
  /** What was counted. */
  const Sums &sums() const { return counted; }
  /** Where it is. */
  const Vector &state() const { return x; }

private:
  void find_direction();
  std::pair<double, double> chord() const;
  void project(const Vector &imbalance, Vector &forces);

  const Rows &rows;
  const Extremes &extremes;
  RowProblem by_rows;
  Random random;
  /** What the loads leave to the forces. */
  Vector balance;
  /** The square of the spread. */
  Vector weight;
  Vector x, direction;
  Sums counted;
};

Chain::Chain(const Rows &rows,
             const Extremes &extremes,
             const unsigned int seed)
    : rows(rows), extremes(extremes), by_rows(rows.problem()), random(seed),
      balance(by_rows.loads()), weight(extremes.spread), x(extremes.centre),
      direction(x.size())
{
  for (double &of_row : weight)
    of_row *= of_row;
  if (!by_rows.forces().prepare(weight))
    throw SolverError("No directions for 'Ranges/Samples' were found: forces "
                      "of very different sizes spoil the digits. Set "
                      "'Ranges/Samples = 0'.");
  counted.of_joints.resize(rows.n_joints());
}

/** Subtract from @p forces what adds up to @p imbalance. */
void Chain::project(const Vector &imbalance, Vector &forces)
{
  const Vector along = by_rows.forces().along(
      by_rows.forces().solve(imbalance, enough, n_gradients));
  for (std::size_t r = 0; r < forces.size(); ++r)
    forces[r] -= weight[r] * along[r];
}

void Chain::find_direction()
{
  for (std::size_t r = 0; r < direction.size(); ++r)
    direction[r] = extremes.spread[r] * random.normal();
  project(by_rows.forces().on_bodies(direction), direction);
}

/** How far it is to the first limit, backwards and forwards. */
std::pair<double, double> Chain::chord() const
{
  std::pair<double, double> ends = {-infinity, infinity};
  // A limit at which all states are is none, nor is one that stays.
  const auto meet = [&ends](const double room, const double change) {
    if (change < 0.)
      ends.second = std::min(ends.second, std::max(room, 0.) / -change);
    else if (change > 0.)
      ends.first = std::max(ends.first, -std::max(room, 0.) / change);
  };
  for (unsigned int e = 0; e < rows.n_joints(); ++e)
  {
    const double *at = &x[e * rows.n_rows()],
                 *along = &direction[e * rows.n_rows()],
                 *spread = &extremes.spread[e * rows.n_rows()];
    bool varies = spread[rows.n_contacts()] > 0.;
    for (unsigned int k = 0; k < rows.n_contacts(); ++k)
      if (spread[k] > 0.)
      {
        meet(-at[k], -along[k]);
        varies |= rows.is_coulomb(e);
      }
    if (!varies)
      continue;
    const std::array<double, 2> room = rows.room(e, at),
                                change = rows.change_of_room(e, along);
    for (unsigned int k = 0; k < 2; ++k)
      meet(room[k], change[k]);
  }
  return ends;
}

void Chain::go(const unsigned int n)
{
  for (unsigned int k = 0; k < n; ++k)
  {
    find_direction();
    const auto [back, forth] = chord();
    if (std::isfinite(back) && std::isfinite(forth))
      add(x, back + random() * (forth - back), direction);
  }
  // Rounding adds up.
  Vector imbalance = by_rows.forces().on_bodies(x);
  add(imbalance, 1., balance);
  by_rows.forces().clear_held(imbalance);
  project(imbalance, x);
}

void Chain::count()
{
  ++counted.n;
  for (unsigned int e = 0; e < rows.n_joints(); ++e)
  {
    const double *of = &x[e * rows.n_rows()],
                 *centre = &extremes.centre[e * rows.n_rows()];
    // From the centre, so that no digits cancel.
    double p = 0.;
    for (unsigned int k = 0; k < rows.n_contacts(); ++k)
      p += centre[k] - of[k];
    const double q = of[rows.n_contacts()] - centre[rows.n_contacts()];
    Sums::OfJoint &sums = counted.of_joints[e];
    sums.p += p;
    sums.q += q;
    sums.pp += p * p;
    sums.qq += q * q;
    sums.pq += p * q;
  }
}

/** Gelman and Rubin's ratio of a force, from its sums of n in each chain. */
class Mixing
{
public:
  void add(const double sum, const double squares, const double n)
  {
    const double mean = sum / n;
    within += (squares / n - mean * mean) / n_chains;
    means += mean / n_chains;
    squares_of_means += mean * mean / n_chains;
  }
  double ratio() const
  {
    const double between = squares_of_means - means * means;
    return within > no_force * no_force
               ? std::sqrt(1. + std::max(between, 0.) / within)
               : 1.;
  }

private:
  double within = 0., means = 0., squares_of_means = 0.;
};

/** Put the sums of all chains together; @p unit is that of forces. */
StateSamples moments_of(const std::vector<std::unique_ptr<Chain>> &chains,
                        const Rows &rows,
                        const Vector &centre,
                        const double unit)
{
  StateSamples samples;
  for (const auto &chain : chains)
    samples.n += chain->sums().n;
  const double n = samples.n;
  for (unsigned int e = 0; e < rows.n_joints(); ++e)
  {
    Sums::OfJoint all;
    Mixing of_p, of_q;
    for (const auto &chain : chains)
    {
      const Sums::OfJoint &of = chain->sums().of_joints[e];
      all.p += of.p;
      all.q += of.q;
      all.pp += of.pp;
      all.qq += of.qq;
      all.pq += of.pq;
      of_p.add(of.p, of.pp, chain->sums().n);
      of_q.add(of.q, of.qq, chain->sums().n);
    }
    const double *at = &centre[e * rows.n_rows()];
    double normal = 0.;
    for (unsigned int k = 0; k < rows.n_contacts(); ++k)
      normal += at[k];
    const double p = all.p / n, q = all.q / n;
    const double variance_p = std::max(all.pp / n - p * p, 0.),
                 variance_q = std::max(all.qq / n - q * q, 0.);
    samples.normal.push_back(
        {unit * (normal - p), unit * std::sqrt(variance_p)});
    samples.tangential.push_back(
        {unit * (at[rows.n_contacts()] + q), unit * std::sqrt(variance_q)});
    const double product = std::sqrt(variance_p * variance_q);
    samples.correlation.push_back(
        product > no_force * no_force ? (all.pq / n - p * q) / product : 0.);
    samples.mixing = std::max({samples.mixing, of_p.ratio(), of_q.ratio()});
  }
  return samples;
}

/** The number of forces that vary, less that of the balances they are in. */
unsigned int dimension_of(const Rows &rows, const Vector &spread)
{
  const DiscreteProblem &problem = rows.problem();
  const unsigned int n = problem.n_unknowns();
  std::vector<bool> is_moved(problem.n_dofs(), false);
  unsigned int n_forces = 0;
  for (unsigned int e = 0; e < rows.n_joints(); ++e)
    for (unsigned int r = 0; r < rows.n_rows(); ++r)
    {
      if (spread[e * rows.n_rows() + r] == 0.)
        continue;
      ++n_forces;
      const ContactRow row = problem.row(e, r);
      for (const unsigned int body :
           {problem.joints()[e].cell_minus, problem.joints()[e].cell_plus})
        for (unsigned int i = 0; i < n && !problem.is_held(body); ++i)
          if (i == 2 || std::abs(row.direction[i]) > no_force)
            is_moved[problem.dof(body, i)] = true;
    }
  const unsigned int n_balances =
      std::count(is_moved.begin(), is_moved.end(), true);
  return std::max(n_forces, n_balances + 1) - n_balances;
}
} // namespace

void check_can_be_sampled(const Scene &scene)
{
  if (scene.has_normal_limits())
    throw InputError("'Ranges/Samples' draws states of interfaces that neither "
                     "bear tension nor crush, and 'Contact' gives them "
                     "strengths; set 'Ranges/Samples = 0', or leave these "
                     "out.");
}

StateSamples draw_samples(const Scene &scene,
                          const SamplesWanted &wanted,
                          Terminal &terminal)
{
  check_can_be_sampled(scene);
  const Rows rows(scene);
  const Extremes extremes(scene, rows, wanted.seed);
  const unsigned int dimension = dimension_of(rows, extremes.spread);
  const unsigned int n_steps = wanted.n_steps > 0 ? wanted.n_steps : dimension;

  std::vector<std::unique_ptr<Chain>> chains;
  for (unsigned int c = 0; c < n_chains; ++c)
    chains.push_back(std::make_unique<Chain>(rows, extremes,
                                             n_chains * (wanted.seed + 1) + c));
  std::mutex mutex;
  std::size_t n_done = 0;
  const auto walk = [&](const unsigned int c) {
    const unsigned int n = (wanted.n + c) / n_chains;
    const unsigned int n_first = std::ceil(share_left_out * n);
    for (unsigned int k = 0; k < n_first + n; ++k)
    {
      chains[c]->go(n_steps);
      if (k < n_first)
        continue;
      chains[c]->count();
      const std::lock_guard<std::mutex> lock(mutex);
      terminal.progress(++n_done, wanted.n, "samples");
    }
  };
  dealii::parallel::apply_to_subranges(
      0U, n_chains,
      [&](const unsigned int begin, const unsigned int end) {
        for (unsigned int c = begin; c < end; ++c)
          walk(c);
      },
      1);

  Solution last;
  StateSamples samples =
      moments_of(chains, rows, extremes.centre,
                 rows.problem().stress_scale() * rows.problem().length_scale());
  samples.n_steps = n_steps;
  samples.dimension = dimension;
  for (const auto &chain : chains)
  {
    last.forces = chain->state();
    samples.error_of_states = std::max(
        samples.error_of_states,
        certify(scene, dimensional_forces(rows.problem(), last)).error());
  }
  return samples;
}
} // namespace Voussoir
