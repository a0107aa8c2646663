// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_packing_run_h
#define voussoir_run_packing_run_h

#include <voussoir/analyses/space_analysis.h>
#include <voussoir/run/output_entries.h>
#include <voussoir/run/run.h>
#include <voussoir/scene/space/space_scene_parameters.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace Voussoir
{
/**
 * A run in space: the packing is made or read, checked and supported, what is
 * asked of it under its loads is answered, and both are written.
 */
class PackingRun : public Run
{
public:
  /** @param terminal sees what the run notices. */
  explicit PackingRun(Terminal &terminal) : Run(terminal) {}

  unsigned int dimension() const override { return 3; }
  unsigned int verbosity() const override { return output.verbosity; }
  void validate(const std::filesystem::path &directory) const override;
  std::string carry_out(const std::filesystem::path &directory) override;

protected:
  void declare(const std::set<std::string> &load_cases) override;

private:
  /** The file in which the packing is written, too. */
  enum class PackingFile
  {
    none,
    off,
    obj,
    compas
  };

  /** A packing with its supports, and what is wrong with its blocks. */
  struct CheckedPacking
  {
    Packing<3> packing;
    std::vector<CellDefect> defects;
  };

  /** Make the packing, check it, and show what was understood. */
  CheckedPacking read_packing(const std::filesystem::path &directory) const;
  void write(ResultDirectory &files,
             const SpaceAnswer &answer,
             const std::vector<CellDefect> &defects) const;
  void write_packing(ResultDirectory &files, const SpaceAnswer &answer) const;

  OutputEntries output;
  SpaceSceneParameters of_scene;
  SpaceAnalysis analysis;
  PackingFile packing_file = PackingFile::none;
  bool reports = true;
};
} // namespace Voussoir

#endif
