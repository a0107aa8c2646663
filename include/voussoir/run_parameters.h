// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_parameters_h
#define voussoir_run_parameters_h

#include <voussoir/base/assigned_entries.h>
#include <voussoir/base/print_parameters.h>
#include <voussoir/parallel/team.h>
#include <voussoir/result_writer.h>
#include <voussoir/study.h>
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
 * All parameters of a run, with the Study and the ResultWriter that they are
 * bound to: a Simulation has one, a RepeatedRun one for each run, and a scene
 * of Python's.
 */
class RunParameters
{
public:
  /**
   * @param terminal sees what the run notices.
   * @param team the processes that help, beside this one, its root.
   */
  explicit RunParameters(Terminal &terminal, const Team &team = Team());

  /**
   * Declare all parameters, with the load cases that the sources name, and read
   * them; to be called once.
   *
   * @throws InputError as ParameterInput and assign() do.
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
  /** The key of SceneParameters::packing_key(). */
  std::string packing_key() const
  {
    return SceneParameters::packing_key(tree());
  }
  /** Sentences on what is assigned without effect; see unused_settings(). */
  std::vector<std::string> unused() const;

  /** The processes. */
  const Team team;
  /** The wall clock times of the stages. */
  dealii::TimerOutput timer;
  /** The scene and the question about it. */
  Study study;
  /** What is done with the answer. */
  ResultWriter writer;

private:
  dealii::ParameterHandler prm;
  AssignedEntries assigned;
};
} // namespace Voussoir

#endif
