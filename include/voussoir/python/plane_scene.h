// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_python_plane_scene_h
#define voussoir_python_plane_scene_h

#include <voussoir/analyses/capacity/capacity_curve.h>
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
  /** @param with see PyResults. */
  PyPlaneResults(RunResult found, PySolvedWith with);

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
  /** The scene, kept likewise. */
  std::shared_ptr<const Scene> scene() const
  {
    return {findings, findings->scene.get()};
  }
  /**
   * The capacity curve, of which @p what is a quantity; kept likewise.
   *
   * @throws pybind11::attribute_error if there is none.
   */
  std::shared_ptr<const CapacityCurve> curve(const std::string &what) const;
  std::string status() const override { return findings->status().word(); }
  void write(const std::filesystem::path &results) override;
  std::string page() override;

protected:
  nlohmann::ordered_json json() const override;
  std::size_t n_blocks() const override { return packing()->n_cells(); }

private:
  const Motion &motion() const;
  /** Those of which the motion bounds the factor, or null. */
  const LiveLoads *live_loads() const;

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
