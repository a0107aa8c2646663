// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/newton.h>
#include <voussoir/statics/problem/equilibrate.h>
#include <voussoir/statics/problem/find_opening.h>
#include <voussoir/statics/problem/opening_proofs.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

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

/** The displacement u_c = x_c, in which the ground is at rest. */
std::vector<double> dilation(const DiscreteProblem &problem)
{
  std::vector<double> u(problem.n_dofs());
  for (unsigned int c = 0; c < problem.n_cells(); ++c)
    for (unsigned int i = 0; i < problem.n_translations(); ++i)
      u[problem.dof(c, i)] = problem.centre(c)[i];
  return u;
}

/** True if a motion opens each joint between two cells, if only a little. */
bool opens_between_cells(const DiscreteProblem &problem,
                         const std::vector<double> &u)
{
  bool all_open = true;
  for (unsigned int e = 0; e < problem.joints().size() && all_open; ++e)
    if (problem.joints()[e].cell_plus != problem.n_cells())
      problem.for_each_pressure(e, [&](const unsigned int r, double) {
        all_open &= problem.jump(e, r, u.data()) > 0.;
      });
  return all_open;
}

/**
 * The forces of a pressure of one everywhere, if they are a self-stress: where
 * every side of every cell is a joint.
 */
std::vector<double> uniform_pressure(const DiscreteProblem &problem)
{
  std::vector<double> p(problem.n_all_rows());
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    problem.for_each_pressure(e, [&](const unsigned int r, const double share) {
      p[problem.first_row(e) + r] = share * problem.joints()[e].length;
    });
  return is_self_stress(problem, p) ? p : std::vector<double>();
}

} // namespace

std::optional<Opening> opening_without_search(const DiscreteProblem &problem)
{
  // A tie draws together what dilates.
  if (!problem.links().empty())
    return {};
  std::vector<double> u = dilation(problem);
  // Convex blocks all draw apart, others may clamp each other.
  const bool draws_apart = opens_between_cells(problem, u);
  if (!problem.has_ground())
    return draws_apart ? std::optional<Opening>({u, {}}) : std::nullopt;
  Tensor<1, 3> ground;
  if (!draws_apart || !draw_back_ground(problem, ground))
  {
    std::vector<double> p = uniform_pressure(problem);
    return p.empty() ? std::nullopt
                     : std::optional<Opening>({{}, std::move(p)});
  }
  for (unsigned int i = 0; i < problem.n_translations(); ++i)
    u[problem.dof(problem.n_cells(), i)] = ground[i];
  return Opening{u, {}};
}

const Opening &opening_of(const DiscreteProblem &problem)
{
  Assert(problem.is_plane(), dealii::ExcInternalError());
  if (!problem.found_opening)
    problem.found_opening = opening_without_search(problem);
  if (!problem.found_opening)
    problem.found_opening = push_open(problem, dilation(problem));
  return *problem.found_opening;
}

std::string reason_of_no_opening(const Opening &opening, const bool has_ground)
{
  if (opening.self_stress.empty())
    return "Whether the supports clamp the packing cannot be told: a motion "
           "that opens all contacts would open some of them by no more than "
           "the rounding of the coordinates, or could not be found.";
  return has_ground
             ? "The supports clamp the packing: no motion opens all contacts, "
               "so that normal forces can balance by themselves and have no "
               "bound."
             : "Blocks clamp each other: no motion opens all contacts, so that "
               "normal forces can balance by themselves and have no bound.";
}
} // namespace Voussoir
