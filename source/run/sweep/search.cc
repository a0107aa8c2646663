// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/output/summary/text_lines.h>
#include <voussoir/run/sweep/search.h>
#include <voussoir/run/sweep/sweep_files.h>
#include <voussoir/run/sweep/sweep_runner.h>

#include <algorithm>
#include <cmath>
#include <thread>

namespace Voussoir
{
namespace
{
using Kind = Status::Kind;
/** A verdict; none of a packing without loads. */
using Verdict = std::optional<Kind>;

/** True if a verdict is that the load is carried, or that it collapses. */
bool is_certain(const Verdict verdict)
{
  return verdict == Kind::solved || verdict == Kind::collapse;
}

/** A search while it narrows its range. */
class Search
{
public:
  Search(const ManyRuns &wanted, const SearchRange &range, Terminal &terminal)
      : range(range), name(range.of.name()),
        runner(wanted,
               {range.of},
               {carried_directory, collapses_directory},
               terminal),
        low{range.low, 0}, high{range.high, 1}
  {}

  /** Run both ends, of which one must carry and the other collapse. */
  void begin()
  {
    run({range.low, range.high});
    const Verdict at_low = verdict(0), at_high = verdict(1);
    if (at_low != at_high && is_certain(at_low) && is_certain(at_high))
      return;
    runner.write();
    throw InputError("--find: with " + name + " = " + value_text(range.low) +
                     " the answer is '" + word_of(runner.runs()[0]) +
                     "', with " + value_text(range.high) + " it is '" +
                     word_of(runner.runs()[1]) +
                     "'; give ends of which one is carried and the other "
                     "collapses.");
  }

  /** Narrow the range to its width, or until no run between is certain. */
  void narrow()
  {
    while (!is_open && high.value - low.value >
                           range.width * std::max(std::abs(low.value),
                                                  std::abs(high.value)))
      is_open = !step();
  }

  /** Write all results, and say where the answer changes. */
  void end(Terminal &terminal)
  {
    terminal.stage("Search", counted(runner.runs().size(), "run"));
    const bool low_carries = verdict(0) == Kind::solved;
    const End &carried = low_carries ? low : high;
    const End &collapses = low_carries ? high : low;
    runner.write_results({{carried_directory, carried.run},
                          {collapses_directory, collapses.run}});
    runner.write(SearchEnds{carried.run, collapses.run, is_open});
    terminal.summary(
        "Found", name + " = " + value_text(carried.value) + " is carried, " +
                     value_text(collapses.value) + " collapses" +
                     (is_open ? "; between them the answer is open" : ""));
    runner.check_results();
  }

private:
  /** One end of the range, with the number of its run. */
  struct End
  {
    double value;
    std::size_t run;
  };

  Verdict verdict(const std::size_t k) const
  {
    return runner.runs()[k].verdict;
  }

  /** Run some values. @return the number of the first. */
  std::size_t run(const std::vector<double> &values)
  {
    std::vector<std::vector<std::string>> points;
    for (const double value : values)
      points.push_back({value_text(value)});
    const std::size_t first = runner.run(points);
    for (std::size_t k = first; k < runner.runs().size(); ++k)
    {
      const SweepRun &failed = runner.runs()[k];
      if (failed.has_answer)
        continue;
      const std::string message =
          "With " + words_of({name}, points[k - first]) + ": " + failed.reason;
      if (failed.is_unloaded)
        throw InputError(message);
      runner.write();
      throw SolverError(message);
    }
    return first;
  }

  /** Run values between both ends. @return false if none moves an end. */
  bool step()
  {
    const std::size_t n_at_once =
        std::max(1U, std::thread::hardware_concurrency());
    std::vector<double> values;
    for (std::size_t k = 1; k <= n_at_once; ++k)
      values.push_back(low.value +
                       (high.value - low.value) * k / (n_at_once + 1));
    const std::size_t first = run(values);
    const Verdict at_low = verdict(0), at_high = verdict(1);
    const double old_low = low.value, old_high = high.value;
    for (std::size_t k = 0; k < values.size() && high.value == old_high; ++k)
      if (verdict(first + k) == at_low)
        low = {values[k], first + k};
      else if (verdict(first + k) == at_high)
        high = {values[k], first + k};
    return low.value != old_low || high.value != old_high;
  }

  const SearchRange &range;
  const std::string name;
  SweepRunner runner;
  End low, high;
  bool is_open = false;
};
} // namespace

void search(const ManyRuns &wanted,
            const SearchRange &range,
            Terminal &terminal)
{
  terminal.begin("Search");
  Search search(wanted, range, terminal);
  search.begin();
  search.narrow();
  search.end(terminal);
}
} // namespace Voussoir
