// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_python_space_scene_h
#define voussoir_python_space_scene_h

#include <voussoir/output/fields/force_points.h>
#include <voussoir/python/scene.h>
#include <voussoir/run/space_run.h>

#include <memory>
#include <pybind11/pytypes.h>
#include <string>
#include <vector>

namespace Voussoir
{
/** What was found of blocks in space, with the scene that it belongs to. */
class PySpaceResults : public PyResults
{
public:
  /** @param with see PyResults. */
  PySpaceResults(SpaceResult found, PySolvedWith with);

  /** @{ */
  /** Parts of what was found; the pointers keep all of it. */
  std::shared_ptr<const SpaceResults> answer() const
  {
    return {findings, &findings->result.answer};
  }
  std::shared_ptr<const Packing<3>> packing() const
  {
    return {findings, &findings->result.answer.scene.packing()};
  }
  std::shared_ptr<const ForcePoints> points() const
  {
    return {findings, &findings->points};
  }
  /** @} */
  void write(const std::filesystem::path &results) override;
  std::string page() override;

protected:
  nlohmann::ordered_json json() const override;
  std::size_t n_blocks() const override { return packing()->n_cells(); }

private:
  struct Findings
  {
    SpaceResult result;
    ForcePoints points;
  };

  std::shared_ptr<Findings> findings;
};

/** A scene in space, of which the packing is kept. */
class PySpaceScene : public PyScene
{
public:
  /** @param polyhedra see meshes_of(). */
  PySpaceScene(const PySources &sources, const pybind11::sequence &polyhedra);

  /** The packing, made anew if what it is made from has changed. */
  std::shared_ptr<const Packing<3>> get_packing();
  /** Find what the parameters ask for. */
  PySpaceResults solve();

protected:
  Run &parameters() override { return run; }
  const Run &parameters() const override { return run; }

private:
  SpaceRun run;
  SharedPackings<CheckedPacking> packings;
};
} // namespace Voussoir

#endif
