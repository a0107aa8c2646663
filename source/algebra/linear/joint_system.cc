// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/linear/cholesky.h>
#include <voussoir/algebra/linear/componentwise.h>
#include <voussoir/algebra/linear/joint_blocks.h>
#include <voussoir/algebra/linear/joint_system.h>
#include <voussoir/algebra/linear/multigrid.h>
#include <voussoir/algebra/linear/near_componentwise.h>
#include <voussoir/algebra/linear/rotation_complement.h>
#include <voussoir/algebra/linear/substructures.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/parallel/begin_mpi.h>

#include <limits>
#include <utility>

namespace Voussoir
{
namespace
{
/**
 * The number of bodies of a process from which multigrid solves the system of
 * all unknowns. Below, Cholesky's factorisation is faster; its time and
 * memory grow faster.
 */
constexpr unsigned int n_bodies_for_multigrid = 4000000;

/** The bodies from which multigrid serves one component, whose factors CHOLMOD
 * could not count. */
constexpr unsigned int n_bodies_for_multigrid_of_one = 20000000;

/**
 * The entries of the factors from which multigrid serves blocks in space, whose
 * factors grow faster than those of the plane: 10 GB. Of 50,000 random cells
 * that turn the factors take 8 GB and 0.8 of the time of multigrid; of 100,000
 * bricks of a wall, where multigrid takes ten times as long since joints open,
 * they take 2 GB.
 */
constexpr double n_entries_for_multigrid = 1.25e9;

/**
 * The number of unknowns that couple the parts of several processes from which
 * multigrid takes over: their dense Schur complement, which the root
 * factorises, then takes 2 s (measured, on one core) and 0.3 GB.
 */
constexpr unsigned int n_couplings_for_multigrid = 6000;
} // namespace

void add_linear_solver(dealii::ParameterHandler &prm, LinearSolver &solver)
{
  add_choice<LinearSolver>(
      prm, "Linear solver", solver,
      {{LinearSolver::automatic, "automatic",
        "the faster one at the size of the packing."},
       {LinearSolver::direct, "direct", "CHOLMOD's Cholesky factorisation."},
       {LinearSolver::multigrid, "multigrid",
        "conjugate gradients with Trilinos' algebraic multigrid ML."}},
      "How the linear systems of Newton's method are solved.");
}

JointSystem::JointSystem(const Structure &structure,
                         const LinearSolver kind,
                         const double residual)
    : structure(structure), kind(kind),
      residual(structure.is_plane() && !structure.has_blocks() &&
                       !structure.kinematics().turns() &&
                       structure.processes().size() == 1
                   ? residual
                   : 0.)
{
  timer.reset();
}

std::unique_ptr<LinearMethod> JointSystem::make(const bool apart) const
{
  const JointBlocks blocks(structure, apart);
  const ProcessGroup &processes = structure.processes();
  const bool is_shared = processes.size() > 1;
  bool direct = kind == LinearSolver::direct;
  if (kind == LinearSolver::automatic)
  {
    const unsigned int n_couplings =
        blocks.n() *
        processes.sum(is_shared ? Substructures::n_coupling_bodies(structure)
                                : 0);
    direct =
        n_couplings < n_couplings_for_multigrid &&
        processes.max(structure.n_own_bodies()) <
            (apart ? n_bodies_for_multigrid_of_one : n_bodies_for_multigrid);
  }
  if (direct && is_shared)
    return std::make_unique<Substructures>(blocks);
  if (direct)
  {
    auto cholesky = std::make_unique<Cholesky>(blocks);
    if (kind == LinearSolver::direct || structure.is_plane() ||
        cholesky->n_entries() < n_entries_for_multigrid)
      return cholesky;
  }
  begin_mpi();
  return std::make_unique<Multigrid>(blocks);
}

bool JointSystem::comes_apart(const JointStiffnesses &coefficients) const
{
  if (residual > 0.)
    return NearComponentwise::serves(structure, coefficients.of_rows);
  // In space rotations have three components, which nothing here takes apart.
  const bool serves = structure.is_plane() || !structure.kinematics().turns();
  return serves && structure.processes().all(coefficients.are_isotropic);
}

std::unique_ptr<LinearMethod> JointSystem::make_componentwise() const
{
  auto translations =
      std::make_unique<Componentwise>(make(true), structure.n_translations());
  if (residual > 0.)
    return std::make_unique<NearComponentwise>(
        structure, std::move(translations), residual);
  if (!structure.kinematics().turns())
    return translations;
  return std::make_unique<RotationComplement>(structure,
                                              std::move(translations));
}

bool JointSystem::prepare(const JointStiffnesses &coefficients,
                          const double shift)
{
  timer.start();
  bool is_prepared;
  if (!coupled && comes_apart(coefficients))
  {
    if (!componentwise)
      componentwise = make_componentwise();
    current = componentwise.get();
    is_prepared = current->prepare(coefficients.of_rows, shift);
    if (structure.kinematics().turns() || residual > 0.)
      prepared = {coefficients.of_rows, shift};
  }
  else
    is_prepared = prepare_coupled(coefficients.of_rows, shift);
  timer.stop();
  return is_prepared;
}

bool JointSystem::prepare_coupled(const std::vector<double> &coefficients,
                                  const double shift)
{
  if (!coupled)
  {
    // From now on the factors of all unknowns serve all systems.
    componentwise.reset();
    coupled = make(false);
  }
  current = coupled.get();
  return current->prepare(coefficients, shift);
}

bool JointSystem::is_direct() const
{
  return current->is_direct();
}

double JointSystem::seconds() const
{
  return timer.wall_time();
}

std::vector<double> JointSystem::solve(const std::vector<double> &r)
{
  timer.start();
  const std::vector<double> of_own(r.begin(),
                                   r.begin() + structure.n_own_dofs());
  std::vector<double> u = current->solve(of_own, 1);
  if (!structure.processes().all(u.size() == of_own.size()))
  {
    const bool is_prepared =
        prepare_coupled(prepared.coefficients, prepared.shift);
    u = is_prepared
            ? current->solve(of_own, 1)
            : std::vector<double>(of_own.size(),
                                  std::numeric_limits<double>::quiet_NaN());
  }
  u.resize(structure.n_dofs());
  structure.update_ghosts(u);
  timer.stop();
  return u;
}
} // namespace Voussoir
