// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/base/text_file.h>
#include <voussoir/output/report/report.h>
#include <voussoir/run/output_entries.h>
#include <voussoir/run/sweep/sweep_files.h>
#include <voussoir/run/sweep/sweep_results.h>
#include <voussoir/run/sweep/sweep_runner.h>

#include <deal.II/base/multithread_info.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <set>
#include <system_error>
#include <thread>

namespace Voussoir
{
namespace fs = std::filesystem;

namespace
{
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
  try
  {
    for (std::size_t k = 1; k < n_threads; ++k)
      threads.emplace_back(go_on);
  }
  catch (const std::system_error &)
  {
    // The threads that there are do all of it.
  }
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

/** Refuse what is no name of a place in a summary. */
void check_name_of(const std::string &result)
{
  if (result.empty() || result.front() == '/' || result.back() == '/')
    throw InputError("--result '" + result +
                     "' is no place in summary.json; give its names with / "
                     "between them, such as ground/reaction/1.");
}

/** Refuse to overwrite what the scene is read from. */
void protect_inputs(const ResultDirectory &files,
                    const RepeatedRun &scene,
                    const fs::path &file)
{
  files.protect(file);
  for (const fs::path &input : scene.input_files())
    files.protect(input);
}
} // namespace

SweepRunner::SweepRunner(const ManyRuns &wanted,
                         const std::vector<ChangingEntry> &changing,
                         const std::vector<std::string> &names,
                         Terminal &terminal)
    : wanted(wanted), names_of_entries(names_of(changing)), terminal(terminal),
      scene(wanted.file, wanted.assignments, changing),
      files(open(scene, wanted, names, terminal))
{
  for (const std::string &result : wanted.results)
    check_name_of(result);
  protect_inputs(files, scene, wanted.file);
  if (wanted.resumes)
    remove_left_over(scene.output_directory());
  journal.begin({fs::path(scene.output_directory()) / checkpoint_file,
                 scene.identity(), scene.checkpoint_after()},
                wanted.resumes);
}

/** The directory of the table; others must be such that can be written, too. */
ResultDirectory SweepRunner::open(const RepeatedRun &scene,
                                  const ManyRuns &wanted,
                                  const std::vector<std::string> &directories,
                                  Terminal &terminal)
{
  if (!scene.output_directory().empty())
    for (const std::string &name : directories)
      protect_inputs(
          {fs::path(scene.output_directory()) / name, files_of_all_runs()},
          scene, wanted.file);
  return {scene.output_directory(), {{sweep_csv, sweep_html}}, terminal};
}

std::size_t
SweepRunner::run(const std::vector<std::vector<std::string>> &points)
{
  const OneThreadEach limit;
  const std::size_t first = done.size();
  done.resize(first + points.size());
  std::atomic<std::size_t> n_done = 0;
  in_threads(points.size(), [&](const std::size_t k) {
    done[first + k] = kept_or_run(first + k, points[k]);
    const std::lock_guard lock(of_terminal);
    if (first + k == 0)
      look_at_results(done.front());
    terminal.progress(++n_done, points.size(), "runs");
  });
  return first;
}

void SweepRunner::write_results(
    const std::vector<std::pair<std::string, std::size_t>> &of_runs)
{
  const OneThreadEach limit;
  in_threads(of_runs.size(), [&](const std::size_t k) {
    const auto &[name, run] = of_runs[k];
    if (wanted.has_directories)
      copy_results(name_of(run), name);
    else
      run_into(name, done[run].values);
    done[run].page = page_in(name);
  });
  for (const auto &[name, run] : of_runs)
    written.push_back(name);
}

void SweepRunner::write(const std::optional<SearchEnds> ends)
{
  remove_earlier_results();
  const std::vector<SharedWarning> warnings = warnings_of(done);
  for (std::size_t k = 0; k < warnings.size() && k < most_warnings; ++k)
    terminal.warning(warnings[k].description(names(), done));
  if (warnings.size() > most_warnings)
    terminal.warning(text("There are ", warnings.size() - most_warnings,
                          " more; '", sweep_csv, "' has all of them."));
  files.write(sweep_csv, [&](std::ostream &out) {
    write_sweep_csv(out, names(), wanted.results, done);
  });
  files.write(sweep_html, [&](std::ostream &out) {
    write_sweep_html(out, {scene.title(), names(), wanted.results, done, ends});
  });
  files.publish_beside();
  journal.end();
  terminal.stage("Output",
                 text("written to ", scene.output_directory(), '/', sweep_csv,
                      "; ", sweep_html, " shows it in a browser"));
}

void SweepRunner::check_results() const
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

/**
 * Say which results the first run has not, but for a letter or two: long before
 * check_results() knows.
 */
void SweepRunner::look_at_results(const SweepRun &first)
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

/** One run, or what is kept of it. */
SweepRun SweepRunner::kept_or_run(const std::size_t number,
                                  const std::vector<std::string> &values)
{
  const std::string directory = wanted.has_directories ? name_of(number) : "";
  const std::string name = scene.key(values) + '\n' + directory;
  if (const Journal::Json before = journal.find(name); !before.is_null())
    return sweep_run_of(before);
  SweepRun run = run_into(directory, values);
  journal.keep(name, json_of(run));
  return run;
}

/** One run, whose results are in a directory beside the table, if named. */
SweepRun SweepRunner::run_into(const std::string &name,
                               const std::vector<std::string> &values)
{
  if (name.empty())
    return scene.run(values, "");
  const fs::path directory = fs::path(scene.output_directory()) / name;
  if (wanted.resumes)
    remove_left_over(directory);
  SweepRun run = scene.run(values, directory.string());
  if (run.has_answer)
    run.page = page_in(name);
  return run;
}

/** The directory of a run with all its results. */
std::string SweepRunner::name_of(const std::size_t run) const
{
  return text("run_", run + 1);
}

/** The page in a directory of results, from that of the table; or none. */
std::string SweepRunner::page_in(const std::string &name) const
{
  return fs::exists(fs::path(scene.output_directory()) / name / report_html)
             ? name + '/' + report_html
             : "";
}

/** Copy the results of a run from one directory beside the table to another. */
void SweepRunner::copy_results(const std::string &from, const std::string &to)
{
  const fs::path directory = scene.output_directory();
  const FilesOfRuns of_runs = files_of_all_runs();
  ResultDirectory copies(directory / to, of_runs);
  for (const fs::directory_entry &entry :
       fs::directory_iterator(directory / from))
  {
    const std::string name = entry.path().filename();
    const auto &results = of_runs.results;
    if (std::find(results.begin(), results.end(), name) == results.end() &&
        !of_runs.is_piece(name))
      continue;
    std::error_code error;
    fs::copy_file(entry.path(), copies.place_for(name), error);
    if (error)
      copies.refuse(error.message());
  }
  copies.publish();
}

void SweepRunner::remove_earlier_results() const
{
  const fs::path top = scene.output_directory();
  const std::string page = bytes_of_file(top / sweep_html).value_or("");
  std::error_code ignored;
  for (const std::string &name :
       {critical_directory, carried_directory, collapses_directory})
  {
    if (std::find(written.begin(), written.end(), name) != written.end() ||
        page.find("href=\"" + name + '/') == page.npos ||
        !fs::is_directory(top / name, ignored) ||
        fs::equivalent(top / name, scene.forces_from(), ignored))
      continue;
    ResultDirectory(top / name, files_of_all_runs()).publish();
    fs::remove(top / name, ignored); // unless the user has files there
  }
}
} // namespace Voussoir
