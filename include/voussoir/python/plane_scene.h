// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_python_plane_scene_h
#define voussoir_python_plane_scene_h

#include <voussoir/output/fields/moving_scene.h>
#include <voussoir/python/scene.h>
#include <voussoir/run/analysis_run.h>

#include <memory>
#include <pybind11/numpy.h>
#include <string>
#include <vector>

namespace Voussoir
{
/** What was found in the plane, with the scene that it belongs to. */
class PyPlaneResults : public PyResults
{
public:
  /** @param warnings what the program would print. */
  PyPlaneResults(RunResult found, std::vector<std::string> warnings);

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
  std::string status() const override { return findings->status().word(); }

protected:
  nlohmann::ordered_json json() const override;

private:
  const Motion &motion() const;

  std::shared_ptr<RunResult> findings;
};

/** A scene in the plane, of which the packing is kept. */
class PyPlaneScene : public PyScene
{
public:
  /** @param polygons the corners of each block, arrays of shape (n, 2). */
  PyPlaneScene(const PySources &sources,
               const std::vector<pybind11::array_t<double>> &polygons);

  /** The packing, made anew if what it is made from has changed. */
  std::shared_ptr<const Packing<2>> get_packing();
  /** Find what the parameters ask for. */
  PyPlaneResults solve();

protected:
  Run &parameters() override { return run; }
  const Run &parameters() const override { return run; }

private:
  AnalysisRun run;
  SharedPackings<Packing<2>> packings;
};
} // namespace Voussoir

#endif
