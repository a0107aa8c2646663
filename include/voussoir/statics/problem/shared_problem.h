// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_problem_shared_problem_h
#define voussoir_statics_problem_shared_problem_h

#include <voussoir/statics/problem/discrete_problem.h>
#include <voussoir/statics/problem/mechanism.h>
#include <voussoir/statics/problem/solution.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace Voussoir
{
/**
 * A problem that the processes of a group solve together. The root has the
 * whole and keeps it; each has a part: as many cells as the others, by
 * recursive coordinate bisection of their centres. The ground is the root's: a
 * body that couples to later processes, so that only it does, and not all that
 * rests on it. Questions on the whole are answered by the root.
 *
 * Alone, a process works on the whole itself.
 */
class SharedProblem
{
public:
  /** Those of @p processes that are worth it: all, or the root alone where
   * communication would outweigh computation. */
  static ProcessGroup helpers(const DiscreteProblem &whole,
                              const ProcessGroup &processes);

  /** For this process alone; @p whole must outlive this object. */
  explicit SharedProblem(const DiscreteProblem &whole);
  SharedProblem(DiscreteProblem &&) = delete;

  /**
   * Share out what the root has, no fewer cells than processes; collective.
   *
   * @param whole on the root; none on the others.
   */
  SharedProblem(const DiscreteProblem *whole, const ProcessGroup &processes);

  /** The part of this process. */
  const Structure &structure() const { return part ? *part : *whole; }

  /** A number of a joint of the whole. */
  using NumberOfJoint =
      std::function<double(const DiscreteProblem &, unsigned int e)>;
  /** What the root finds for each joint of structure(); collective. */
  std::vector<double> of_joints(const NumberOfJoint &find) const;

  /** A displacement of the whole, n_dofs() numbers. */
  using Finder = std::function<std::vector<double>(const DiscreteProblem &)>;
  /** This process' part of what the root is to @p find; collective. */
  std::vector<double> displacement(const Finder &find) const;
  /** This process' part of the displacement of opening_of(); collective. */
  std::vector<double> opening() const;
  /** True if opening_of() has one; collective. */
  bool has_opening() const;

  /** A search for a mechanism near a displacement of the whole. */
  using Search = std::function<std::optional<Mechanism>(
      const DiscreteProblem &, const std::vector<double> &)>;
  /**
   * Look for a mechanism by @p how on the root, as by find_mechanism() with all
   * of @p u; collective. There is one for all processes or for none; what it
   * is, the root knows.
   */
  std::optional<Mechanism> search(const std::vector<double> &u,
                                  const Search &how) const;

  /**
   * The parts of all processes, in the order of the whole, on the root, and
   * nothing on the others; collective.
   *
   * @param u the displacement, n_dofs() numbers of structure().
   * @param forces of each row of each joint of structure().
   * @param solution takes forces and displacement.
   */
  void collect(const std::vector<double> &u,
               const std::vector<double> &forces,
               Solution &solution) const;

private:
  /** Do that on the root; a SolverError is thrown on all processes. */
  template <typename Action>
  void on_root(const Action &action) const;
  void cut();
  Structure::Part make_part(unsigned int process) const;
  std::vector<double> gather(const std::vector<double> &u) const;
  std::vector<double> scatter(const std::vector<double> &u) const;

  const DiscreteProblem *whole;
  ProcessGroup processes;
  /** None if this process is alone. */
  std::unique_ptr<const Structure> part;

  // On the root, if it is not alone:
  /** The bodies in the order of the processes, and where each of them begins.*/
  std::vector<unsigned int> bodies, first_body;
  /** The place of each body in that order. */
  std::vector<unsigned int> number;
  /** The joints of each process. */
  std::vector<std::vector<unsigned int>> joints_of;
};
} // namespace Voussoir

#endif
