// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/statics/conic/row_problem.h>

#include <utility>

namespace Voussoir
{
namespace
{
/** True for each body that stands for its connected group. */
std::vector<bool> held_bodies(const DiscreteProblem &problem,
                              const unsigned int n_bodies)
{
  std::vector<bool> held(n_bodies, false);
  for (unsigned int b = 0; b < problem.n_bodies(); ++b)
    held[b] = problem.is_held(b);
  return held;
}

void divide_by_largest(std::vector<double> &u)
{
  const double size = largest_component(u);
  if (size > 0.)
    for (double &component : u)
      component /= size;
}
} // namespace

std::vector<double> displacement_of_size_one(const DiscreteProblem &problem,
                                             std::vector<double> u)
{
  u.resize(problem.n_dofs());
  // Divided before, too, since a rigid motion may be large beside the rest.
  divide_by_largest(u);
  problem.remove_rigid_motions(u);
  divide_by_largest(u);
  return u;
}
std::optional<Mechanism> mechanism_by_rows(const ForceRows &rows,
                                           std::vector<double> u)
{
  divide_by_largest(u);
  Mechanism mechanism;
  // Of which the work of the offset is a part.
  mechanism.work = dot(rows.loads(), u);
  mechanism.dissipation = rows.dissipation_of_jumps(rows.jumps(u));
  if (!(mechanism.work > mechanism.dissipation))
    return {};
  mechanism.u = displacement_of_size_one(rows.of(), std::move(u));
  return mechanism;
}

RowProblem::RowProblem(const DiscreteProblem &problem)
    : problem(problem), of_rows(problem),
      of_forces(of_rows, held_bodies(problem, of_rows.n_bodies()))
{}

std::vector<double> RowProblem::loads() const
{
  std::vector<double> own = of_rows.loads();
  of_forces.clear_held(own);
  return own;
}

std::vector<double> RowProblem::loads(std::vector<double> of_problem,
                                      const bool with_offset) const
{
  of_problem.resize(of_rows.n_dofs(), 0.);
  if (with_offset)
    add(of_problem, 1., of_rows.offset());
  of_forces.clear_held(of_problem);
  return of_problem;
}

} // namespace Voussoir
