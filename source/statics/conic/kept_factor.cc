// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/conic/kept_factor.h>

namespace Voussoir
{
namespace
{
using Json = Journal::Json;

template <typename T, typename Read>
std::optional<T> optional_of(const Json &json, const Read &read)
{
  return json.is_null() ? std::optional<T>() : read(json);
}

Json json_of(const SelfDual::Variables &of)
{
  return {{"x", packed(of.x)}, {"u", packed(of.u)}, {"s", packed(of.s)},
          {"z", packed(of.z)}, {"alpha", of.alpha}, {"tau", of.tau},
          {"kappa", of.kappa}};
}

SelfDual::Variables variables_of(const Json &json)
{
  SelfDual::Variables of;
  of.x = unpacked(json.at("x"));
  of.u = unpacked(json.at("u"));
  of.s = unpacked(json.at("s"));
  of.z = unpacked(json.at("z"));
  of.alpha = json.at("alpha");
  of.tau = json.at("tau");
  of.kappa = json.at("kappa");
  return of;
}

Json json_of(const SelfDual::Point &of)
{
  return {{"x", packed(of.x)},
          {"u", packed(of.u)},
          {"s", packed(of.s)},
          {"z", packed(of.z)},
          {"alpha", of.alpha}};
}

SelfDual::Point point_of(const Json &json)
{
  return {unpacked(json.at("x")), unpacked(json.at("u")),
          unpacked(json.at("s")), unpacked(json.at("z")), json.at("alpha")};
}

Json json_of(const FactorState &of)
{
  return {{"x", packed(of.x)}, {"alpha", of.alpha}, {"residual", of.residual}};
}

FactorState state_of(const Json &json)
{
  return {unpacked(json.at("x")), json.at("alpha"), json.at("residual")};
}

Json json_of(const FactorMotion &of)
{
  return {{"u", packed(of.u)}, {"z", packed(of.z)}, {"closing", of.closing}};
}

FactorMotion motion_of(const Json &json)
{
  return {unpacked(json.at("u")), unpacked(json.at("z")), json.at("closing")};
}

/** Null for none. */
template <typename T>
Json json_of(const std::optional<T> &of)
{
  return of ? json_of(*of) : Json();
}
} // namespace

Json json_of(const KeptFactor &kept)
{
  const SelfDual::Progress &progress = kept.progress;
  return {{"at", json_of(progress.at)},
          {"iterations", progress.iterations},
          {"iteration_of_least", progress.iteration_of_least},
          {"least_mean", progress.least_mean},
          {"best", json_of(kept.best)},
          {"least_merit", kept.least_merit},
          {"last_trial", kept.last_trial},
          {"has_taken_known", kept.has_taken_known},
          {"anchor", json_of(kept.anchor)},
          {"open", json_of(kept.open)},
          {"best_state", json_of(kept.best_state)},
          {"has_state", kept.has_state},
          {"best_motion", json_of(kept.best_motion)},
          {"least_bound", kept.least_bound}};
}

KeptFactor kept_factor_of(const Json &json)
{
  KeptFactor kept;
  kept.progress = {variables_of(json.at("at")), json.at("iterations"),
                   json.at("iteration_of_least"), json.at("least_mean")};
  kept.best = optional_of<SelfDual::Point>(json.at("best"), point_of);
  kept.least_merit = json.at("least_merit");
  kept.last_trial = json.at("last_trial");
  kept.has_taken_known = json.at("has_taken_known");
  kept.anchor = optional_of<FactorState>(json.at("anchor"), state_of);
  kept.open = optional_of<FactorMotion>(json.at("open"), motion_of);
  kept.best_state = optional_of<FactorState>(json.at("best_state"), state_of);
  kept.has_state = json.at("has_state");
  kept.best_motion =
      optional_of<FactorMotion>(json.at("best_motion"), motion_of);
  kept.least_bound = json.at("least_bound");
  return kept;
}
} // namespace Voussoir
