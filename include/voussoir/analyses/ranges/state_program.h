// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_ranges_state_program_h
#define voussoir_analyses_ranges_state_program_h

#include <voussoir/base/journal.h>
#include <voussoir/statics/conic/feasible_state.h>

#include <deque>
#include <memory>
#include <vector>

class ClpSimplex;

namespace Voussoir
{
/**
 * The linear programmes of all admissible states of a problem,
 *
 *     maximise    c . x
 *     subject to  A x + F = 0,  x within its bounds,
 *
 * which differ in c only, by Clp's simplex method: each starts from that state,
 * among those where the last ones ended, that has the most of its objective;
 * all are vertices of the same set.
 */
class StateProgram
{
public:
  /** @param problem must outlive this object and its copies. */
  explicit StateProgram(const RowProblem &problem);
  /** A copy with a state of its own to start from, for another thread. */
  StateProgram(const StateProgram &other);
  ~StateProgram();

  /**
   * Find a first state.
   *
   * @return false if Clp finds none.
   */
  bool find_state();

  /** What maximise() found. */
  struct Optimum
  {
    /** False if Clp found neither an optimum nor that there is none. */
    bool is_found = false;
    /** True if there is no greatest value: x is a ray. */
    bool is_unbounded = false;
    /** The forces of the rows: a vertex, or a ray that balances by itself. */
    std::vector<double> x;
    /**
     * The multipliers of the balance, ForceRows::n_dofs() numbers: a motion
     * that with the jumps c opens all joints without force.
     */
    std::vector<double> u;
  };
  /** Maximise @p c . x, one number for each row. */
  Optimum maximise(const std::vector<double> &c);

  /**
   * Let the forces on every body be out of balance by at most @p by in each
   * component: the multipliers of the next programmes are, among all that are
   * as good without, those whose sizes have the least sum, if that is small.
   */
  void loosen_balance(double by);

  /** Leave what the next ones could start from, if there are none. */
  void forget_vertices() { kept.clear(); }
  /** Let the next one start from the beginning, should a state be wrong. */
  void forget();

  /**
   * Start the next programme in a copy of @p first, from the last vertex: what
   * follows depends on nothing but where_it_is().
   */
  void renew(const StateProgram &first);
  /** @{ */
  /** Where it is, as it is kept in a Journal, and a renewed one from there. */
  Journal::Json where_it_is() const;
  void go_on(const Journal::Json &from, const StateProgram &first);
  /** @} */

  /** The number of steps of the simplex method. */
  unsigned int n_iterations() const { return iterations; }

private:
  struct Columns;
  /** The matrix of the balance, and the bounds of the forces. */
  Columns columns() const;
  /** Hand the programme to Clp. */
  void load(const Columns &columns, unsigned int n_rows);

  /** A state, and Clp's names of which of its forces are at their bounds. */
  struct Vertex
  {
    std::vector<double> x;
    std::vector<unsigned char> status;
  };
  void keep();
  void start_from(const Vertex &vertex);
  void start_from_best(const std::vector<double> &c);

  const RowProblem &problem;
  /** The row of each unknown in the programme; none for held bodies. */
  std::vector<unsigned int> row_of;
  std::unique_ptr<ClpSimplex> clp;
  /** Where the last programmes ended, the latest last. */
  std::deque<Vertex> kept;
  unsigned int iterations = 0;
};
} // namespace Voussoir

#endif
