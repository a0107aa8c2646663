// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/ranges/range_search.h>
#include <voussoir/base/exceptions.h>

#include <deal.II/base/parallel.h>

#include <algorithm>
#include <limits>
#include <type_traits>
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
} // namespace

/** One of the parts that functions are shared out in. */
template <typename SceneOf>
struct RangeSearch<SceneOf>::Part
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

template <typename SceneOf>
RangeSearch<SceneOf>::RangeSearch(const SceneOf &scene,
                                  const std::vector<Function> &functions,
                                  const unsigned int n_kinds,
                                  const std::vector<unsigned int> &pressed,
                                  const RangeMethod method,
                                  Terminal &terminal)
    : states(scene), functions(functions), n_kinds(n_kinds), pressed(pressed),
      by_interior_point(!states.are_polyhedral() ||
                        method == RangeMethod::interior_point ||
                        (method == RangeMethod::automatic &&
                         is_quicker(states.n_cells(),
                                    2 * (functions.size() + pressed.size())))),
      terminal(terminal), found(functions.size()), found_places(pressed.size())
{}

template <typename SceneOf>
void RangeSearch<SceneOf>::count()
{
  const std::lock_guard<std::mutex> lock(mutex);
  terminal.progress(++n_done, 2 * (functions.size() + pressed.size()),
                    "ends of ranges");
}

/**
 * The kinds of functions one after the other, and all maxima before all minima,
 * so that each programme ends close to where the next one does.
 */
template <typename SceneOf>
void RangeSearch<SceneOf>::find_forces(Part &part)
{
  for (unsigned int kind = 0; kind < n_kinds; ++kind)
    for (const double sign : {1., -1.})
      find_forces(part, kind, sign);
}

/**
 * Of the functions that are left, that one comes next which has the most in one
 * of the states that were found here: its programme has one to start from.
 */
template <typename SceneOf>
void RangeSearch<SceneOf>::find_forces(Part &part,
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
    const GreatestValueOf<SceneOf> value =
        greatest(part, functions[k].times(sign));
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
template <typename SceneOf>
double RangeSearch<SceneOf>::farthest_place(Part &part,
                                            const unsigned int interface,
                                            const double sign)
{
  if constexpr (!std::is_same_v<SceneOf, Scene>)
    return 0.;
  else
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
      at = std::clamp(0.5 * (ends[1] - ends[0]) / (ends[0] + ends[1]), -0.5,
                      0.5);
    }
    return at;
  }
}

template <typename SceneOf>
void RangeSearch<SceneOf>::find_places(Part &part)
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

template <typename SceneOf>
StateProgram &RangeSearch<SceneOf>::program_of(Part &part)
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

template <typename SceneOf>
GreatestValueOf<SceneOf>
RangeSearch<SceneOf>::greatest(Part &part, const Function &function)
{
  std::optional<GreatestValueOf<SceneOf>> value;
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

template <typename SceneOf>
template <typename Find>
void RangeSearch<SceneOf>::find_parts(const Find &find)
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

template <typename SceneOf>
void RangeSearch<SceneOf>::find_all()
{
  find_parts([this](Part &part) { find_forces(part); });
  if constexpr (std::is_same_v<SceneOf, Scene>)
    if (!pressed.empty())
      find_parts([this](Part &part) { find_places(part); });
}

template <typename SceneOf>
void RangeProofs::add(const GreatestValueOf<SceneOf> &value)
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

template class RangeSearch<Scene>;
template class RangeSearch<SpaceScene>;
} // namespace Voussoir
