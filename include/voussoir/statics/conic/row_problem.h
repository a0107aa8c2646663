// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_conic_row_problem_h
#define voussoir_statics_conic_row_problem_h

#include <voussoir/statics/conic/conic_forces.h>
#include <voussoir/statics/conic/force_rows.h>
#include <voussoir/statics/problem/mechanism.h>

#include <optional>
#include <utility>
#include <vector>

namespace Voussoir
{
/** The displacement of the cells of a problem in @p u of its rows, of any size,
 * as Mechanism::u. */
std::vector<double> displacement_of_size_one(const DiscreteProblem &problem,
                                             std::vector<double> u);

/** The mechanism @p u, of the bodies of the rows and of any size; none if the
 * loads do no more work than the forces of the rows resist. */
std::optional<Mechanism> mechanism_by_rows(const ForceRows &rows,
                                           std::vector<double> u);

/** The joints of a problem by rows whose forces have bounds only. */
class RowProblem
{
public:
  /** @param problem must outlive this object. */
  explicit RowProblem(const DiscreteProblem &problem);

  /** The problem. */
  const DiscreteProblem &of() const { return problem; }
  /** Its rows. */
  const ForceRows &rows() const { return of_rows; }
  /** Their forces; the ground and one cell of each group are held. */
  ConicForces &forces() { return of_forces; }
  /** The forces of the rows. */
  const ConicForces &forces() const { return of_forces; }
  /** The loads of the rows, without those on held bodies. */
  std::vector<double> loads() const;
  /**
   * The loads of the rows with other loads on the bodies of the problem,
   * n_dofs() numbers, and @p with_offset for those of ForceRows::offset().
   */
  std::vector<double> loads(std::vector<double> of_problem,
                            bool with_offset) const;
  /** The displacement of the cells in @p u, of any size, as Mechanism::u. */
  std::vector<double> of_size_one(std::vector<double> u) const
  {
    return displacement_of_size_one(problem, std::move(u));
  }

private:
  const DiscreteProblem &problem;
  ForceRows of_rows;
  ConicForces of_forces;
};
} // namespace Voussoir

#endif
