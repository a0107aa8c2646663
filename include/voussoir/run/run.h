// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_run_h
#define voussoir_run_run_h

#include <voussoir/analyses/state/status.h>
#include <voussoir/base/journal.h>
#include <voussoir/base/parameters/assigned_entries.h>
#include <voussoir/base/parameters/named_sections.h>
#include <voussoir/base/parameters/parameter_input.h>
#include <voussoir/base/parameters/print_parameters.h>
#include <voussoir/run/output_entries.h>
#include <voussoir/run/shared_packings.h>
#include <voussoir/run/variables.h>
#include <voussoir/terminal/terminal.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/** The name of the entry that says what kind of run it is. */
inline const std::string dimension_entry = "Dimension";

/** The places that the parameters of a run are written in, in their order. */
struct ParameterSources
{
  /** A file; see ParameterInput. */
  std::optional<std::filesystem::path> file;
  /** Lines as in a .prm file. */
  std::string text = {};
  /** Assignments as in --set. */
  std::vector<std::string> assignments = {};

  /** The file and the text, as they are written. */
  std::vector<ParameterInput> inputs() const;
};

/** What parameters were written as, in the order in which they are read. */
struct WrittenParameters
{
  /** The file, as the user named it; empty if there are others than it. */
  std::string file;
  std::vector<ParameterInput> inputs;   /**< files and texts */
  std::vector<std::string> assignments; /**< as in --set */
};

/** What a run ends with that has found an answer. */
struct RunOutcome
{
  /** What it says of the loads; none if nothing but a packing was made. */
  std::optional<Status> status;
  /** What summary.json has, without what belongs to the output. */
  nlohmann::ordered_json summary;
  /**
   * If the load is not carried and the files are written: by what, and which of
   * them show it. Empty otherwise.
   */
  std::string message;
  /** What the page of the run says of the loads, in a sentence or some. */
  std::string verdict;
};

/**
 * One run, from the parameters to the files, in the plane or in space: see
 * make_run().
 */
class Run
{
public:
  virtual ~Run() = default;
  /** @{ */
  /** Not copied: parameters are bound to members. */
  Run(const Run &) = delete;
  Run &operator=(const Run &) = delete;
  /** @} */

  /**
   * Declare all parameters, with the load cases that the sources name, and read
   * them; to be called once.
   *
   * @throws InputError as ParameterInput and assign() do; that of make_run() is
   *   of the right kind.
   */
  void read(const ParameterSources &sources);
  /** The same of what another run has read(), and assign() has changed since.
   */
  void read_written(WrittenParameters parameters);
  /** What has been read, with what assign() has changed since. */
  const WrittenParameters &as_written() const { return written; }
  /**
   * Carry out one more assignment "Section/Name=value"; of a variable, all are
   * carried out again.
   *
   * @throws InputError as Voussoir::assign() and Variables do, or if it changes
   * `Dimension` to that of another kind of run.
   */
  void assign(const std::string &assignment);

  /** The entries with their values. */
  const dealii::ParameterHandler &entries() const { return prm; }
  /** They as tree_of() gives them. */
  const nlohmann::ordered_json &tree() const { return assigned.tree(); }
  /**
   * Print the entries in a section, such as "Packing/wall", or all if it is
   * empty: a listing, or the values alone of those that somebody has set.
   *
   * @throws InputError if there is no such section.
   */
  void print(std::ostream &out,
             const std::string &section,
             ParameterFormat format,
             Detail detail);

  /** Let carry_out() go on from where a run that was interrupted had come. */
  void resume() { resumes = true; }

  /** The value of `Dimension` that this is for. */
  virtual unsigned int dimension() const = 0;
  /** What the terminal is to show; 0 to 2. */
  virtual unsigned int verbosity() const = 0;
  /**
   * Files that the scene is read from.
   *
   * @param directory that of the file of parameters, where paths begin.
   */
  virtual std::vector<std::filesystem::path>
  input_files(const std::filesystem::path &directory) const = 0;
  /** Files of an earlier run that forces are read from. */
  virtual std::vector<std::filesystem::path> files_of_forces() const
  {
    return {};
  }
  /**
   * Show what was understood; nothing is solved, and nothing written.
   *
   * @param directory that of the file of parameters, where paths begin.
   * @throws InputError.
   */
  virtual void validate(const std::filesystem::path &directory) const = 0;
  /**
   * Do what the parameters ask for.
   *
   * @param directory that of the file of parameters, where paths begin.
   * @param writes whether the results are written, with the parameters beside
   *   them.
   * @param packings that are shared with other runs, if there are any.
   * @throws InputError, SolverError.
   */
  virtual RunOutcome carry_out(const std::filesystem::path &directory,
                               bool writes,
                               PackingsOfRuns *packings = nullptr) = 0;

  /**
   * What provenance_of() says of the results.
   *
   * @param directory that of the file of parameters, where paths begin.
   * @param results where they are written.
   */
  nlohmann::ordered_json provenance(const std::filesystem::path &directory,
                                    const std::filesystem::path &results) const;

protected:
  /** @param terminal sees what the run notices. */
  explicit Run(Terminal &terminal);
  /** Declare all parameters but `Dimension`, with sections of users. */
  virtual void declare(const NamedSections &names) = 0;
  /**
   * Look at what the results are made of, before it is read, and begin to keep
   * what is found on the way, or go on from what was kept.
   *
   * @param directory that of the file of parameters, where paths begin.
   * @param output where results go.
   * @throws InputError as Journal::begin().
   */
  void begin_journal(const std::filesystem::path &directory,
                     const OutputEntries &output);
  /** Show the variables, and warn of settings that have no effect. */
  void show_settings() const;

  /** Blocks are given, which no file and no entry has. */
  void take_given_blocks() { has_given_blocks = true; }

  /** The terminal of the run. */
  Terminal &terminal;
  /** All parameters. */
  dealii::ParameterHandler prm;
  /** The wall clock times of the stages. */
  dealii::TimerOutput timer;
  /** What is found on the way to results that are written. */
  Journal journal;
  /** The provenance() of the results, when what they are made of was read. */
  nlohmann::ordered_json made_of;

private:
  template <typename F>
  void for_each_variable(const F &f) const;
  void declare_variables();
  void assign_all();
  void carry_out(const std::string &assignment);
  /** @throws InputError if `Dimension` is not dimension(), as it is then. */
  void check_dimension();

  AssignedEntries assigned;
  WrittenParameters written;
  Variables variables;
  bool resumes = false, has_given_blocks = false;
  /** True if values may stand in the places of variables already. */
  bool has_listing = false;
};
} // namespace Voussoir

#endif
