// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_python_scene_h
#define voussoir_python_scene_h

#include <voussoir/output/fields/moving_scene.h>
#include <voussoir/run/analysis_run.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <pybind11/numpy.h>
#include <sstream>
#include <string>
#include <vector>

namespace Voussoir
{
/** What was found, with the packing and the scene that it belongs to. */
class PyResults
{
public:
  /** @param warnings what the program would print. */
  PyResults(RunResult found, std::vector<std::string> warnings);

  /** The packing of the scene; the pointer keeps all that was found. */
  std::shared_ptr<const Packing<2>> packing() const
  {
    return {findings, &findings->scene->packing};
  }
  /**
   * The state that carries the loads, which @p what needs; the pointer keeps
   * it.
   *
   * @throws pybind11::attribute_error if there is none.
   */
  std::shared_ptr<const Results> state(const std::string &what) const;
  /** The scene with its displacements, or the mechanism, kept likewise. */
  std::shared_ptr<const MovingScene> moving() const;
  /** summary.json, without what belongs to the files. */
  pybind11::object summary() const;
  /** "solved", "carried to within" or "collapse". */
  std::string status() const { return findings->status().word(); }

  std::vector<std::string> warnings; /**< what the program would print */

private:
  const Motion &motion() const;

  std::shared_ptr<RunResult> findings;
};

/** A scene with its parameters, of which the packing is kept. */
class PyScene
{
public:
  /**
   * @param given a file of parameters, if there is one.
   * @param text lines as in a .prm file, or empty.
   * @param polygons the corners of each block, arrays of shape (n, 2).
   * @param settings by their names, as in "Friction/Strength".
   */
  PyScene(const std::optional<std::filesystem::path> &given,
          const std::string &text,
          const std::vector<pybind11::array_t<double>> &polygons,
          const pybind11::dict &settings);

  /** Change an entry. */
  void set(const std::string &name, const pybind11::handle &value);
  /**
   * The text of an entry.
   *
   * @throws pybind11::key_error if there is none of that name.
   */
  std::string get(const std::string &name) const;
  /** The packing, made anew if what it is made from has changed. */
  std::shared_ptr<const Packing<2>> get_packing();
  /** Find what the parameters ask for. */
  PyResults solve();

private:
  std::ostringstream output;
  Terminal terminal;
  AnalysisRun run;
  std::filesystem::path directory = ".";
  SharedPackings packings;
};
} // namespace Voussoir

#endif
