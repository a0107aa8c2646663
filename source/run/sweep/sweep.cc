// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/run/sweep/envelope.h>
#include <voussoir/run/sweep/sweep.h>
#include <voussoir/run/sweep/sweep_factors.h>
#include <voussoir/run/sweep/sweep_files.h>
#include <voussoir/run/sweep/sweep_runner.h>

#include <algorithm>

namespace Voussoir
{
namespace
{
/** "1.70393 with Position = -3.4". */
std::string factor_in_words(const SweepRunner &runner, const std::size_t k)
{
  const SweepRun &run = runner.runs()[k];
  return text_of_number(*factor_of(run)) + " with " +
         words_of(runner.names(), run.values);
}

/** Between which the factors of all runs are, or what all of them carry. */
std::string factors_in_words(const SweepRunner &runner,
                             const FactorExtremes &extremes)
{
  const auto words = [&](const std::size_t k) {
    return factor_in_words(runner, k);
  };
  if (extremes.has_both())
    return "the least at most " + words(*extremes.lower) +
           ", the greatest at least " + words(*extremes.upper);
  return extremes.least == extremes.greatest
             ? words(extremes.least)
             : "from " + words(extremes.least) + " to " +
                   words(extremes.greatest);
}

/** What the envelope says: of how many curves, the value, and where it is. */
std::string envelope_in_words(const SweepRunner &runner,
                              const SweepLayout &layout,
                              const FactorExtremes &extremes)
{
  const auto of = [&](const std::size_t k) {
    return factor_in_words(runner, k);
  };
  const std::string curves =
      text("of ", layout.runs.size(), " curves over ", layout.along.name, ": ");
  if (extremes.has_both())
    return curves + "nearest to zero " + of(extremes.critical(runner.runs()));
  return curves + (extremes.upper ? "least " + of(*extremes.upper)
                                  : "greatest " + of(*extremes.lower));
}

/** Say between which the load factors are, and what their envelope says. */
void show_factors(const SweepRunner &runner,
                  const FactorExtremes &extremes,
                  Terminal &terminal)
{
  terminal.summary("Load factor", factors_in_words(runner, extremes));
  const SweepLayout layout = layout_of(runner.names(), runner.runs());
  if (layout.form != SweepLayout::Form::map &&
      envelope_of(layout, runner.runs()).exists())
    terminal.summary("Envelope", envelope_in_words(runner, layout, extremes));
}

/** Refuse a sweep none of whose runs has anything that a factor multiplies. */
void check_live_loads(const SweepRunner &runner)
{
  const std::vector<SweepRun> &runs = runner.runs();
  if (std::all_of(runs.begin(), runs.end(),
                  [](const SweepRun &run) { return run.is_unloaded; }))
    throw InputError("With " + words_of(runner.names(), runs.front().values) +
                     ": " + runs.front().reason);
}
} // namespace

void sweep(const ManyRuns &wanted,
           const std::vector<SweepAxis> &axes,
           Terminal &terminal)
{
  std::vector<ChangingEntry> changing;
  for (const SweepAxis &axis : axes)
    changing.push_back(axis.of);
  terminal.begin("Sweep");
  std::vector<std::string> directories;
  if (wanted.writes_critical)
    directories.push_back(critical_directory);
  SweepRunner runner(wanted, changing, directories, terminal);
  runner.run(points_of(axes));
  check_live_loads(runner);
  terminal.stage("Sweep", counted(runner.runs().size(), "run") + ": " +
                              counts_of(runner.runs()));
  const auto extremes = extreme_factors(runner.runs());
  if (extremes)
  {
    show_factors(runner, *extremes, terminal);
    if (wanted.writes_critical)
      runner.write_results(
          {{critical_directory, extremes->critical(runner.runs())}});
  }
  runner.write();
  for (const SweepRun &run : runner.runs())
    if (!run.has_answer && !run.is_unloaded)
      throw SolverError("With " + words_of(runner.names(), run.values) + ": " +
                        run.reason);
  runner.check_results();
  if (wanted.writes_critical && !extremes)
    throw InputError("--critical: no run has a finite load factor; set "
                     "'Analysis = load factor'.");
}
} // namespace Voussoir
