// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_paper_displacement_program_h
#define voussoir_statics_paper_displacement_program_h

#include <voussoir/algebra/convex_program.h>
#include <voussoir/statics/problem/solution.h>

#include <vector>

namespace Voussoir
{
/**
 * A ConvexProgram whose unknowns begin with the displacements of a
 * DiscreteProblem, n_dofs() numbers, and may go on with others.
 */
class DisplacementProgram : public ConvexProgram
{
public:
  /** The starting point; as many numbers as there are unknowns. */
  virtual std::vector<double> start() const = 0;

  /** The reason to stop after @p iteration; none to go on. */
  virtual Stop verdict(unsigned int /*iteration*/) { return {}; }
};

/**
 * Add row @p row of constraints: @p factor times the jump in row @p r of joint
 * @p e.
 */
void add_jump_entries(const DiscreteProblem &problem,
                      unsigned int e,
                      unsigned int r,
                      double factor,
                      unsigned int row,
                      std::vector<ConvexProgram::Entry> &entries);

/** Add those of the openings, each with the row of its number among all. */
void add_opening_entries(const DiscreteProblem &problem,
                         std::vector<ConvexProgram::Entry> &entries);

/**
 * Set of the @p forces, of each row of each joint, the normal ones.
 *
 * @param multipliers of the openings, and behind them possibly others.
 */
void set_normal_forces(const DiscreteProblem &problem,
                       const std::vector<double> &multipliers,
                       std::vector<double> &forces);

/** The result of solve_program(). */
struct ProgramResult
{
  /** Without forces, and with displacement zero. */
  Solution solution;
  /** The unknowns at which Ipopt stopped. */
  std::vector<double> x;
  /**
   * Of each constraint, not positive.
   *
   * The multiplier of [u]_e . n_e >= 0 is f_e^n = -p_e.
   */
  std::vector<double> multipliers;
};

/**
 * Solve @p program with Ipopt. In each connected group of cells one is held at
 * its start, since a translation changes nothing. The iterates are watched for
 * mechanisms; after many iterations without a minimum find_collapse() is asked.
 *
 * @param problem whose displacements are the first unknowns.
 * @param program to be solved.
 * @param controls of Ipopt; the unknowns held and loose are found here.
 * @param terminal sees the iterations.
 * @throws SolverError if Ipopt ends without a point and without a mechanism.
 * @throws std::bad_alloc if it has not enough memory.
 */
ProgramResult solve_program(const DiscreteProblem &problem,
                            DisplacementProgram &program,
                            IpoptControls controls,
                            Terminal &terminal);
} // namespace Voussoir

#endif
