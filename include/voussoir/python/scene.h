// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_python_scene_h
#define voussoir_python_scene_h

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

  /** The scene. */
  const Scene &scene() const { return *findings->scene; }
  /** The state that carries the loads; null after a collapse. */
  const Results *carried() const
  {
    return std::get_if<Results>(&findings->found);
  }
  /**
   * The carried state, which @p what needs.
   *
   * @throws pybind11::attribute_error if there is none.
   */
  const Results &state(const std::string &what) const;
  /** The displacements, or the mechanism. */
  const Motion &motion() const;
  /** summary.json, without what belongs to the files. */
  pybind11::object summary() const;
  /** "solved", "carried to within" or "collapse". */
  std::string status() const { return findings->status().word(); }

  std::shared_ptr<RunResult> findings; /**< kept by the arrays */
  std::vector<std::string> warnings;   /**< what the program would print */
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
  const Packing &get_packing();
  /** Find what the parameters ask for. */
  PyResults solve();

private:
  std::ostringstream output;
  Terminal terminal;
  AnalysisRun run;
  std::filesystem::path directory = ".";
  SharedPackings packings;
  /** The one that was asked for last. */
  std::shared_ptr<const Packing> packing;
};
} // namespace Voussoir

#endif
