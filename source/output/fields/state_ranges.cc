// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/ranges/ranges.h>
#include <voussoir/analyses/samples/state_samples.h>
#include <voussoir/output/fields/state_ranges.h>

#include <limits>

namespace Voussoir
{
namespace
{
using RangesOf = std::vector<Range> Ranges::*;

/** In tables, no value of interfaces whose ranges are not asked for. */
constexpr double not_asked_for = std::numeric_limits<double>::quiet_NaN();

/** In grids, a mark of them. */
constexpr double not_wanted = -1.;

/** The ranges, where they were asked for. */
const Ranges &ranges_of(const Results &r)
{
  return *r.data<Ranges>();
}

/** The value in this state of what @p of is the range of. */
double force_of(const Results &r, const RangesOf of, const unsigned int e)
{
  return of == &Ranges::normal ? 0. - r.forces.normal[e]
         : of == &Ranges::tangential
             ? r.forces.tangential[e]
             : r.forces.eccentricity(r.scene.packing.interfaces()[e], e);
}

/** One end of a range; those of -f_e^n are the other way round. */
Field<Results> end_of_range(const std::string &name,
                            const std::string &unit,
                            const std::string &words,
                            const RangesOf of,
                            double Range::*const end)
{
  const auto value = [of, end](const Results &r, const unsigned int e) {
    const Ranges &ranges = ranges_of(r);
    const double bound = (ranges.*of)[e].*end;
    return !ranges.wanted[e]       ? not_asked_for
           : of == &Ranges::normal ? 0. - bound
                                   : bound;
  };
  const auto force = [of](const Results &r, const unsigned int e) {
    return force_of(r, of, e);
  };
  return Field<Results>(name, unit, words, value)
      .instead_in_grid(force, "where there is no bound, or none is asked for, "
                              "the value of this state");
}

/** A mark of ranges. @param is of interface e. */
Field<Results> mark_of_range(const std::string &name,
                             const std::string &words,
                             bool (Ranges::*const is)(unsigned int) const)
{
  const auto mark = [is](const Results &r, const unsigned int e) {
    const Ranges &ranges = ranges_of(r);
    return ranges.wanted[e] ? double((ranges.*is)(e)) : not_asked_for;
  };
  return Field<Results>(name, "", words, mark)
      .as_integer()
      .instead_in_grid([](const Results &, unsigned int) { return not_wanted; },
                       "-1 where none is asked for");
}

/** A moment of the samples of a force. @param value of it, as a Field's. */
template <typename Value>
Field<Results>
moment(const std::string &name, const std::string &words, const Value &value)
{
  return Field<Results>(name, "S L", words, value)
      .saying_in_grid("left out where they have not settled");
}

/** Moments that lie in memory as they are. */
auto stored(std::vector<Moments> StateSamples::*const of,
            double Moments::*const moment)
{
  return [of, moment](const Results &r) {
    return Stored(r.data<StateSamples>()->*of, moment);
  };
}
} // namespace

Fields<Results> state_ranges()
{
  const std::string
      of_p = "the least and the greatest pressure -f_e^n over [all admissible "
             "states](theory.md#ranges-of-forces), inf without bound; empty "
             "where not asked for",
      of_q = "the same of f_e^t",
      of_e = "the least and the greatest eccentricity over the states that "
             "press the interface; empty where none does";
  const auto asked = [](const Results &r) {
    return r.data<Ranges>() != nullptr && ranges_of(r).has_interfaces();
  };
  return together<Results>(
      {when<Results>(
           {"with `Ranges` of interfaces", asked},
           {end_of_range("p_min", "S L", of_p, &Ranges::normal,
                         &Range::greatest),
            end_of_range("p_max", "S L", of_p, &Ranges::normal, &Range::least),
            end_of_range("q_min", "S L", of_q, &Ranges::tangential,
                         &Range::least),
            end_of_range("q_max", "S L", of_q, &Ranges::tangential,
                         &Range::greatest),
            mark_of_range("determined",
                          "1 where both ranges vanish, so that all states have "
                          "these forces",
                          &Ranges::is_determined),
            mark_of_range("unbounded", "1 where some of the four has no bound",
                          &Ranges::is_unbounded)
                .only_in_grid()}),
       when<Results>({"with `Ranges` of interfaces and `Rotations = true`",
                      [asked](const Results &r) {
                        return asked(r) && !ranges_of(r).eccentricity.empty();
                      }},
                     {end_of_range("e_min", "", of_e, &Ranges::eccentricity,
                                   &Range::least),
                      end_of_range("e_max", "", of_e, &Ranges::eccentricity,
                                   &Range::greatest)})});
}

Fields<Results> sample_moments()
{
  const std::string of_q = "the same three of f_e^t";
  return when<Results>(
      {"with `Ranges/Samples`",
       [](const Results &r) { return r.data<StateSamples>() != nullptr; },
       [](const Results &r) -> std::string {
         const auto *const samples = r.data<StateSamples>();
         return !samples ? "there are no samples; set 'Ranges/Samples'"
                : samples->have_settled()
                    ? ""
                    : "the samples have not settled; see 'warnings'";
       }},
      {moment("p_mean",
              "the mean of -f_e^n over the "
              "[samples](theory.md#samples-of-all-states); this and the "
              "following are empty where they have not settled",
              [](const Results &r, const unsigned int e) {
                return 0. - r.data<StateSamples>()->normal[e].mean;
              }),
       moment("p_mean_error", "the standard error of the mean",
              stored(&StateSamples::normal, &Moments::error)),
       moment("p_deviation",
              "the standard deviation of the force among the states, which "
              "does not become smaller with more samples",
              stored(&StateSamples::normal, &Moments::deviation)),
       moment("q_mean", of_q,
              stored(&StateSamples::tangential, &Moments::mean)),
       moment("q_mean_error", of_q,
              stored(&StateSamples::tangential, &Moments::error)),
       moment("q_deviation", of_q,
              stored(&StateSamples::tangential, &Moments::deviation)),
       Field<Results>(
           "correlation", "",
           "the coefficient of correlation of -f_e^n and f_e^t; 0 where one of "
           "them has no spread",
           [](const Results &r) {
             return Stored(r.data<StateSamples>()->correlation);
           })
           .only_in_table()});
}
} // namespace Voussoir
