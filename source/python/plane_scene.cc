// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/summary/summary.h>
#include <voussoir/python/arrays.h>
#include <voussoir/python/plane_scene.h>
#include <voussoir/scene/proofs/reactions.h>
#include <voussoir/stress/cell_means.h>

#include <utility>
#include <variant>

namespace Voussoir
{
namespace py = pybind11;

PyPlaneResults::PyPlaneResults(RunResult found, PySolvedWith with)
    : PyResults(std::move(with)),
      findings(std::make_shared<RunResult>(std::move(found)))
{}

std::shared_ptr<const Results>
PyPlaneResults::state(const std::string &what) const
{
  const Results *const carried = std::get_if<Results>(&findings->found);
  if (carried == nullptr)
    throw py::attribute_error("the load is not carried, so that there is no '" +
                              what + "'; see 'displacement' and 'summary'");
  return {findings, carried};
}

std::shared_ptr<const MovingScene> PyPlaneResults::moving() const
{
  struct Kept
  {
    std::shared_ptr<const RunResult> findings;
    MovingScene moving;
  };
  const auto kept = std::make_shared<const Kept>(
      Kept{findings, MovingScene(*findings->scene, motion(), live_loads())});
  return {kept, &kept->moving};
}

const Motion &PyPlaneResults::motion() const
{
  const Results *const of = std::get_if<Results>(&findings->found);
  if (of == nullptr)
    return std::get<Collapse>(findings->found).motion;
  const MotionBeside *const beside = of->motion_beside();
  return beside ? beside->motion : of->motion;
}

const LiveLoads *PyPlaneResults::live_loads() const
{
  const Results *const of = std::get_if<Results>(&findings->found);
  const MotionBeside *const beside = of ? of->motion_beside() : nullptr;
  return beside && beside->live ? &*beside->live : nullptr;
}

std::shared_ptr<const CapacityCurve>
PyPlaneResults::curve(const std::string &what) const
{
  const CapacityCurve *const of = state(what)->data<CapacityCurve>();
  if (of == nullptr)
    throw py::attribute_error("there is no '" + what +
                              "': it is there with `Analysis = capacity` only");
  return {findings, of};
}

void PyPlaneResults::write(const std::filesystem::path &results)
{
  const py::gil_scoped_release others_may_go_on;
  PyWritingRun<AnalysisRun> writing(solved_with,
                                    {"Output directory=" + results.string()});
  writing.run.write(solved_with.directory, *findings);
}

std::string PyPlaneResults::page()
{
  const py::gil_scoped_release others_may_go_on;
  std::ostringstream out;
  PyWritingRun<AnalysisRun>(solved_with).run.write_page(out, *findings);
  return out.str();
}

nlohmann::ordered_json PyPlaneResults::json() const
{
  return std::visit([](const auto &found) { return summary_of(found); },
                    findings->found);
}

PyPlaneScene::PyPlaneScene(const PySources &sources,
                           const std::vector<py::array_t<double>> &polygons)
    : PyScene(sources), run(terminal), packings(1)
{
  std::vector<std::string> assignments;
  if (!polygons.empty())
  {
    run.give(list_of(polygons));
    assignments.push_back("Packing/Generator=polygons");
  }
  run.read(sources.with(std::move(assignments), run.dimension()));
}

std::shared_ptr<const Packing<2>> PyPlaneScene::get_packing()
{
  return run.shared_packing(directory, packings);
}

PyPlaneResults PyPlaneScene::solve()
{
  const py::gil_scoped_release others_may_go_on;
  take_warnings(); // of a look at the packing, or an exception
  RunResult found = run.answer(directory, packings);
  if (auto *const results = std::get_if<Results>(&found.found))
  {
    results->torques = residual_torques(*found.scene, results->forces);
    results->mean_stresses = cell_mean_stresses(*found.scene, results->forces);
  }
  return {std::move(found), solved_with()};
}
} // namespace Voussoir
