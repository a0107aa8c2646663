// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/sample_analysis.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>

#include <deal.II/base/patterns.h>

#include <cmath>
#include <utility>

namespace Voussoir
{
namespace
{
constexpr unsigned int least_number_of_samples = 100;

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

std::string sentence_of(const StateSamples &samples)
{
  if (samples.dimension == 0)
    return "All states that carry the loads have the same forces.";
  if (!samples.have_settled())
    return "The states that were drawn have not settled, and give no mean.";
  return text("The states that were drawn are worth at least ",
              std::floor(samples.effective),
              " independent ones of all that carry the loads.");
}

nlohmann::ordered_json summary_of(const StateSamples &samples)
{
  nlohmann::ordered_json json = {{"settled", samples.have_settled()},
                                 {"number", samples.n},
                                 {"steps", samples.n_steps},
                                 {"effective_number", samples.effective},
                                 {"mixing", samples.mixing},
                                 {"dimension", samples.dimension},
                                 {"error_of_states", samples.error_of_states}};
  if (samples.have_settled())
    json["largest_error"] = samples.largest_error;
  return json;
}

std::string not_settled(const StateSamples &samples)
{
  return text(
      "The samples have not settled, and give no mean: with ",
      counted(samples.n_steps, "step"), " from one to the next ", samples.n,
      " of them are worth ", std::floor(samples.effective),
      " independent ones for the worst force, and must be worth ",
      StateSamples::least_effective,
      "; the spread of a force in all chains together is ", samples.mixing,
      " times that within each, and must be at most ",
      StateSamples::largest_mixing,
      ". Set 'Ranges/Steps between samples' to more than ", samples.n_steps,
      samples.is_given ? ", or to 0, which finds how many it takes." : ".");
}
} // namespace

void SampleAnalysis::add_parameters(dealii::ParameterHandler &prm)
{
  prm.enter_subsection("Ranges");
  prm.add_parameter(
      "Samples", of_samples.n,
      "States are drawn from all admissible ones, with equal probability for "
      "equal volumes of the set of forces, to have the mean and the spread of "
      "each force: so many that the mean of each is worth that of this number "
      "of independent states. 0: none; else at least 100, of which at least "
      "400 are made.",
      dealii::Patterns::Integer(0));
  prm.add_parameter(
      "Steps between samples", of_samples.n_steps,
      "The number of steps of the random walk from one sample to the next; the "
      "more, the less they depend on each other. 0: as many as it takes, by "
      "what the samples themselves tell, up to 256. Else as many samples are "
      "drawn as 'Samples' says, whatever they are worth.",
      dealii::Patterns::Integer(0));
  prm.add_parameter("Seed", of_samples.seed,
                    "Of the random numbers: equal seeds give equal samples.",
                    dealii::Patterns::Integer(0));
  prm.leave_subsection();
}

std::optional<SamplesWanted> SampleAnalysis::wanted() const
{
  if (of_samples.n == 0)
    return {};
  if (of_samples.n < least_number_of_samples)
    throw InputError(text("'Ranges/Samples' = '", of_samples.n,
                          "' must be 0 or at least ", least_number_of_samples,
                          ": fewer tell no spread."));
  return of_samples;
}

void SampleAnalysis::check(const Scene &scene) const
{
  if (wanted())
    check_can_be_sampled(scene);
}

void SampleAnalysis::answer(AnalysisOutcome &outcome,
                            const AnalysisContext &context) const
{
  const std::optional<SamplesWanted> of = wanted();
  if (!of)
    return;
  const dealii::TimerOutput::Scope section(context.timer, name());
  context.terminal.begin("Samples");
  StateSamples drawn = draw_samples(*outcome.scene, *of, context.terminal);
  context.terminal.stage("Samples", text(counted(drawn.n, "state"), ", ",
                                         counted(drawn.n_steps, "step"),
                                         " from one to the next"));
  AnalysisResult result = {name(), "Samples", description_of(drawn),
                           summary_of(drawn)};
  result.sentence = sentence_of(drawn);
  if (!drawn.have_settled())
    result.doubts = {not_settled(drawn)};
  result.data = std::move(drawn);
  outcome.results.push_back(std::move(result));
}
} // namespace Voussoir
