// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_energy_elastic_faces_h
#define voussoir_statics_energy_elastic_faces_h

#include <voussoir/algebra/linear/joint_system.h>
#include <voussoir/statics/problem/shared_problem.h>
#include <voussoir/statics/problem/solution.h>
#include <voussoir/terminal/terminal.h>

#include <string>
#include <vector>

namespace Voussoir
{
/** The controls of minimise_faces(); plain data. */
struct FaceOrder
{
  /** The method for its linear systems. */
  LinearSolver linear_solver;
  /** The largest imbalance to stop at, nondimensional. */
  double tolerance;
  /** The number of steps after which to give up, twice as many near the end. */
  unsigned int n_steps;
};

/** Where Newton's method has come to. */
struct FaceMinimum
{
  /** Forces and displacement; whether that is an answer is not judged. */
  Solution solution;
  /** The largest imbalance of a cell, nondimensional. */
  double imbalance;
};

/**
 * Minimise the energy of FaceJoint by Newton's method, to rounding if it gets
 * near; on the root, by all processes if there are enough cells for them.
 *
 * @param whole the problem, in space.
 * @param order the controls.
 * @param start n_dofs() numbers to start from.
 * @param processes those that help.
 * @param terminal sees the iterations.
 * @throws SolverError if there is not enough memory for a linear system.
 */
FaceMinimum minimise_faces(const DiscreteProblem &whole,
                           const FaceOrder &order,
                           const std::vector<double> &start,
                           const ProcessGroup &processes,
                           Terminal &terminal);

/** The name of this task, to which the root calls; see ProcessGroup::call(). */
inline const std::string faces_task = "faces";

/** The part of another process in minimise_faces(), once it is called to it. */
void work_on_faces(const ProcessGroup &processes, Terminal &terminal);
} // namespace Voussoir

#endif
