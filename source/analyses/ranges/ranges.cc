// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/ranges/feasible_set.h>
#include <voussoir/analyses/ranges/ranges.h>

#include <deal.II/base/parallel.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>

namespace Voussoir
{
namespace
{
/**
 * The functions are shared out in parts, whatever the number of cores, so that
 * results do not depend on it: the fewest, and one for so many functions. Each
 * part has to find its own states to start from (measured, 1,000 random cells:
 * 16 parts take a tenth more steps than 4), but no more cores than parts work.
 */
constexpr unsigned int fewest_parts = 4, n_functions_of_part = 1400;
/** The functions are normal and tangential forces, or x and y, in turn. */
constexpr unsigned int n_kinds = 2;

/** A force, over that of reference, that is none. */
constexpr double no_force_in_range = 1e-10;
/** The largest number of programmes for an end of a range of places. */
constexpr unsigned int n_places = 30;
/**
 * Of so many cells, so few ends take longer by the simplex method, which has to
 * find a first state, than by an interior point.
 */
constexpr unsigned int large_packing = 3000, few_ends = 40;

/** True if each of @p n_ends is found sooner by an interior point. */
bool is_quicker(const unsigned int n_cells, const std::size_t n_ends)
{
  return n_cells >= large_packing && n_ends <= few_ends;
}

/** One of the parts that functions are shared out in. */
struct Part
{
  /** Its number, and how many there are. */
  unsigned int number, n_parts;
  /** @{ */
  /** The first of @p n items that are in it, and the first behind them. */
  unsigned int begin(const std::size_t n) const { return number * n / n_parts; }
  unsigned int end(const std::size_t n) const
  {
    return (number + 1) * n / n_parts;
  }
  /** @} */
  /** What finds its ends, if the simplex method does. */
  std::optional<StateProgram> program;
  /** Their errors. */
  RangeProofs proofs;
};

/** Ranges are looked for, function by function. */
class RangeSearch
{
public:
  /**
   * @param functions of the forces, in kinds that take turns.
   * @param pressed the interfaces whose eccentricities are looked for, too:
   *   function n_kinds k is the normal force of the k-th of them.
   */
  RangeSearch(const Scene &scene,
              const std::vector<ForceFunction> &functions,
              const std::vector<unsigned int> &pressed,
              const RangeMethod method,
              Terminal &terminal)
      : states(scene), functions(functions), pressed(pressed),
        by_interior_point(
            !states.are_polyhedral() || method == RangeMethod::interior_point ||
            (method == RangeMethod::automatic &&
             is_quicker(scene.packing.n_cells(),
                        2 * (functions.size() + pressed.size())))),
        terminal(terminal), found(functions.size()),
        found_places(pressed.size())
  {}

  /** Find all. */
  void find_all();
  /** @{ */
  /** A range for each function, and the places of the resultants. */
  const std::vector<Range> &ranges() const { return found; }
  const std::vector<Range> &places() const { return found_places; }
  /** @} */
  /** The errors of all so far. */
  RangeProofs proofs;
  /** FeasibleSet::reference(). */
  double reference() const { return states.reference(); }

private:
  /** Let @p find do all parts, on all threads. */
  template <typename Find>
  void find_parts(const Find &find);
  void find_forces(Part &part);
  void find_forces(Part &part, unsigned int kind, double sign);
  void find_places(Part &part);
  double farthest_place(Part &part, unsigned int interface, double sign);
  StateProgram &program_of(Part &part);
  GreatestValue greatest(Part &part, const ForceFunction &function);
  void count();

  const FeasibleSet states;
  const std::vector<ForceFunction> &functions;
  const std::vector<unsigned int> &pressed;
  const bool by_interior_point;
  /** What the programmes of all parts start from, if there are any. */
  std::optional<StateProgram> first;
  Terminal &terminal;
  std::vector<Range> found, found_places;
  std::size_t n_done = 0;
  std::mutex mutex;
};

void RangeSearch::count()
{
  const std::lock_guard<std::mutex> lock(mutex);
  terminal.progress(++n_done, 2 * (functions.size() + pressed.size()),
                    "ends of ranges");
}

/**
 * The kinds of functions one after the other, and all maxima before all minima,
 * so that each programme ends close to where the next one does.
 */
void RangeSearch::find_forces(Part &part)
{
  for (unsigned int kind = 0; kind < n_kinds; ++kind)
    for (const double sign : {1., -1.})
      find_forces(part, kind, sign);
}

/**
 * Of the functions that are left, that one comes next which has the most in one
 * of the states that were found here: its programme has one to start from.
 */
void RangeSearch::find_forces(Part &part,
                              const unsigned int kind,
                              const double sign)
{
  const std::size_t n = functions.size();
  std::vector<unsigned int> left;
  for (unsigned int k = part.begin(n); k < part.end(n); ++k)
    if (k % n_kinds == kind)
      left.push_back(k);
  std::vector<double> most(left.size(),
                           -std::numeric_limits<double>::infinity());
  while (!left.empty())
  {
    const auto of_next = std::max_element(most.begin(), most.end());
    const auto next = left.begin() + (of_next - most.begin());
    const unsigned int k = *next;
    most.erase(of_next);
    left.erase(next);
    const GreatestValue value = greatest(part, functions[k].times(sign));
    (sign > 0. ? found[k].greatest : found[k].least) = sign * value.value;
    count();
    if (value.is_bounded())
      for (std::size_t i = 0; i < left.size(); ++i)
        most[i] = std::max(most[i], sign * functions[left[i]](value.forces));
  }
}

/**
 * The farthest place e of the resultant N from the end at -sign / 2, a fraction
 * of two linear functions, by the method of Dinkelbach (Management Science 13
 * (1967), 492): the state with the most of sign (e - at) N has the next place,
 * until no state has any. Where forces have no bound it is the other end.
 */
double RangeSearch::farthest_place(Part &part,
                                   const unsigned int interface,
                                   const double sign)
{
  double at = -0.5 * sign;
  for (unsigned int k = 0; k < n_places; ++k)
  {
    const GreatestValue couple =
        greatest(part, couple_about(interface, at).times(sign));
    if (!couple.is_bounded())
      return 0.5 * sign;
    if (couple.value <= no_force_in_range * reference())
      break;
    const std::array<double, 2> ends = couple.forces.ends(interface);
    at = std::clamp(0.5 * (ends[1] - ends[0]) / (ends[0] + ends[1]), -0.5, 0.5);
  }
  return at;
}

void RangeSearch::find_places(Part &part)
{
  const std::size_t n = pressed.size();
  for (const double sign : {1., -1.})
    for (unsigned int k = part.begin(n); k < part.end(n); ++k)
    {
      double &place =
          sign > 0. ? found_places[k].greatest : found_places[k].least;
      place = found[n_kinds * k].least < -no_force_in_range * reference()
                  ? farthest_place(part, pressed[k], sign)
                  : std::numeric_limits<double>::quiet_NaN();
      count();
    }
}

StateProgram &RangeSearch::program_of(Part &part)
{
  if (part.program)
    return *part.program;
  const std::lock_guard<std::mutex> lock(mutex);
  if (!first)
  {
    first.emplace(states.program());
    proofs.n_iterations += first->n_iterations();
  }
  return part.program.emplace(*first);
}

GreatestValue RangeSearch::greatest(Part &part, const ForceFunction &function)
{
  std::optional<GreatestValue> value;
  if (by_interior_point)
    value = states.greatest(function, Terminal::silent());
  if (!value && !states.are_polyhedral())
    throw SolverError("The greatest value of a force is not proven: the load "
                      "may be close to what the packing can carry. Set "
                      "'Ranges/Where = 0' and 'Analysis = state' to have the "
                      "state alone.");
  if (!value)
    value = states.greatest(program_of(part), function);
  part.proofs.add(*value);
  return *value;
}

template <typename Find>
void RangeSearch::find_parts(const Find &find)
{
  const unsigned int n_parts = std::max<unsigned int>(
      fewest_parts, functions.size() / n_functions_of_part);
  dealii::parallel::apply_to_subranges(
      0U, n_parts,
      [&](const unsigned int begin, const unsigned int end) {
        for (unsigned int number = begin; number < end; ++number)
        {
          Part part{number, n_parts, {}, {}};
          find(part);
          if (part.program)
            part.proofs.n_iterations = part.program->n_iterations();
          const std::lock_guard<std::mutex> lock(mutex);
          proofs.add(part.proofs);
        }
      },
      1);
}

void RangeSearch::find_all()
{
  find_parts([this](Part &part) { find_forces(part); });
  if (!pressed.empty())
    find_parts([this](Part &part) { find_places(part); });
}

/**
 * The numbers of the interfaces that are wanted, in the order of a curve of
 * Hilbert through their midpoints: of neighbours the programmes end in vertices
 * that are close to each other.
 */
std::vector<unsigned int> along_curve(const Packing<2> &packing,
                                      const std::vector<bool> &wanted)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<std::pair<Kernel::Point_2, unsigned int>> places;
  for (unsigned int e = 0; e < wanted.size(); ++e)
    if (wanted[e])
    {
      const dealii::Point<2> x = packing.interfaces()[e].midpoint();
      places.push_back({{x[0], x[1]}, e});
    }
  using Map = CGAL::First_of_pair_property_map<decltype(places)::value_type>;
  CGAL::hilbert_sort(places.begin(), places.end(),
                     CGAL::Spatial_sort_traits_adapter_2<Kernel, Map>());
  std::vector<unsigned int> numbers;
  for (const auto &place : places)
    numbers.push_back(place.second);
  return numbers;
}
} // namespace

void RangeProofs::add(const GreatestValue &value)
{
  ++n_programmes;
  width = std::max(width, value.width());
  error_of_states = std::max(error_of_states, value.error_of_state);
  closing_violation =
      std::max(closing_violation, value.bound.closing_violation);
}

void RangeProofs::add(const RangeProofs &others)
{
  n_programmes += others.n_programmes;
  n_iterations += others.n_iterations;
  width = std::max(width, others.width);
  error_of_states = std::max(error_of_states, others.error_of_states);
  closing_violation = std::max(closing_violation, others.closing_violation);
}

Ranges
find_ranges(const Scene &scene, const RangesWanted &wanted, Terminal &terminal)
{
  const std::vector<unsigned int> interfaces =
      along_curve(scene.packing, wanted.interfaces);
  std::vector<ForceFunction> functions;
  for (const unsigned int e : interfaces)
  {
    functions.push_back(normal_force(e));
    functions.push_back(tangential_force(e));
  }
  std::vector<StraightRun> supports;
  if (wanted.reactions)
    supports = straight_supports(scene.packing);
  for (const StraightRun &support : supports)
    for (unsigned int i = 0; i < 2; ++i)
    {
      dealii::Tensor<1, 2> direction;
      direction[i] = 1.;
      functions.push_back(reaction(scene.packing, support, direction));
    }

  const bool has_places =
      scene.turns() && scene.tensile_strength.empty() && !interfaces.empty();
  const std::vector<unsigned int> no_interfaces;
  RangeSearch search(scene, functions, has_places ? interfaces : no_interfaces,
                     wanted.method, terminal);
  search.find_all();
  const std::size_t n = wanted.interfaces.size();
  Ranges ranges;
  ranges.proofs = search.proofs;
  ranges.reference = search.reference();
  ranges.wanted = wanted.interfaces;
  ranges.normal.resize(n);
  ranges.tangential.resize(n);
  if (has_places)
    ranges.eccentricity.resize(n);
  auto next = search.ranges().begin();
  for (std::size_t k = 0; k < interfaces.size(); ++k)
  {
    const unsigned int e = interfaces[k];
    ranges.normal[e] = *next++;
    ranges.tangential[e] = *next++;
    if (has_places)
      ranges.eccentricity[e] = search.places()[k];
  }
  for (unsigned int s = 0; s < supports.size(); ++s, next += 2)
    ranges.reactions.push_back({{next[0], next[1]}});
  ranges.supports = std::move(supports);
  return ranges;
}
} // namespace Voussoir
