// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_factors_factor_entries_h
#define voussoir_analyses_factors_factor_entries_h

#include <voussoir/analyses/factors/load_factor.h>
#include <voussoir/statics/problem/solver_controls.h>

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json.hpp>

#include <string>

namespace Voussoir
{
/** The section `Load factor`, in the plane and in space. */
struct FactorEntries
{
  /** What the factor multiplies. */
  enum class Factor
  {
    /** The section `Live loads`. */
    live_loads,
    /** Both sections of loads. */
    all_loads,
    /** The strengths against sliding, as a divisor. */
    strength
  };
  /** Which end of the factors is looked for. */
  enum class Direction
  {
    greatest,
    least
  };

  /** Declare the section and bind it. */
  void add_parameters(dealii::ParameterHandler &prm);
  /** The controls of a search, with what is common to all solvers. */
  LoadFactorControls controls(const SolverControls &common) const;

  /** What is multiplied. */
  Factor multiplied = Factor::live_loads;
  /** The end. */
  Direction direction = Direction::greatest;
};

/**
 * A line for people on a factor between its proofs, or without dilatancy on the
 * factors that were tried.
 */
template <typename SceneOf>
std::string description_of(const FactorOf<SceneOf> &factor);

/**
 * The factor between its proofs as a sentence with four digits; empty if there
 * are not both.
 *
 * @param multiplied what by it.
 */
template <typename SceneOf>
std::string sentence_of(const FactorOf<SceneOf> &factor,
                        FactorEntries::Factor multiplied);

/** The same for summary.json. */
template <typename SceneOf>
nlohmann::ordered_json json_of(const FactorOf<SceneOf> &factor);
} // namespace Voussoir

#endif
