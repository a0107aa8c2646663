// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_analysis_h
#define voussoir_analyses_analysis_h

#include <voussoir/analyses/state/answer.h>
#include <voussoir/analyses/state/solver_parameters.h>
#include <voussoir/scene/loads/live_loads.h>
#include <voussoir/scene/scene_parameters.h>
#include <voussoir/terminal/terminal.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <nlohmann/json.hpp>

#include <any>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/** A motion that an analysis has found beside forces. */
struct MotionBeside
{
  /** The motion; L, or of any size. */
  Motion motion;
  /** Its name, as in "Mechanism". */
  std::string title;
  /** False if only its direction says something. */
  bool has_size = false;
  /** The loads of which it bounds the factor; none of others. */
  std::optional<LiveLoads> live = {};
};

/** What an analysis says beside forces: all that is shown and written of it. */
struct AnalysisResult
{
  /** "load_factor": the name of its part of summary.json. */
  std::string key;
  /** "Load factor": the name in front of the line for people. */
  std::string title;
  /** That line. */
  std::string description;
  /** Its part of summary.json. */
  nlohmann::ordered_json summary;
  /** True if it answers `Analysis` itself, and stands above all else. */
  bool is_verdict = false;
  /**
   * The answer as one sentence with few digits; empty: the description. "{L}"
   * stands behind a length, and "{F}" behind a force, for the unit.
   */
  std::string sentence = {};
  /** Sentences on what is doubtful about it. */
  std::vector<std::string> doubts = {};
  /** Its motion, if it has one. */
  std::optional<MotionBeside> motion = {};
  /** The object, such as Ranges, that quantities of interfaces are of. */
  std::any data = {};
};

/** What an analysis ends with. */
struct AnalysisOutcome
{
  /** The scene, which the others refer to. */
  std::unique_ptr<const Scene> scene;
  /** How the forces, or the mechanism, were found. */
  SolverRecord record = {};
  /** Forces that carry the loads, or a mechanism. */
  Answer answer = {};
  /** What is said beside forces. */
  std::vector<AnalysisResult> results = {};
};

/** All that an analysis has beside a scene. */
struct AnalysisContext
{
  /** The parameters that the scene is made from. */
  const SceneParameters &parameters;
  /** The formulations, and the controls of all solvers. */
  const SolverParameters &solver;
  /** The times of the stages. */
  dealii::TimerOutput &timer;
  /** What sees the stages. */
  Terminal &terminal;
  /** Shows the loads of a scene. */
  std::function<void(const Scene &)> show_loads;
  /** Reads forces and how they were found; null if they are to be found. */
  std::function<Carried(const Scene &, SolverRecord &)> read_forces;
};

/** One of the values of the entry `Analysis`: what is asked of a scene. */
class Analysis
{
public:
  virtual ~Analysis() = default;
  /** Its name in a .prm file. */
  virtual std::string name() const = 0;
  /** Its documentation, behind its name and a colon. */
  virtual std::string meaning() const = 0;
  /** The sections that it alone looks at, separated by commas. */
  virtual std::string sections() const = 0;
  /** Declare the sections that it has brought with it, and bind them. */
  virtual void add_parameters(dealii::ParameterHandler & /*prm*/) {}
  /** True if it looks at `Live loads`. */
  virtual bool has_live_loads() const { return false; }
  /** True if it can take its forces from an earlier run. */
  virtual bool takes_forces() const { return false; }
  /**
   * Find what it would refuse of a scene before anything is solved.
   *
   * @throws InputError.
   */
  virtual void check(const Scene & /*scene*/) const {}
  /**
   * Answer it.
   *
   * @throws InputError, SolverError.
   */
  virtual AnalysisOutcome answer(SceneData data,
                                 const AnalysisContext &context) const = 0;
};

/**
 * What else may be asked of the states of a scene, once one is known that
 * carries its loads.
 */
class FurtherAnalysis
{
public:
  virtual ~FurtherAnalysis() = default;
  /** Its name, as that of its part of summary.json and of its time. */
  virtual std::string name() const = 0;
  /** The section that it looks at, if it has brought one with it. */
  virtual std::string section() const { return {}; }
  /** Declare its entries, and bind them. */
  virtual void add_parameters(dealii::ParameterHandler & /*prm*/) {}
  /** @copydoc Analysis::check() */
  virtual void check(const Scene & /*scene*/) const {}
  /**
   * Answer it if it is asked.
   *
   * @param outcome has a state, which may be replaced; the result is added.
   * @throws InputError, SolverError.
   */
  virtual void answer(AnalysisOutcome &outcome,
                      const AnalysisContext &context) const = 0;
};

/** Analyses in the order in which they are asked. */
using FurtherAnalyses = std::vector<std::unique_ptr<FurtherAnalysis>>;
} // namespace Voussoir

#endif
