// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/energy/face_joint.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
/** A pressure, or tension up to its largest. */
struct ElasticContact
{
  double stiffness, tension;

  void find_forces(const double *jump, double *force) const
  {
    *force = std::min(stiffness * *jump, tension);
  }
  void find_second_derivatives(const double *jump, double *second) const
  {
    *second = stiffness * *jump <= tension ? stiffness : 0.;
  }
};

/** A disc of friction: two tangential forces, at most a strength. */
struct ElasticDisc
{
  double stiffness, strength;

  bool slides(const double *jump) const
  {
    return stiffness * std::hypot(jump[0], jump[1]) > strength;
  }
  void find_forces(const double *jump, double *force) const
  {
    const double factor =
        slides(jump) ? strength / std::hypot(jump[0], jump[1]) : stiffness;
    for (unsigned int i = 0; i < 2; ++i)
      force[i] = factor * jump[i];
  }
  void find_second_derivatives(const double *jump, double *second) const
  {
    const bool is_sliding = slides(jump);
    const double size = std::hypot(jump[0], jump[1]);
    const double across = is_sliding ? strength / size : stiffness,
                 along = is_sliding ? 0. : stiffness;
    const double t[] = {is_sliding ? jump[0] / size : 1.,
                        is_sliding ? jump[1] / size : 0.};
    second[0] = along * t[0] * t[0] + across * t[1] * t[1];
    second[1] = second[2] = (along - across) * t[0] * t[1];
    second[3] = along * t[1] * t[1] + across * t[0] * t[0];
  }
};

/** A pressure with friction that grows with it. */
struct ElasticCone
{
  /** Across the joint, and the part of it along the joint. */
  double stiffness, part;
  double coefficient;
  /** The largest tension, that of the tip of the cone. */
  double tension;

  /** The state of a cone. */
  enum class State
  {
    sticks,
    slides,
    open
  };
  /** The pressure and friction of a joint that sticks. */
  struct Trial
  {
    double pressure, size;
    State state;
    /** The pressure, from the tip, if it slides. */
    double sliding_pressure;
  };
  Trial trial(const double *jump) const
  {
    Trial of = {tension - stiffness * jump[0],
                part * stiffness * std::hypot(jump[1], jump[2]), State::sticks,
                0.};
    if (of.size <= coefficient * of.pressure)
      return of;
    of.sliding_pressure = (of.pressure + coefficient / part * of.size) /
                          (1. + coefficient * coefficient / part);
    of.state = of.sliding_pressure > 0. ? State::slides : State::open;
    return of;
  }
  void find_forces(const double *jump, double *force) const
  {
    const Trial of = trial(jump);
    force[0] = tension;
    force[1] = force[2] = 0.;
    if (of.state == State::open)
      return;
    const bool slides = of.state == State::slides;
    force[0] -= slides ? of.sliding_pressure : of.pressure;
    for (unsigned int i = 1; i < 3; ++i)
      force[i] = part * stiffness * jump[i] *
                 (slides ? coefficient * of.sliding_pressure / of.size : 1.);
  }
  void find_second_derivatives(const double *jump, double *second) const
  {
    const Trial of = trial(jump);
    std::fill_n(second, 9, 0.);
    if (of.state == State::open)
      return;
    if (of.state == State::sticks)
    {
      second[0] = stiffness;
      second[4] = second[8] = part * stiffness;
      return;
    }
    const double size = std::hypot(jump[1], jump[2]);
    const double t[] = {jump[1] / size, jump[2] / size};
    const double normal = stiffness / (1. + coefficient * coefficient / part);
    const double along = coefficient * coefficient * normal,
                 across = coefficient * of.sliding_pressure / size;
    second[0] = normal;
    for (unsigned int i = 0; i < 2; ++i)
    {
      second[1 + i] = second[3 * (1 + i)] = -coefficient * normal * t[i];
      for (unsigned int j = 0; j < 2; ++j)
        second[3 * (1 + i) + 1 + j] =
            (along - across) * t[i] * t[j] + (i == j ? across : 0.);
    }
  }
};
} // namespace

/** Call @p f for each set of joint @p e, with its law. */
template <typename F>
void FaceJoint::for_each_law(const unsigned int e, const F &f) const
{
  const Structure::Joint &joint = structure.joints()[e];
  const double part = joint.tangential_part();
  structure.for_each_face_set(e, [&](const Structure::FaceSet &set) {
    const double stiffness = joint.stiffness() * set.share;
    const double of_set = tension[e] * set.share;
    if (set.size == 1)
      f(set, ElasticContact{stiffness, of_set});
    else if (set.size == 2)
      f(set, ElasticDisc{part * stiffness, set.strength});
    else
      f(set, ElasticCone{stiffness, part, joint.coefficient, of_set});
  });
}

void FaceJoint::find_forces(const unsigned int e,
                            const double *jumps,
                            double *forces) const
{
  for_each_law(e, [&](const Structure::FaceSet &set, const auto &law) {
    law.find_forces(jumps + set.row, forces + set.row);
  });
}

bool FaceJoint::find_second_derivatives(const unsigned int e,
                                        const double *jumps,
                                        double *second) const
{
  for_each_law(e, [&](const Structure::FaceSet &set, const auto &law) {
    law.find_second_derivatives(jumps + set.row, second + set.coefficient);
  });
  const Structure::Joint &joint = structure.joints()[e];
  // At one point, or at two in the same place: k_e in all directions, or less.
  const double k = joint.stiffness();
  const unsigned int n = structure.n_rows(e);
  if (structure.kinematics().turns() || joint.tangential_part() != 1.)
    return false;
  if (joint.coefficient > 0.)
    return n == 3 && second[0] == k && second[4] == k && second[8] == k;
  return n == 3 && second[0] == k && second[1] == k && second[4] == k;
}
} // namespace Voussoir
