// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/output/report/report.h>
#include <voussoir/output/result_directory.h>
#include <voussoir/output/summary/text_lines.h>
#include <voussoir/run/sweep/repeated_run.h>
#include <voussoir/run/sweep/sweep.h>
#include <voussoir/run/sweep/sweep_files.h>
#include <voussoir/run/sweep/sweep_results.h>

#include <deal.II/base/multithread_info.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
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

/**
 * Do @p work for 0, ..., n - 1, as many at a time as there are cores. The first
 * number that fails ends it, with its exception.
 */
void in_threads(const std::size_t n,
                const std::function<void(std::size_t)> &work)
{
  std::atomic<std::size_t> next = 0;
  std::size_t first_failed = n;
  std::exception_ptr its_error;
  std::mutex of_error;
  const auto go_on = [&] {
    for (std::size_t k; (k = next++) < n;)
      try
      {
        work(k);
      }
      catch (...)
      {
        // All items before it have begun, so that the first does not depend
        // on which is the quickest.
        const std::lock_guard lock(of_error);
        if (k < first_failed)
        {
          first_failed = k;
          its_error = std::current_exception();
        }
        next = n;
      }
  };
  const std::size_t n_threads = std::min<std::size_t>(
      n, std::max(1U, std::thread::hardware_concurrency()));
  std::vector<std::thread> threads;
  for (std::size_t k = 1; k < n_threads; ++k)
    threads.emplace_back(go_on);
  go_on();
  for (std::thread &thread : threads)
    thread.join();
  if (its_error)
    std::rethrow_exception(its_error);
}

/** While it lives, each run uses one thread, as there are several runs. */
class OneThreadEach
{
public:
  OneThreadEach() : before(dealii::MultithreadInfo::n_threads())
  {
    dealii::MultithreadInfo::set_thread_limit(1);
  }
  ~OneThreadEach() { dealii::MultithreadInfo::set_thread_limit(before); }
  OneThreadEach(const OneThreadEach &) = delete;
  OneThreadEach &operator=(const OneThreadEach &) = delete;

private:
  const unsigned int before;
};

/** The number of different warnings that the terminal shows. */
constexpr std::size_t most_warnings = 10;

/** All runs of a sweep or a search. */
class Runner
{
public:
  Runner(const ManyRuns &wanted,
         const std::vector<ChangingEntry> &changing,
         Terminal &terminal)
      : wanted(wanted), names(names_of(changing)), terminal(terminal),
        scene(wanted.file, wanted.assignments, changing),
        files(scene.output_directory(), {{sweep_csv, sweep_html}}, terminal)
  {
    for (const std::string &result : wanted.results)
      check(result);
    files.protect(wanted.file);
    for (const std::filesystem::path &input : scene.input_files())
      files.protect(input);
  }

  /** Run all @p points. @return the number of the first of them in runs(). */
  std::size_t run(const std::vector<std::vector<std::string>> &points)
  {
    const OneThreadEach limit;
    const std::size_t first = done.size();
    done.resize(first + points.size());
    std::atomic<std::size_t> n_done = 0;
    in_threads(points.size(), [&](const std::size_t k) {
      const std::string name =
          wanted.has_directories ? text("run_", first + k + 1) : "";
      done[first + k] = run_into(name, points[k]);
      const std::lock_guard lock(of_terminal);
      if (first + k == 0)
        look_at_results(done.front());
      terminal.progress(++n_done, points.size(), "runs");
    });
    return first;
  }

  const std::vector<SweepRun> &runs() const { return done; }

  /**
   * Say between which the load factors are, and repeat the run of the least to
   * write its results, if that is wanted.
   *
   * @return false if there are no finite ones.
   */
  bool look_at_factors()
  {
    const auto extremes = extreme_factors(done);
    if (!extremes)
      return false;
    const auto &[least, greatest] = *extremes;
    const auto words = [&](const std::pair<double, std::size_t> &of) {
      return text_of_number(of.first) + " with " +
             words_of(names, done[of.second].values);
    };
    terminal.summary("Load factor",
                     least.second == greatest.second
                         ? words(least)
                         : "from " + words(least) + " to " + words(greatest));
    if (wanted.writes_critical)
      done[least.second].page =
          run_into("critical", done[least.second].values).page;
    return true;
  }

  /** Write the table of all runs and its page, and say so with the warnings. */
  void write()
  {
    const std::vector<SharedWarning> warnings = warnings_of(done);
    for (std::size_t k = 0; k < warnings.size() && k < most_warnings; ++k)
      terminal.warning(warnings[k].description(names, done));
    if (warnings.size() > most_warnings)
      terminal.warning(text("There are ", warnings.size() - most_warnings,
                            " more; '", sweep_csv, "' has all of them."));
    files.write(sweep_csv, [&](std::ostream &out) {
      write_sweep_csv(out, names, wanted.results, done);
    });
    files.write(sweep_html, [&](std::ostream &out) {
      write_sweep_html(out, scene.title(), names, wanted.results, done);
    });
    files.publish_beside();
    terminal.stage("Output",
                   text("written to ", scene.output_directory(), '/', sweep_csv,
                        "; ", sweep_html, " shows it in a browser"));
  }

  /**
   * Refuse a result that no run has, when all have ended: what one does not
   * have another may.
   */
  void check_results() const
  {
    std::set<std::string> known;
    for (const SweepRun &run : done)
      add_results(run.summary, known);
    for (const std::string &result : wanted.results)
      if (std::none_of(done.begin(), done.end(), [&](const SweepRun &run) {
            return has_result(run.summary, result);
          }))
        throw InputError(text(unknown_result(result, known),
                              " The runs themselves are in '",
                              scene.output_directory(), '/', sweep_csv, "'."));
  }

private:
  /**
   * Say which results the first run has not, but for a letter or two: long
   * before check_results() knows.
   */
  void look_at_results(const SweepRun &first)
  {
    std::set<std::string> known;
    add_results(first.summary, known);
    for (const std::string &result : wanted.results)
    {
      const std::string meant = misspelt_for(result, known);
      if (!meant.empty() && !has_result(first.summary, result))
        terminal.warning("The first run has no '" + result + "', but " + meant +
                         ".");
    }
  }

  /** Refuse what is no name of a place in a summary. */
  static void check(const std::string &result)
  {
    if (result.empty() || result.front() == '/' || result.back() == '/')
      throw InputError("--result '" + result +
                       "' is no place in summary.json; give its names with / "
                       "between them, such as ground/reaction/1.");
  }

  /** One run, whose results are in a directory beside the table, if named. */
  SweepRun run_into(const std::string &name,
                    const std::vector<std::string> &values)
  {
    namespace fs = std::filesystem;
    if (name.empty())
      return scene.run(values, "");
    const fs::path directory = fs::path(scene.output_directory()) / name;
    SweepRun run = scene.run(values, directory.string());
    if (run.has_answer && fs::exists(directory / report_html))
      run.page = name + '/' + report_html;
    return run;
  }

  const ManyRuns &wanted;
  const std::vector<std::string> names;
  Terminal &terminal;
  RepeatedRun scene;
  ResultDirectory files;
  std::vector<SweepRun> done;
  std::mutex of_terminal;
};
} // namespace

void sweep(const ManyRuns &wanted,
           const std::vector<SweepAxis> &axes,
           Terminal &terminal)
{
  std::vector<ChangingEntry> changing;
  for (const SweepAxis &axis : axes)
    changing.push_back(axis.of);
  terminal.begin("Sweep");
  Runner runner(wanted, changing, terminal);
  runner.run(points_of(axes));
  terminal.stage("Sweep", counted(runner.runs().size(), "run") + ": " +
                              counts_of(runner.runs()));
  const bool has_factors = runner.look_at_factors();
  runner.write();
  for (const SweepRun &run : runner.runs())
    if (!run.has_answer)
      throw SolverError("With " + words_of(names_of(changing), run.values) +
                        ": " + run.reason);
  runner.check_results();
  if (wanted.writes_critical && !has_factors)
    throw InputError("--critical: no run has a finite load factor; set "
                     "'Analysis = load factor'.");
}

void search(const ManyRuns &wanted,
            const SearchRange &range,
            Terminal &terminal)
{
  const std::string &name = range.of.name();
  terminal.begin("Search");
  Runner runner(wanted, {range.of}, terminal);
  const auto run = [&](const std::vector<double> &values) {
    std::vector<std::vector<std::string>> points;
    for (const double value : values)
      points.push_back({value_text(value)});
    const std::size_t first = runner.run(points);
    for (std::size_t k = first; k < runner.runs().size(); ++k)
      if (!runner.runs()[k].has_answer)
      {
        runner.write();
        throw SolverError("With " + words_of({name}, points[k - first]) + ": " +
                          runner.runs()[k].reason);
      }
    return first;
  };

  std::vector<double> values = {range.low, range.high};
  run(values);
  const Verdict at_low = runner.runs()[0].verdict;
  const Verdict at_high = runner.runs()[1].verdict;
  if (at_low == at_high || !is_certain(at_low) || !is_certain(at_high))
  {
    runner.write();
    throw InputError("--find: with " + name + " = " + value_text(range.low) +
                     " the answer is '" + word_of(runner.runs()[0]) +
                     "', with " + value_text(range.high) + " it is '" +
                     word_of(runner.runs()[1]) +
                     "'; give ends of which one is carried and the other "
                     "collapses.");
  }
  double low = range.low, high = range.high;
  bool is_open = false;
  const std::size_t n_at_once =
      std::max(1U, std::thread::hardware_concurrency());
  while (!is_open &&
         high - low > range.width * std::max(std::abs(low), std::abs(high)))
  {
    values.clear();
    for (std::size_t k = 1; k <= n_at_once; ++k)
      values.push_back(low + (high - low) * k / (n_at_once + 1));
    const std::size_t first = run(values);
    const double old_low = low, old_high = high;
    for (std::size_t k = 0; k < values.size() && high == old_high; ++k)
    {
      const Verdict verdict = runner.runs()[first + k].verdict;
      if (verdict == at_low)
        low = values[k];
      else if (verdict == at_high)
        high = values[k];
    }
    is_open = low == old_low && high == old_high;
  }
  terminal.stage("Search", counted(runner.runs().size(), "run"));
  runner.write();
  const bool low_carries = at_low == Kind::solved;
  terminal.summary("Found",
                   name + " = " + value_text(low_carries ? low : high) +
                       " is carried, " + value_text(low_carries ? high : low) +
                       " collapses" +
                       (is_open ? "; between them the answer is open" : ""));
  runner.check_results();
}
} // namespace Voussoir
