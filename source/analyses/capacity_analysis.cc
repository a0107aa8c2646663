// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/capacity_analysis.h>
#include <voussoir/analyses/factor_outcome.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/cells_at.h>
#include <voussoir/scene/loads/segment_tractions.h>

#include <cmath>
#include <utility>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;

Json summary_of(const CapacityCurve &curve)
{
  Json points = Json::array();
  for (const CapacityPoint &point : curve.points)
  {
    points.push_back({{"displacement", point.displacement},
                      {"carried", point.carried},
                      {"bound", point.bound},
                      {"error_of_state", point.error_of_state}});
    if (curve.has_moving_supports)
      points.back().update(
          Json{{"of_supports", point.of_supports},
               {"support_force", point.support_force},
               {"least_support_force", point.least_support_force}});
  }
  return {{"ultimate_displacement", curve.ultimate},
          {"end", curve.end},
          {"participation", curve.participation},
          {"points", points}};
}

std::string sentence_of(const CapacityCurve &curve)
{
  std::ostringstream words;
  words.precision(4);
  words << "At rest " << curve.points.front().carried
        << " times the live loads are carried, and ";
  if (curve.has_moving_supports && std::isfinite(curve.ultimate))
    words << "the dead loads until supports have moved by "
          << curve.points.back().of_supports << "{L}.";
  else if (std::isfinite(curve.ultimate))
    words << "none where the point has gone by " << curve.ultimate << "{L}.";
  else
    words << curve.points.back().carried << " where the point has gone by "
          << curve.points.back().displacement << "{L}: there " << curve.end
          << '.';
  return words.str();
}

std::string description_of(const CapacityCurve &curve)
{
  return text(
      "from the factor ", curve.points.front().carried, " at rest over ",
      counted(curve.points.size(), "position"),
      std::isfinite(curve.ultimate)
          ? text(" to ", curve.has_moving_supports ? "the fall" : "zero",
                 " at the displacement ", curve.ultimate)
          : text(" to ", curve.points.back().carried, " at the displacement ",
                 curve.points.back().displacement, ", where ", curve.end),
      curve.has_moving_supports
          ? text("; supports move by up to ", curve.points.back().of_supports)
          : text("; ", 100. * curve.participation,
                 " per cent of the mass take part"));
}
} // namespace

void CapacityAnalysis::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  prm.enter_subsection("Capacity");
  prm.add_parameter("Point", point,
                    "The place \"x, y\" in a block whose displacement is "
                    "followed.",
                    Anything());
  prm.add_parameter("Direction", direction,
                    "The direction \"x, y\" of that displacement, of any "
                    "size.",
                    Anything());
  prm.add_parameter("Points", n_points,
                    "About so many positions from rest to where the factor is "
                    "zero, or to where 'Supports/Displacement' leads.",
                    Integer(2, 10000));
  prm.add_parameter("Largest displacement", largest,
                    "Where the curve ends if the factor is not zero before; a "
                    "length. 0: nowhere.",
                    Double(0.));
  prm.leave_subsection();
}

CapacityWanted CapacityAnalysis::wanted(const Packing<2> &packing) const
{
  const auto place = pair_of_text(point);
  if (!place)
    throw InputError("The parameter 'Capacity/Point' is '" + point +
                     "'; two finite numbers \"x, y\" are expected, a place in "
                     "a block.");
  const CellsAt cells(packing, *place);
  if (cells.there.empty())
    throw InputError(text("The parameter 'Capacity/Point' is at ",
                          text_of_point(*place), ", which is in no block; ",
                          cells.describe_nearest(packing),
                          ". Correct the place."));
  const auto along = pair_of_text(direction);
  if (!along || !(along->norm() > 0.))
    throw InputError("The parameter 'Capacity/Direction' is '" + direction +
                     "'; two finite numbers \"x, y\" are expected, not both "
                     "zero.");
  return {cells.there.front(), *place,
          static_cast<const dealii::Tensor<1, 2> &>(*along) / along->norm(),
          n_points, largest};
}

void CapacityAnalysis::check(const Scene &scene) const
{
  wanted(scene.packing);
  if (!scene.turns())
    throw InputError("'Analysis' is 'capacity', which follows blocks that "
                     "turn; set 'Rotations = true'.");
  if (scene.has_normal_limits())
    throw InputError("'Analysis' is 'capacity', and joints crush or bear "
                     "tension, so that hinges have no place; leave out their "
                     "strengths in 'Contact'.");
  if (!scene.dilates)
    throw InputError("'Analysis' is 'capacity', whose proofs need friction "
                     "that is associated; set 'Friction/Law' to 'associated "
                     "Coulomb' or 'Tresca'.");
}

AnalysisOutcome CapacityAnalysis::answer(SceneData data,
                                         const AnalysisContext &context) const
{
  const Scene dead = context.parameters.scene_of(data);
  const Scene live = context.parameters.live_scene_of(data);
  check(dead);
  context.timer.enter_subsection("statics");
  context.terminal.begin("Statics");
  const SolverControls &common = context.solver.controls();
  const LoadFactorControls controls = {true, common.tolerance_of_factor,
                                       common.n_max_iterations};
  CapacityWanted of_curve = wanted(dead.packing);
  of_curve.of_supports = context.parameters.motion_of_supports(dead.packing);
  CapacityAnswer capacity =
      find_capacity(dead, live, of_curve, controls, context.terminal);
  context.timer.leave_subsection();
  SolverRecord record;
  double at_rest = 0.;
  if (const auto &factor = capacity.at_rest.factor)
  {
    at_rest = factor->carried;
    record.formulation = "capacity";
    record.selection =
        "one of the states that carry the loads at the factor at rest";
    record.outcome = factor->stop.words();
    record.n_iterations = record.n_evaluations = factor->n_iterations;
  }
  CapacityCurve &curve = capacity.curve;
  FactorSearch found = {std::move(capacity.at_rest),
                        context.parameters.scene_at(std::move(data), at_rest),
                        LiveLoads{live.load, live.load_torque}};
  AnalysisOutcome outcome =
      outcome_of(found, record,
                 text("capacity: ", counted(curve.points.size(), "position")),
                 true, context);
  if (!found.answer.factor)
    return outcome;
  AnalysisResult result = {"capacity",        "Capacity", description_of(curve),
                           summary_of(curve), true,       sentence_of(curve)};
  result.motion = mechanism_of(found);
  result.data = std::move(curve);
  outcome.results.push_back(std::move(result));
  return outcome;
}
} // namespace Voussoir
