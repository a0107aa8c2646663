// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/conic/friction_cone.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
namespace
{
/** a^2 - b^2 - c^2, which is positive inside the cone. */
double determinant(const double a, const double b, const double c)
{
  const double h = std::hypot(b, c);
  return (a - h) * (a + h);
}

/**
 * The largest t with (a, b, c) + t (da, db, dc) in the cone, from a point
 * inside: the smallest positive root of the determinant, which is quadratic.
 */
double longest(const double a,
               const double b,
               const double c,
               const double da,
               const double db,
               const double dc)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double quadratic = da * da - db * db - dc * dc;
  const double half_linear = a * da - b * db - c * dc;
  const double constant = determinant(a, b, c);
  const double root = half_linear * half_linear - quadratic * constant;
  double t = da < 0. ? -a / da : infinity;
  if (!(root >= 0.))
    return t;
  const double sum =
      -(half_linear + std::copysign(std::sqrt(root), half_linear));
  // It is zero only of a constant.
  if (sum != 0.)
    for (const double zero : {sum / quadratic, constant / sum})
      if (zero > 0.)
        t = std::min(t, zero);
  return t;
}
} // namespace

FrictionCone::FrictionCone(const double strength,
                           const double smoothing,
                           const double product)
    : b(strength), eps(smoothing)
{
  if (!exists())
    return;
  // r b - eps w = product and r w = b eps.
  const double half = product / (2. * b);
  r = half + std::hypot(half, eps);
  w = b * (eps / r);
}

void FrictionCone::linearise()
{
  second_of_v = second_of_r = 0.;
  room = determinant(b, q, w);
  const double root_s = std::sqrt(determinant(r, v, eps));
  const double root_lambda = std::sqrt(room);
  // The scaling point of s and lambda, both divided by their roots.
  const double gamma = std::sqrt(2. + 2. * product() / (root_s * root_lambda));
  const double w0 = (r / root_s + b / root_lambda) / gamma;
  const double w1 = (v / root_s + q / root_lambda) / gamma;
  const double w2 = (eps / root_s + w / root_lambda) / gamma;
  const double size = root_s / root_lambda;
  h01 = size * 2. * w0 * w1;
  h02 = size * 2. * w0 * w2;
  h11 = size * (1. + 2. * w1 * w1);
  h12 = size * 2. * w1 * w2;
  h22 = size * (1. + 2. * w2 * w2);
  // h11 - h12^2 / h22, since eps does not change.
  slope = size * (1. + 2. * (w1 * w1 + w2 * w2)) / (1. + 2. * w2 * w2);
}

FrictionCone::Step FrictionCone::step(const double target,
                                      const double dq) const
{
  const double dw = -(target * (w / room) - eps + h12 * dq) / h22;
  return {dq, dw, constant(target) + slope * dq,
          target * (b / room) - r + h01 * dq + h02 * dw + second_of_r};
}

void FrictionCone::correct_for(const Step &predictor)
{
  second_of_v = second_of_r = 0.;
  if (eps > 0.)
    return;
  // Without smoothing the cone is two bounds, b + q and b - q, with the
  // multipliers (r - v) / 2 and (r + v) / 2.
  const double backward =
      predictor.q * 0.5 * (predictor.r - predictor.v) / (b + q);
  const double forward =
      -predictor.q * 0.5 * (predictor.r + predictor.v) / (b - q);
  second_of_v = backward - forward;
  second_of_r = -backward - forward;
}

double FrictionCone::longest_of_force(const Step &step) const
{
  return longest(b, q, w, 0., step.q, step.w);
}

double FrictionCone::longest_of_sliding(const Step &step) const
{
  return longest(r, v, eps, step.r, step.v, 0.);
}
} // namespace Voussoir
