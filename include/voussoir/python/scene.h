// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_python_scene_h
#define voussoir_python_scene_h

#include <voussoir/run/run.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <pybind11/pytypes.h>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
/** What a scene was solved with, so that its results can be written later. */
struct PySolvedWith
{
  WrittenParameters parameters;      /**< of the run */
  std::filesystem::path directory;   /**< where paths begin */
  std::vector<std::string> warnings; /**< what the program would print */
};

/** A run with the parameters of results, which it writes. */
template <typename RunOfResults>
struct PyWritingRun
{
  /** @param assignments that are made besides. */
  explicit PyWritingRun(const PySolvedWith &with,
                        const std::vector<std::string> &assignments = {})
      : terminal(output), run(terminal)
  {
    WrittenParameters parameters = with.parameters;
    for (const std::string &assignment : assignments)
      parameters.assignments.push_back(assignment);
    run.read_written(std::move(parameters));
    for (const std::string &warning : with.warnings)
      terminal.warning(warning);
  }

  std::ostringstream output; /**< what nobody sees */
  Terminal terminal;         /**< of the run */
  RunOfResults run;          /**< which has solved nothing */
};

/** What was found, as far as that is the same in the plane and in space. */
class PyResults
{
public:
  virtual ~PyResults() = default;
  /**
   * Write all files of a run into @p results.
   *
   * @throws InputError if that cannot be.
   */
  virtual void write(const std::filesystem::path &results) = 0;
  /** The page, with all that it needs. */
  virtual std::string page() = 0;
  /**
   * Write the page alone.
   *
   * @throws InputError if @p file cannot be written.
   */
  void write_page(const std::filesystem::path &file);
  /** The page in a frame, or of many blocks the verdict in a line. */
  std::string view_in_notebook();
  /** summary.json, without what belongs to the files. */
  pybind11::object summary() const;
  /** The status in that, such as "solved". */
  virtual std::string status() const { return json().at("status"); }

  /** What the program would print. */
  const std::vector<std::string> &warnings() const
  {
    return solved_with.warnings;
  }

protected:
  /** Of a scene that was solved @p with something. */
  explicit PyResults(PySolvedWith with) : solved_with(std::move(with)) {}
  /** The summary. */
  virtual nlohmann::ordered_json json() const = 0;
  /** The number of blocks. */
  virtual std::size_t n_blocks() const = 0;

  const PySolvedWith solved_with; /**< so that files can be written */
};

/** What a scene is made from, beside its blocks. */
struct PySources
{
  std::optional<std::filesystem::path> file; /**< of parameters, if any */
  std::string text;                          /**< lines of a .prm file */
  pybind11::dict settings; /**< by their names, as in "Friction/Strength" */

  /**
   * As a run of that dimension reads them, behind the @p assignments that the
   * blocks need.
   */
  ParameterSources with(std::vector<std::string> assignments,
                        unsigned int dimension) const;
  /** As with(), without the settings but `Dimension`. */
  ParameterSources before_dimension(std::vector<std::string> assignments) const;
};

/** A scene, as far as it is the same in the plane and in space. */
class PyScene
{
public:
  virtual ~PyScene() = default;
  /** @{ */
  /** Not copied: a run has a reference to the terminal. */
  PyScene(const PyScene &) = delete;
  PyScene &operator=(const PyScene &) = delete;
  /** @} */

  /** Change an entry. */
  void set(const std::string &name, const pybind11::handle &value);
  /**
   * The text of an entry.
   *
   * @throws pybind11::key_error if there is none of that name.
   */
  std::string get(const std::string &name) const;

protected:
  /** One whose relative paths begin where the file of @p sources is. */
  explicit PyScene(const PySources &sources);
  /** The warnings on what was done since the last call. */
  std::vector<std::string> take_warnings();
  /** What results are found with, with the warnings of take_warnings(). */
  PySolvedWith solved_with();
  /** @{ */
  /** The run that has the parameters. */
  virtual Run &parameters() = 0;
  virtual const Run &parameters() const = 0;
  /** @} */

private:
  std::ostringstream output;

protected:
  Terminal terminal;               /**< of the run */
  std::filesystem::path directory; /**< where paths begin */
};
} // namespace Voussoir

#endif
