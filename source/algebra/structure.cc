// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/structure.h>

#include <deal.II/base/index_set.h>

#include <array>
#include <utility>

namespace Voussoir
{

Structure::Structure(const Kinematics &kinematics, const FrictionLaw &friction)
    : unknowns_per_body(kinematics.n_unknowns()),
      rows_per_joint(kinematics.n_rows())
{
  Assert(rows_per_joint <= most_rows, dealii::ExcInternalError());
  own.kinematics = &kinematics;
  own.friction = &friction;
}

Structure::Structure(const ProcessGroup &processes, Part part)
    : own(std::move(part)), group(processes),
      unknowns_per_body(own.kinematics->n_unknowns()),
      rows_per_joint(own.kinematics->n_rows())
{
  if (processes.size() == 1)
    return;
  const unsigned int n_all_dofs =
      unknowns_per_body * processes.sum(n_own_bodies());
  dealii::IndexSet of_own(n_all_dofs), of_ghosts(n_all_dofs);
  of_own.add_range(dof(own.first, 0), dof(own.first + n_own_bodies(), 0));
  for (const unsigned int ghost : own.ghosts)
    of_ghosts.add_range(dof(ghost, 0), dof(ghost + 1, 0));
  exchange = std::make_shared<const dealii::Utilities::MPI::Partitioner>(
      of_own, of_ghosts, processes.communicator());
}

void Structure::Joints::add(const Joint &joint,
                            const ContactRow *rows,
                            const unsigned int n_rows,
                            const bool with_turns)
{
  list.push_back(joint);
  for (unsigned int r = 0; r < n_rows; ++r)
  {
    direction.push_back(rows[r].direction);
    if (!with_turns)
      continue;
    turn_minus.push_back(rows[r].turn_minus);
    turn_plus.push_back(rows[r].turn_plus);
  }
}

void Structure::add_joint(const Joint &joint, const JointFrame &frame)
{
  std::array<ContactRow, most_rows> rows;
  own.kinematics->find_rows(frame, rows.data());
  own.joints.add(joint, rows.data(), rows_per_joint, unknowns_per_body > 2);
}

void Structure::update_ghosts(std::vector<double> &u) const
{
  if (!exchange)
    return;
  AssertDimension(u.size(), n_dofs());
  using dealii::ArrayView;
  std::vector<double> to_send(exchange->n_import_indices());
  std::vector<MPI_Request> requests;
  const ArrayView<double> ghosts(u.data() + n_own_dofs(),
                                 u.size() - n_own_dofs());
  exchange->export_to_ghosted_array_start<double, dealii::MemorySpace::Host>(
      0, ArrayView<const double>(u.data(), n_own_dofs()),
      ArrayView<double>(to_send.data(), to_send.size()), ghosts, requests);
  exchange->export_to_ghosted_array_finish<double, dealii::MemorySpace::Host>(
      ghosts, requests);
}

std::vector<double> Structure::jumps(const std::vector<double> &u) const
{
  std::vector<double> result(n_all_rows());
  for (std::size_t e = 0; e < joints().size(); ++e)
    find_jumps(e, u.data(), &result[e * rows_per_joint]);
  return result;
}

void Structure::add_jump_gradients(const double factor,
                                   const std::vector<double> &f,
                                   std::vector<double> &gradient) const
{
  std::array<double, most_rows> of_joint;
  for (std::size_t e = 0, k = 0; e < joints().size(); ++e)
  {
    for (unsigned int r = 0; r < rows_per_joint; ++r, ++k)
      of_joint[r] = factor * f[k];
    add_jump_gradient(e, of_joint.data(), gradient.data());
  }
}

double Structure::work(const double *u) const
{
  long double work = 0.;
  for (unsigned int k = 0; k < own.loads.size(); ++k)
    work += own.loads[k] * u[k];
  return group.sum(work);
}

} // namespace Voussoir
