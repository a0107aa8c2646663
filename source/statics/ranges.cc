// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/scene/reactions.h>
#include <voussoir/statics/all_states.h>
#include <voussoir/statics/ranges.h>

#include <deal.II/base/parallel.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>
#include <mutex>

namespace Voussoir
{
namespace
{
/**
 * The functions are shared out in so many parts, whatever the number of cores,
 * so that results do not depend on it.
 */
constexpr unsigned int n_parts = 16;
/** The functions are normal and tangential forces, or x and y, in turn. */
constexpr unsigned int n_kinds = 2;

/** A force, over that of reference, that is none. */
constexpr double no_force = 1e-10;
/** The largest number of programmes for an end of a range of places. */
constexpr unsigned int n_places = 30;

/** Ranges are looked for, function by function. */
class Search
{
public:
  /**
   * @param functions of the forces, in kinds that take turns.
   * @param pressed the interfaces whose eccentricities are looked for, too:
   *   function n_kinds k is the normal force of the k-th of them.
   */
  Search(const Scene &scene,
         const std::vector<ForceFunction> &functions,
         const std::vector<unsigned int> &pressed,
         Terminal &terminal)
      : states(scene), functions(functions), pressed(pressed),
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
  /** AllStates::reference(). */
  double reference() const { return states.reference(); }

private:
  /** Let @p find do all parts, on all threads. */
  template <typename Find>
  void find_parts(const StateProgram &first, const Find &find);
  void
  find_forces(StateProgram &program, unsigned int part, RangeProofs &proofs);
  void
  find_places(StateProgram &program, unsigned int part, RangeProofs &proofs);
  double farthest_place(StateProgram &program,
                        unsigned int interface,
                        double sign,
                        RangeProofs &proofs) const;
  void count();

  const AllStates states;
  const std::vector<ForceFunction> &functions;
  const std::vector<unsigned int> &pressed;
  Terminal &terminal;
  std::vector<Range> found, found_places;
  std::size_t n_done = 0;
  std::mutex mutex;
};

/** The first of @p n items that is in part @p part. */
unsigned int begin_of(const unsigned int part, const std::size_t n)
{
  return part * n / n_parts;
}

void Search::count()
{
  const std::lock_guard<std::mutex> lock(mutex);
  terminal.progress(++n_done, 2 * (functions.size() + pressed.size()),
                    "ends of ranges");
}

/**
 * The kinds of functions one after the other, and all maxima before all minima,
 * so that each programme ends close to where the next one does.
 */
void Search::find_forces(StateProgram &program,
                         const unsigned int part,
                         RangeProofs &of_part)
{
  const std::size_t n = functions.size();
  for (unsigned int kind = 0; kind < n_kinds; ++kind)
    for (const double sign : {1., -1.})
      for (unsigned int k = begin_of(part, n); k < begin_of(part + 1, n); ++k)
      {
        if (k % n_kinds != kind)
          continue;
        const GreatestValue value =
            states.greatest(program, functions[k].times(sign));
        (sign > 0. ? found[k].greatest : found[k].least) = sign * value.value;
        of_part.add(value);
        count();
      }
}

/**
 * The farthest place e of the resultant N from the end at -sign / 2, a fraction
 * of two linear functions, by the method of Dinkelbach (Management Science 13
 * (1967), 492): the state with the most of sign (e - at) N has the next place,
 * until no state has any. Where forces have no bound it is the other end.
 */
double Search::farthest_place(StateProgram &program,
                              const unsigned int interface,
                              const double sign,
                              RangeProofs &of_part) const
{
  double at = -0.5 * sign;
  for (unsigned int k = 0; k < n_places; ++k)
  {
    const GreatestValue couple =
        states.greatest(program, couple_about(interface, at).times(sign));
    of_part.add(couple);
    if (!couple.is_bounded())
      return 0.5 * sign;
    if (couple.value <= no_force * reference())
      break;
    const std::array<double, 2> ends = couple.forces.ends(interface);
    at = std::clamp(0.5 * (ends[1] - ends[0]) / (ends[0] + ends[1]), -0.5, 0.5);
  }
  return at;
}

void Search::find_places(StateProgram &program,
                         const unsigned int part,
                         RangeProofs &of_part)
{
  const std::size_t n = pressed.size();
  for (const double sign : {1., -1.})
    for (unsigned int k = begin_of(part, n); k < begin_of(part + 1, n); ++k)
    {
      double &place =
          sign > 0. ? found_places[k].greatest : found_places[k].least;
      place = found[n_kinds * k].least < -no_force * reference()
                  ? farthest_place(program, pressed[k], sign, of_part)
                  : std::numeric_limits<double>::quiet_NaN();
      count();
    }
}

template <typename Find>
void Search::find_parts(const StateProgram &first, const Find &find)
{
  dealii::parallel::apply_to_subranges(
      0U, n_parts,
      [&](const unsigned int begin, const unsigned int end) {
        for (unsigned int part = begin; part < end; ++part)
        {
          StateProgram program(first);
          RangeProofs of_part;
          find(program, part, of_part);
          of_part.n_iterations = program.n_iterations();
          const std::lock_guard<std::mutex> lock(mutex);
          proofs.add(of_part);
        }
      },
      1);
}

void Search::find_all()
{
  const StateProgram first = states.program();
  proofs.n_iterations = first.n_iterations();
  find_parts(first, [this](auto &program, auto part, auto &of_part) {
    find_forces(program, part, of_part);
  });
  if (!pressed.empty())
    find_parts(first, [this](auto &program, auto part, auto &of_part) {
      find_places(program, part, of_part);
    });
}

/**
 * The numbers of the interfaces that are wanted, in the order of a curve of
 * Hilbert through their midpoints: of neighbours the programmes end in vertices
 * that are close to each other.
 */
std::vector<unsigned int> along_curve(const Packing &packing,
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
  const std::vector<unsigned int> none;
  Search search(scene, functions, has_places ? interfaces : none, terminal);
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
  return ranges;
}
} // namespace Voussoir
