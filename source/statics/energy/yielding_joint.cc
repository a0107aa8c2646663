// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/energy/yielding_joint.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace Voussoir
{
namespace
{
/** The rows of a joint between blocks that turn, before the tangential one. */
constexpr unsigned int start = 0, end = 1, middle = 2;
constexpr unsigned int n_contacts_with_middle = 3;

/**
 * Blocks that turn, with a third contact in the middle of each joint, whose
 * opening is the mean of those at the ends. It has no force; its second
 * derivative is that which mixes the two ends.
 */
class WithMiddle : public Kinematics
{
public:
  std::string name() const override { return rotations().name() + ", middle"; }
  unsigned int n_unknowns() const override { return rotations().n_unknowns(); }
  unsigned int n_contacts() const override { return n_contacts_with_middle; }
  void find_rows(const JointFrame &joint, ContactRow *rows) const override
  {
    rotations().find_rows(joint, rows);
    add_middle(rows);
  }
  unsigned int n_rigid_motions() const override
  {
    return rotations().n_rigid_motions();
  }
  void find_rigid_motion(const unsigned int k,
                         const dealii::Tensor<1, 2> &x,
                         double *unknowns) const override
  {
    rotations().find_rigid_motion(k, x, unknowns);
  }
  /** Put the middle between the rows of the ends and the tangential one. */
  static void add_middle(ContactRow *rows)
  {
    rows[n_contacts_with_middle] = rows[middle];
    rows[middle] = {0.5 * (rows[start].direction + rows[end].direction),
                    0.5 * (rows[start].turn_minus + rows[end].turn_minus),
                    0.5 * (rows[start].turn_plus + rows[end].turn_plus)};
  }
};

} // namespace

Structure with_middle(const DiscreteProblem &problem)
{
  static const WithMiddle kinematics;
  const bool turns = problem.n_contacts() > 1;
  Structure::Part part;
  part.kinematics = turns ? &kinematics : &problem.kinematics();
  part.friction = &problem.friction();
  part.loads = problem.loads();
  part.centres = problem.centres();
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    std::array<ContactRow, n_contacts_with_middle + 1> rows;
    for (unsigned int r = 0; r < problem.n_rows(); ++r)
      rows[r] = problem.row(e, r);
    if (turns)
      WithMiddle::add_middle(rows.data());
    part.joints.add(problem.joints()[e], rows.data(), part.kinematics->n_rows(),
                    problem.n_unknowns() > 2);
  }
  return Structure(ProcessGroup(), std::move(part));
}

std::vector<double> without_middle(const DiscreteProblem &problem,
                                   const std::vector<double> &forces)
{
  std::vector<double> kept;
  kept.reserve(problem.n_all_rows());
  const std::size_t n = forces.size() / problem.joints().size();
  for (auto of = forces.begin(); of != forces.end(); of += n)
  {
    kept.insert(kept.end(), of, of + problem.n_contacts());
    kept.push_back(of[n - 1]);
  }
  return kept;
}

void YieldingJoint::find_forces(const unsigned int e,
                                const double *jumps,
                                double *forces) const
{
  const unsigned int n = structure.n_contacts();
  std::fill_n(forces, n, 0.);
  if (is_section(e))
  {
    const Section::Forces found = section(e).forces(jumps[start], jumps[end]);
    forces[start] = found.at_start;
    forces[end] = found.at_end;
  }
  else
    for (unsigned int k = 0; k < problem.n_contacts(); ++k)
      forces[k] = std::clamp(problem.contact_stiffness(e) * jumps[k], least(e),
                             most(e));
  const double limit = structure.limit(e);
  forces[n] =
      std::clamp(structure.joints()[e].stiffness() * jumps[n], -limit, limit);
}

void YieldingJoint::find_second_derivatives(const unsigned int e,
                                            const double *jumps,
                                            double *second) const
{
  const unsigned int n = structure.n_contacts();
  std::fill_n(second, n, 0.);
  if (is_section(e))
  {
    const Section::Stiffness found =
        section(e).stiffness(jumps[start], jumps[end]);
    second[start] = found.at_start - found.mixed;
    second[end] = found.at_end - found.mixed;
    second[middle] = 4. * found.mixed;
  }
  else
    for (unsigned int k = 0; k < problem.n_contacts(); ++k)
    {
      const double stiffness = problem.contact_stiffness(e);
      const double force = stiffness * jumps[k];
      second[k] = force < least(e) || force > most(e) ? 0. : stiffness;
    }
  const double stiffness = structure.joints()[e].stiffness();
  second[n] =
      std::abs(stiffness * jumps[n]) > structure.limit(e) ? 0. : stiffness;
}

bool YieldingJoint::is_section(const unsigned int e) const
{
  return structure.n_contacts() == n_contacts_with_middle &&
         std::isfinite(problem.normal_limits()[e].crushing);
}

Section YieldingJoint::section(const unsigned int e) const
{
  return Section(structure.joints()[e].stiffness(), problem.normal_limits()[e]);
}

double YieldingJoint::least(const unsigned int e) const
{
  return -problem.normal_limits()[e].crushing / problem.n_contacts();
}

double YieldingJoint::most(const unsigned int e) const
{
  return problem.tension(e) / problem.n_contacts();
}
} // namespace Voussoir
