// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/ranges/range_search.h>
#include <voussoir/base/chunks.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>

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

/**
 * The ends after which a programme is renewed, and may be kept: what it does
 * next depends on no more than what is kept, with a journal and without.
 */
constexpr unsigned int n_between_renewals = 64;

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

Journal::Json json_of(const RangeProofs &proofs)
{
  return {proofs.n_programmes, proofs.n_iterations, proofs.width,
          proofs.error_of_states, proofs.closing_violation};
}

RangeProofs range_proofs_of(const Journal::Json &json)
{
  RangeProofs proofs;
  proofs.n_programmes = json.at(0);
  proofs.n_iterations = json.at(1);
  proofs.width = json.at(2);
  proofs.error_of_states = json.at(3);
  proofs.closing_violation = json.at(4);
  return proofs;
}
} // namespace

/** One of the parts that functions, or places, are shared out in. */
template <typename SceneOf>
struct RangeSearch<SceneOf>::Part
{
  /** @param n the number of items of all parts. */
  Part(const std::string &name,
       const unsigned int number,
       const unsigned int n_parts,
       const std::size_t n)
      : name(text(name, ", part ", number + 1, " of ", n_parts)),
        begin(number * n / n_parts), end((number + 1) * n / n_parts)
  {}

  /** In a journal. */
  const std::string name;
  /** The first of the items that are in it, and the first behind them. */
  const unsigned int begin, end;
  /** True if items are places, and else they are functions. */
  bool finds_places = false;
  /** What finds its ends, if the simplex method does. */
  std::optional<StateProgram> program = {};
  /** Their errors. */
  RangeProofs proofs = {};

  /** @{ */
  /** Where it is: the number of the pass, whether that has begun, what is left
   * in it, and the most that the state of another has of each. */
  unsigned int pass = 0;
  bool has_begun = false;
  std::vector<unsigned int> left = {};
  std::vector<double> most = {};
  /** @} */
  /** How many were found since the programme was renewed, and in all. */
  unsigned int n_since_renewal = 0, n_done = 0;
};

template <typename SceneOf>
RangeSearch<SceneOf>::RangeSearch(const SceneOf &scene,
                                  const std::vector<Function> &functions,
                                  const unsigned int n_kinds,
                                  const std::vector<unsigned int> &pressed,
                                  const RangeMethod method,
                                  Journal *const journal,
                                  Terminal &terminal)
    : states(scene), functions(functions), n_kinds(n_kinds), pressed(pressed),
      by_interior_point(!states.are_polyhedral() ||
                        method == RangeMethod::interior_point ||
                        (method == RangeMethod::automatic &&
                         is_quicker(states.n_cells(),
                                    2 * (functions.size() + pressed.size())))),
      journal(journal), terminal(terminal), found(functions.size()),
      found_places(pressed.size())
{}

template <typename SceneOf>
void RangeSearch<SceneOf>::count(const unsigned int n)
{
  const std::lock_guard<std::mutex> lock(mutex);
  n_done += n;
  terminal.progress(n_done, 2 * (functions.size() + pressed.size()),
                    "ends of ranges");
}

/** The range that is looked for of an item of a part. */
template <typename SceneOf>
Range &RangeSearch<SceneOf>::range_of(const Part &part, const std::size_t k)
{
  return part.finds_places ? found_places[k] : found[k];
}

/** One more end is found; of programmes, what follows begins anew every few. */
template <typename SceneOf>
void RangeSearch<SceneOf>::end_item(Part &part)
{
  ++part.n_done;
  count(1);
  if (part.program)
  {
    if (++part.n_since_renewal < n_between_renewals)
      return;
    part.n_since_renewal = 0;
    part.program->renew(*first);
  }
  if (journal != nullptr && journal->is_due())
    keep(part);
}

template <typename SceneOf>
void RangeSearch<SceneOf>::keep(const Part &part)
{
  std::vector<double> ends;
  for (unsigned int k = part.begin; k < part.end; ++k)
  {
    const Range &range = range_of(part, k);
    ends.insert(ends.end(), {range.least, range.greatest});
  }
  journal->keep(part.name,
                {{"pass", part.pass},
                 {"has_begun", part.has_begun},
                 {"left", part.left},
                 {"most", packed(part.most)},
                 {"done", part.n_done},
                 {"ends", packed(ends)},
                 {"proofs", json_of(part.proofs)},
                 {"program", part.program ? part.program->where_it_is()
                                          : Journal::Json()}});
}

/** Go on from where a part was when it was kept. */
template <typename SceneOf>
void RangeSearch<SceneOf>::go_on(Part &part)
{
  const Journal::Json from =
      journal != nullptr ? journal->find(part.name) : Journal::Json();
  if (from.is_null())
    return;
  part.pass = from.at("pass");
  part.has_begun = from.at("has_begun");
  part.left = from.at("left").get<std::vector<unsigned int>>();
  part.most = unpacked(from.at("most"));
  part.n_done = from.at("done");
  part.proofs = range_proofs_of(from.at("proofs"));
  const std::vector<double> ends = unpacked(from.at("ends"));
  for (unsigned int k = part.begin; k < part.end; ++k)
    range_of(part, k) = {ends[2 * (k - part.begin)],
                         ends[2 * (k - part.begin) + 1]};
  if (const Journal::Json &program = from.at("program"); !program.is_null())
    program_of(part).go_on(program, *first);
  count(part.n_done);
}

/**
 * The kinds of functions one after the other, and all maxima before all minima,
 * so that each programme ends close to where the next one does.
 */
template <typename SceneOf>
void RangeSearch<SceneOf>::find_forces(Part &part)
{
  for (; part.pass < 2 * n_kinds; ++part.pass)
  {
    if (!part.has_begun)
    {
      for (unsigned int k = part.begin; k < part.end; ++k)
        if (k % n_kinds == part.pass / 2)
          part.left.push_back(k);
      part.most.assign(part.left.size(),
                       -std::numeric_limits<double>::infinity());
      part.has_begun = true;
    }
    while (!part.left.empty())
      find_next_force(part, part.pass % 2 == 0 ? 1. : -1.);
    part.has_begun = false;
  }
}

/**
 * Of the functions that are left, that one comes next which has the most in one
 * of the states that were found here: its programme has one to start from.
 */
template <typename SceneOf>
void RangeSearch<SceneOf>::find_next_force(Part &part, const double sign)
{
  const auto of_next = std::max_element(part.most.begin(), part.most.end());
  const auto next = part.left.begin() + (of_next - part.most.begin());
  const unsigned int k = *next;
  part.most.erase(of_next);
  part.left.erase(next);
  const GreatestValueOf<SceneOf> value =
      greatest(part, functions[k].times(sign));
  (sign > 0. ? found[k].greatest : found[k].least) = sign * value.value;
  if (value.is_bounded())
    for (std::size_t i = 0; i < part.left.size(); ++i)
      part.most[i] =
          std::max(part.most[i], sign * functions[part.left[i]](value.forces));
  end_item(part);
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
  for (; part.pass < 2; ++part.pass)
  {
    if (!part.has_begun)
    {
      for (unsigned int k = part.end; k > part.begin; --k)
        part.left.push_back(k - 1);
      part.has_begun = true;
    }
    while (!part.left.empty())
    {
      const unsigned int k = part.left.back();
      part.left.pop_back();
      const double sign = part.pass == 0 ? 1. : -1.;
      (sign > 0. ? found_places[k].greatest : found_places[k].least) =
          found[n_kinds * k].least < -no_force_in_range * reference()
              ? farthest_place(part, pressed[k], sign)
              : std::numeric_limits<double>::quiet_NaN();
      end_item(part);
    }
    part.has_begun = false;
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
void RangeSearch<SceneOf>::find_parts(const std::string &name,
                                      const bool finds_places,
                                      const Find &find)
{
  const unsigned int n_parts = std::max<unsigned int>(
      fewest_parts, functions.size() / n_functions_of_part);
  for_chunks(n_parts, 1,
             [&](const std::size_t number, std::size_t, std::size_t) {
               Part part(name, number, n_parts,
                         finds_places ? pressed.size() : functions.size());
               part.finds_places = finds_places;
               go_on(part);
               find(part);
               if (part.program)
               {
                 part.program->forget_vertices();
                 part.proofs.n_iterations = part.program->n_iterations();
               }
               if (journal != nullptr)
                 keep(part);
               const std::lock_guard<std::mutex> lock(mutex);
               proofs.add(part.proofs);
             });
}

template <typename SceneOf>
void RangeSearch<SceneOf>::find_all()
{
  find_parts("ranges of forces", false,
             [this](Part &part) { find_forces(part); });
  if constexpr (std::is_same_v<SceneOf, Scene>)
    if (!pressed.empty())
      find_parts("ranges of places", true,
                 [this](Part &part) { find_places(part); });
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
