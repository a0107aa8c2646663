// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/summary/packing_summary.h>
#include <voussoir/python/arrays.h>
#include <voussoir/python/space_scene.h>

#include <utility>

namespace Voussoir
{
namespace py = pybind11;

PySpaceResults::PySpaceResults(SpaceResult found, PySolvedWith with)
    : PyResults(std::move(with))
{
  ForcePoints points(found.answer);
  findings =
      std::make_shared<Findings>(Findings{std::move(found), std::move(points)});
}

void PySpaceResults::write(const std::filesystem::path &results)
{
  const py::gil_scoped_release others_may_go_on;
  PyWritingRun<SpaceRun> writing(solved_with,
                                 {"Output directory=" + results.string()});
  writing.run.write(solved_with.directory, findings->result);
}

std::string PySpaceResults::page()
{
  const py::gil_scoped_release others_may_go_on;
  std::ostringstream out;
  PyWritingRun<SpaceRun>(solved_with).run.write_page(out, findings->result);
  return out.str();
}

nlohmann::ordered_json PySpaceResults::json() const
{
  return summary_of(findings->result.answer, findings->result.defects);
}

PySpaceScene::PySpaceScene(const PySources &sources,
                           const py::sequence &polyhedra)
    : PyScene(sources), run(terminal), packings(1)
{
  std::vector<std::string> assignments = {dimension_entry + "=3"};
  if (!polyhedra.empty())
  {
    run.give(meshes_of(polyhedra));
    assignments.push_back("Packing/Generator=model");
  }
  run.read(sources.with(std::move(assignments), run.dimension()));
}

std::shared_ptr<const Packing<3>> PySpaceScene::get_packing()
{
  const auto checked = run.shared_packing(directory, packings);
  return {checked, &checked->packing};
}

PySpaceResults PySpaceScene::solve()
{
  const py::gil_scoped_release others_may_go_on;
  take_warnings(); // of a look at the packing, or an exception
  SpaceResult found = run.answer(directory, packings);
  return {std::move(found), solved_with()};
}
} // namespace Voussoir
