// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_run_h
#define voussoir_run_run_h

#include <voussoir/base/parameters/assigned_entries.h>
#include <voussoir/base/parameters/print_parameters.h>
#include <voussoir/terminal/terminal.h>

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace Voussoir
{
/** The places that the parameters of a run are written in, in their order. */
struct ParameterSources
{
  /** A file; see ParameterInput. */
  std::optional<std::filesystem::path> file;
  /** Lines as in a .prm file. */
  std::string text = {};
  /** Assignments as in --set. */
  std::vector<std::string> assignments = {};
};

/**
 * The entry `Dimension` as the sources have it, 2 or 3; 2 if it is not there,
 * or is neither, which reading them refuses.
 *
 * @throws InputError as ParameterInput does.
 */
unsigned int dimension_of(const ParameterSources &sources);

/** One run, from the parameters to the files. */
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
   * @throws InputError as ParameterInput and assign() do, or if `Dimension` is
   *   that of another kind of run.
   */
  void read(const ParameterSources &sources);
  /**
   * Carry out one more assignment "Section/Name=value".
   *
   * @throws InputError as assign_parameter() does.
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

  /** The value of `Dimension` that this is for. */
  virtual unsigned int dimension() const { return 2; }
  /** What the terminal is to show; 0 to 2. */
  virtual unsigned int verbosity() const = 0;
  /**
   * Show what was understood; nothing is solved, and nothing written.
   *
   * @param directory that of the file of parameters, where paths begin.
   * @throws InputError.
   */
  virtual void validate(const std::filesystem::path &directory) const = 0;
  /**
   * Do what the parameters ask for, and write the results.
   *
   * @param directory that of the file of parameters, where paths begin.
   * @return if the load is not carried by what, and which files show it; else
   *   nothing.
   * @throws InputError, SolverError.
   */
  virtual std::string carry_out(const std::filesystem::path &directory) = 0;

protected:
  /** @param terminal sees what the run notices. */
  explicit Run(Terminal &terminal) : terminal(terminal) {}
  /** Declare all parameters but `Dimension`, with load cases by their names. */
  virtual void declare(const std::set<std::string> &load_cases) = 0;
  /** Warn of settings that have no effect. */
  void warn_of_unused() const;

  /** The terminal of the run. */
  Terminal &terminal;
  /** All parameters. */
  dealii::ParameterHandler prm;

private:
  AssignedEntries assigned;
};
} // namespace Voussoir

#endif
