// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_python_scene_h
#define voussoir_python_scene_h

#include <voussoir/run/run.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <pybind11/pytypes.h>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
/** What was found, as far as that is the same in the plane and in space. */
class PyResults
{
public:
  virtual ~PyResults() = default;
  /** summary.json, without what belongs to the files. */
  pybind11::object summary() const;
  /** The status in that, such as "solved". */
  virtual std::string status() const { return json().at("status"); }

  std::vector<std::string> warnings; /**< what the program would print */

protected:
  /** @param warnings what the program would print. */
  explicit PyResults(std::vector<std::string> warnings)
      : warnings(std::move(warnings))
  {}
  /** The summary. */
  virtual nlohmann::ordered_json json() const = 0;
};

/** What a scene is made from, beside its blocks. */
struct PySources
{
  std::optional<std::filesystem::path> file; /**< of parameters, if any */
  std::string text;                          /**< lines of a .prm file */
  pybind11::dict settings; /**< by their names, as in "Friction/Strength" */

  /** As a run reads them, behind the @p assignments that the blocks need. */
  ParameterSources with(std::vector<std::string> assignments) const;
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
