// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/cholesky.h>
#include <voussoir/algebra/joint_system.h>
#include <voussoir/algebra/multigrid.h>
#include <voussoir/algebra/substructures.h>

#include <algorithm>

namespace Voussoir
{
namespace
{
/**
 * The number of bodies of a process from which multigrid solves the system of
 * both components. Below, Cholesky's factorisation is faster; its time and
 * memory grow faster.
 */
constexpr unsigned int n_bodies_for_multigrid = 1000000;

/** The same for one component, whose factors CHOLMOD could not count. */
constexpr unsigned int n_bodies_for_multigrid_of_one = 20000000;

/**
 * The number of unknowns that couple the parts of several processes from which
 * multigrid takes over: their dense Schur complement, which the root
 * factorises, then takes 2 s (measured, on one core) and 0.3 GB.
 */
constexpr unsigned int n_couplings_for_multigrid = 6000;
} // namespace

JointSystem::JointSystem(const Structure &structure, const LinearSolver kind)
    : structure(structure), kind(kind)
{
  timer.reset();
}

std::unique_ptr<LinearMethod>
JointSystem::make(const unsigned int n_components) const
{
  const Team &team = structure.team();
  const bool is_shared = team.size() > 1;
  bool direct = kind == LinearSolver::direct;
  if (kind == LinearSolver::automatic)
  {
    const unsigned int n_couplings =
        n_components *
        team.sum(is_shared ? Substructures::n_coupling_bodies(structure) : 0);
    direct = n_couplings < n_couplings_for_multigrid &&
             team.max(structure.n_own_bodies()) <
                 (n_components == 1 ? n_bodies_for_multigrid_of_one
                                    : n_bodies_for_multigrid);
  }

  if (!direct)
    return std::make_unique<Multigrid>(structure, n_components);
  if (is_shared)
    return std::make_unique<Substructures>(structure, n_components);
  return std::make_unique<Cholesky>(structure, n_components);
}

bool JointSystem::prepare(const std::vector<Structure::Jump> &coefficients,
                          const double shift)
{
  timer.start();
  const bool apart = structure.team().all(std::all_of(
      coefficients.begin(), coefficients.end(),
      [](const Structure::Jump &a) { return a.normal == a.tangential; }));
  std::unique_ptr<LinearMethod> &method = methods[apart ? 0 : 1];
  if (!method)
    method = make(apart ? 1 : 2);
  current = method.get();
  const bool is_prepared = current->prepare(coefficients, shift);
  timer.stop();
  return is_prepared;
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
  std::vector<double> u = current->solve(r);
  structure.update_ghosts(u);
  timer.stop();
  return u;
}
} // namespace Voussoir
