// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/structure.h>

#include <deal.II/base/index_set.h>

#include <utility>

namespace Voussoir
{
Structure::Structure(const Team &team, Part part)
    : joint_list(std::move(part.joints)), load(std::move(part.loads)),
      processes(team), first(part.first), ghost_list(std::move(part.ghosts))
{
  if (team.size() == 1)
    return;
  const unsigned int n_all_dofs = 2 * team.sum(n_own_bodies());
  dealii::IndexSet own(n_all_dofs), of_ghosts(n_all_dofs);
  own.add_range(dof(first, 0), dof(first + n_own_bodies(), 0));
  for (const unsigned int ghost : ghost_list)
    of_ghosts.add_range(dof(ghost, 0), dof(ghost + 1, 0));
  exchange = std::make_shared<const dealii::Utilities::MPI::Partitioner>(
      own, of_ghosts, team.communicator());
}

const Team &Structure::team() const
{
  return processes;
}

unsigned int Structure::n_own_bodies() const
{
  return load.size();
}

unsigned int Structure::n_bodies() const
{
  return load.size() + ghost_list.size();
}

unsigned int Structure::n_own_dofs() const
{
  return 2 * n_own_bodies();
}

unsigned int Structure::n_dofs() const
{
  return 2 * n_bodies();
}

unsigned int Structure::first_body() const
{
  return first;
}

const std::vector<unsigned int> &Structure::ghosts() const
{
  return ghost_list;
}

const std::vector<Structure::Joint> &Structure::joints() const
{
  return joint_list;
}

const std::vector<dealii::Tensor<1, 2>> &Structure::loads() const
{
  return load;
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

double Structure::work(const double *u) const
{
  long double work = 0.;
  for (unsigned int b = 0; b < n_own_bodies(); ++b)
    for (unsigned int i = 0; i < 2; ++i)
      work += load[b][i] * u[dof(b, i)];
  return processes.sum(work);
}
} // namespace Voussoir
