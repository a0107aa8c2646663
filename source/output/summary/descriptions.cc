// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/summary/descriptions.h>
#include <voussoir/scene/proofs/displacement_jumps.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
/** A jump, over the largest displacement of a support, that is one. */
constexpr double least_jump = 1e-6;

/** What the factors that were tried say of each other. */
std::string description_without_dilatancy(const LoadFactor &factor)
{
  const auto smaller = [&](const double tried) {
    return std::abs(tried) < std::abs(factor.carried);
  };
  const FactorTrials &trials = factor.trials;
  const unsigned int n_with = std::count_if(trials.with_state.begin(),
                                            trials.with_state.end(), smaller);
  const unsigned int n_without = std::count_if(
      trials.without_state.begin(), trials.without_state.end(), smaller);
  std::string words =
      text(text_to_copy(factor.carried), " has a state without dilatancy, ");
  if (n_without > 0)
    words += text(
        "but of ", n_with + n_without, " smaller factors tried ", n_without,
        n_without > 1 ? " have none, the least of them " : " has none, ",
        text_to_copy(trials.without_state.front()));
  else if (n_with > 0)
    words += n_with > 1
                 ? text("and so have the ", n_with, " smaller factors tried")
                 : "and so has the one smaller factor tried";
  else
    words += "the only factor tried that has one";
  words += "; of others nothing is known, since no theorem holds";
  return std::isfinite(factor.bound)
             ? text(words, "; ", text_to_copy(factor.bound),
                    " collapses, with it or without, which is proven")
             : words + "; no mechanism was found that bounds it";
}
} // namespace

CountOfRanges::CountOfRanges(const Ranges &ranges)
{
  for (unsigned int e = 0; e < ranges.wanted.size(); ++e)
  {
    wanted += ranges.wanted[e];
    determined += ranges.is_determined(e);
    unbounded += ranges.is_unbounded(e);
  }
}

CountOfJumps::CountOfJumps(const Scene &scene, const Settlement &settlement)
{
  const InterfaceJumps jumps = jumps_of(scene.packing, settlement.motion);
  const double least = least_jump * settlement.largest_displacement;
  for (unsigned int e = 0; e < jumps.sliding.size(); ++e)
  {
    const bool at_start = jumps.openings[e][0] > least;
    const bool at_end = jumps.openings[e][1] > least;
    open += at_start && at_end;
    hinges += at_start != at_end;
    sliding += std::abs(jumps.sliding[e]) > least;
  }
}

std::string description_of(const LoadFactor &factor)
{
  if (!factor.trials.empty())
    return description_without_dilatancy(factor);
  const std::string carried = text_to_copy(factor.carried);
  std::string words;
  if (factor.is_unbounded)
    words = carried + " is carried, and so is any beyond it: the live loads "
                      "balance by pressure alone";
  else if (!std::isfinite(factor.bound))
    words = carried + " is carried; no mechanism was found that bounds it";
  else
    words = text(carried, " is carried, ", text_to_copy(factor.bound),
                 " collapses; they differ by ", factor.width(), " of it");
  if (factor.collapses_without)
    words += "; the dead loads are not carried without the live ones";
  return words;
}

std::string description_of(const Scene &scene, const Settlement &settlement)
{
  const CountOfJumps count(scene, settlement);
  std::string words =
      text("supports move by at most ", settlement.largest_displacement,
           "; interfaces with a hinge: ", count.hinges, ", open: ", count.open,
           ", sliding: ", count.sliding);
  return words;
}

std::string description_of(const Ranges &ranges)
{
  const CountOfRanges count(ranges);
  std::string words = text("forces of ", counted(count.wanted, "interface"),
                           ": ", count.determined, " determined by statics");
  if (count.unbounded > 0)
    words += text(", ", count.unbounded, " without bound");
  if (!ranges.reactions.empty())
    words += text("; reactions of ",
                  counted(ranges.reactions.size(), "straight support"));
  return words;
}

std::string description_of(const StateSamples &samples)
{
  if (samples.dimension == 0)
    return "all states have the same forces";
  const std::string of = text(samples.n, " of all states, a set of ",
                              counted(samples.dimension, "dimension"), ", ",
                              counted(samples.n_steps, "step"), " apart");
  if (!samples.have_settled())
    return of + "; they have not settled, and give no mean";
  return text(of, ", worth at least ", std::floor(samples.effective),
              " independent ones; standard error of a mean at most ",
              samples.largest_error);
}

std::string description_of_law(const Scene &scene)
{
  return scene.dilates
             ? "Coulomb, associated: joints that slide open, too"
             : "Coulomb, without dilatancy: this state carries the loads, but "
               "no theorem says that the blocks stay in it";
}
} // namespace Voussoir
