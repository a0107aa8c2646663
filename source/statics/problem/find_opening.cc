// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/newton.h>
#include <voussoir/statics/problem/equilibrate.h>
#include <voussoir/statics/problem/find_opening.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
using dealii::Tensor;

/**
 * The cosine of the angle between a support and the way that the ground is
 * drawn back, below which it would have to go too far.
 */
constexpr double least_cosine = 1e-2;

/** The proximal term of the first step; joints that are open leave cells free.
 */
constexpr double first_shift_of_opening = 1e-6;
/** Its reduction after a step, and the least length of such a step. */
constexpr double shift_ratio = 0.1, good_step = 0.5;
/** The part of d_e by which a joint must open to count as open. */
constexpr double least_opening = 0.5;
/**
 * The forces, relative to stiffnesses and distances of order one, that may be
 * those of the minimum but for rounding.
 */
constexpr double small_imbalance = 1e-9;
constexpr unsigned int n_max_opening_steps = 200;
/** The error of a vertex, in roundings of a coordinate. */
constexpr double n_roundings = 32.;

/** A spring that pushes until its joint has opened by d_e. */
class PushingJoint : public JointLaw
{
public:
  explicit PushingJoint(const DiscreteProblem &problem) : problem(problem) {}

  void find_forces(const unsigned int e,
                   const double *jumps,
                   double *forces) const override
  {
    const unsigned int n = problem.n_contacts(e);
    for (unsigned int r = 0; r < n; ++r)
      forces[r] = problem.contact_stiffness(e) *
                  std::min(jumps[r] - problem.joints()[e].distance, 0.);
    forces[n] = 0.;
  }
  bool find_second_derivatives(const unsigned int e,
                               const double *jumps,
                               double *second) const override
  {
    const unsigned int n = problem.n_contacts(e);
    for (unsigned int r = 0; r < n; ++r)
      second[r] = jumps[r] < problem.joints()[e].distance
                      ? problem.contact_stiffness(e)
                      : 0.;
    second[n] = 0.;
    return is_isotropic(second, n);
  }

private:
  const DiscreteProblem &problem;
};

/**
 * Find the displacement @p ground with which its supports open by d_e in the
 * dilation u = x_c: beyond the line of each of them.
 *
 * @return true if there is such a point.
 */
bool draw_back_ground(const DiscreteProblem &problem, Tensor<1, 3> &ground)
{
  Tensor<1, 3> mean_normal, mean_point;
  double length = 0.;
  const auto for_supports = [&](const auto &visit) {
    for (unsigned int e = 0; e < problem.joints().size(); ++e)
    {
      const DiscreteProblem::Joint &joint = problem.joints()[e];
      if (joint.cell_plus == problem.n_cells())
        visit(joint.length, problem.normal(e),
              problem.centre(joint.cell_minus) +
                  joint.distance * problem.normal(e));
    }
  };
  for_supports([&](const double share, const Tensor<1, 3> &normal,
                   const Tensor<1, 3> &point) {
    mean_normal += share * normal;
    mean_point += share * point;
    length += share;
  });
  ground = mean_point / length;
  if (!(mean_normal.norm() > least_cosine * length))
    return false;

  const Tensor<1, 3> back = mean_normal / mean_normal.norm();
  double distance = 0.;
  bool all_face_back = true;
  for_supports(
      [&](double, const Tensor<1, 3> &normal, const Tensor<1, 3> &point) {
        const double cosine = normal * back;
        if (cosine > least_cosine)
          distance = std::max(distance, (point - ground) * normal / cosine);
        else
          all_face_back = false;
      });
  ground += distance * back;
  return all_face_back;
}

/** The error of n_e from the rounding of the coordinates. */
double error_of_normal(const DiscreteProblem &problem,
                       const DiscreteProblem::Joint &joint)
{
  return n_roundings * problem.rounding_of_coordinates() *
         (1. + 1. / joint.length);
}

/**
 * True if the displacement @p u (n_dofs() numbers) opens every joint by more
 * than the rounding of its normal, which is that of the coordinates over the
 * length of the joint, could make of it.
 */
bool opens_all_joints(const DiscreteProblem &problem,
                      const std::vector<double> &u)
{
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    const double opening = problem.opening(e, u.data());
    if (!(opening > error_of_normal(problem, problem.joints()[e]) *
                        std::hypot(opening, problem.sliding(e, u.data()))))
      return false;
  }
  return true;
}

/**
 * True if no motion opens every joint by more than that, since the normal
 * forces @p p, of each row of each joint and zero in tangential ones, balance
 * by themselves: if every |u_c| <= 1, then the least [u]_e . n_e is at most the
 * sum of what is left on the cells over the sum of p.
 */
bool is_self_stress(const DiscreteProblem &problem,
                    const std::vector<double> &p)
{
  std::vector<double> sum(problem.n_dofs());
  double rounding = 0.;
  for (unsigned int e = 0; e < problem.joints().size() && !p.empty(); ++e)
    for (unsigned int r = 0; r < problem.n_contacts(e); ++r)
    {
      const double pressure = p[problem.first_row(e) + r];
      if (!(pressure >= 0.))
        return false;
      rounding += pressure * error_of_normal(problem, problem.joints()[e]);
    }
  if (!p.empty())
    problem.add_jump_gradients(1., p, sum);
  double left = 0.;
  for (unsigned int b = 0; b < problem.n_bodies(); ++b)
  {
    const double *of_body = &sum[problem.dof(b, 0)];
    left += problem.is_plane() ? std::hypot(of_body[0], of_body[1])
                               : std::hypot(of_body[0], of_body[1], of_body[2]);
    // The ground does not turn, and is far from some of its joints.
    for (unsigned int i = problem.n_translations();
         i < problem.n_unknowns() && b < problem.n_cells(); ++i)
      left += std::abs(of_body[i]);
  }
  return rounding > 0. && left <= rounding;
}

/** Go from @p u along @p ray, which opens all joints, until each is open. */
std::vector<double> open_along(const DiscreteProblem &problem,
                               const std::vector<double> &ray,
                               std::vector<double> u)
{
  double length = 0.;
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    for (unsigned int r = 0; r < problem.n_contacts(e); ++r)
      length = std::max(length, (problem.joints()[e].distance -
                                 problem.jump(e, r, u.data())) /
                                    problem.jump(e, r, ray.data()));
  for (unsigned int k = 0; k < u.size(); ++k)
    u[k] += length * ray[k];
  return u;
}

/** The forces of the springs, mended by equilibrate() if that helps. */
std::vector<double> self_stress_near(const DiscreteProblem &smooth,
                                     const std::vector<double> &forces)
{
  const auto pushes = [](std::vector<double> f) {
    for (double &force : f)
      force = std::max(-force, 0.);
    return f;
  };
  std::vector<double> p = pushes(forces);
  if (!is_self_stress(smooth, p))
    p = pushes(equilibrate(smooth, forces));
  return is_self_stress(smooth, p) ? p : std::vector<double>();
}

/** The search by springs that push, from @p u on. */
Opening push_open(const DiscreteProblem &problem, const std::vector<double> &u)
{
  // Springs have no load to bear, and equilibrate() no friction to count on.
  const DiscreteProblem smooth =
      problem.without_loads().with_strengths_up_to(0.);
  const PushingJoint law(smooth);
  JointSystem system(smooth, LinearSolver::automatic);
  Newton newton(smooth, law, system, u);
  std::vector<double> ray;
  double shift = first_shift_of_opening;
  while (newton.n_iterations() < n_max_opening_steps)
  {
    const std::vector<double> before = newton.u();
    const double length = newton.step(shift, before);
    bool all_open = true;
    for (unsigned int e = 0; e < problem.joints().size(); ++e)
      for (unsigned int r = 0; r < problem.n_contacts(e); ++r)
        all_open &= newton.jumps()[problem.first_row(e) + r] >
                    least_opening * problem.joints()[e].distance;
    if (all_open && opens_all_joints(problem, newton.u()))
      return {newton.u(), {}};

    std::vector<double> step = newton.u();
    for (unsigned int k = 0; k < step.size(); ++k)
      step[k] -= before[k];
    if (opens_all_joints(problem, step))
      ray = std::move(step);
    else if (ray.empty() && newton.imbalance() <= small_imbalance)
    {
      const std::vector<double> p = self_stress_near(smooth, newton.forces());
      if (!p.empty())
        return {{}, p};
    }
    if (!ray.empty() && shift == least_shift)
      break;
    if (length >= good_step)
      shift = std::max(shift_ratio * shift, least_shift);
  }
  if (!ray.empty())
    return {open_along(problem, ray, newton.u()), {}};
  return {{}, self_stress_near(smooth, newton.forces())};
}

/** True if a motion opens each joint between two cells, if only a little. */
bool opens_between_cells(const DiscreteProblem &problem,
                         const std::vector<double> &u)
{
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    if (problem.joints()[e].cell_plus != problem.n_cells() &&
        !(problem.opening(e, u.data()) > 0.))
      return false;
  return true;
}

Opening find_opening(const DiscreteProblem &problem)
{
  std::vector<double> u(problem.n_dofs());
  for (unsigned int c = 0; c < problem.n_cells(); ++c)
    for (unsigned int i = 0; i < problem.n_translations(); ++i)
      u[problem.dof(c, i)] = problem.centre(c)[i];
  // Convex blocks all draw apart, others may clamp each other.
  const bool draws_apart = opens_between_cells(problem, u);
  if (!problem.has_ground())
    return draws_apart ? Opening{u, {}} : push_open(problem, u);
  Tensor<1, 3> ground;
  if (!draws_apart || !draw_back_ground(problem, ground))
    return push_open(problem, u);
  for (unsigned int i = 0; i < problem.n_translations(); ++i)
    u[problem.dof(problem.n_cells(), i)] = ground[i];
  return {u, {}};
}
} // namespace

const Opening &opening_of(const DiscreteProblem &problem)
{
  if (!problem.found_opening)
    problem.found_opening = find_opening(problem);
  return *problem.found_opening;
}
} // namespace Voussoir
