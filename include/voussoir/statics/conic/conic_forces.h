// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_conic_conic_forces_h
#define voussoir_statics_conic_conic_forces_h

#include <voussoir/algebra/joints_of_bodies.h>
#include <voussoir/algebra/linear/sparse_factor.h>
#include <voussoir/base/chunks.h>
#include <voussoir/statics/conic/force_rows.h>
#include <voussoir/statics/conic/quadratic_cone.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace Voussoir
{
/**
 * The forces x of rows with slacks s = h - B x in a product of half-lines and
 * second-order cones, what they add up to on the bodies, and the normal
 * equations of that. A x is the sum of forces on the bodies, and A^T u are
 * minus the jumps.
 *
 * What has a number for each slack has those of the bounds() first, and behind
 * them three for each of the cones().
 */
class ConicForces
{
public:
  /** A bound, sign times the force of a row at most the limit. */
  struct Bound
  {
    /** The number of the row among all. */
    unsigned int row;
    /** 1 or -1. */
    double sign;
    /** The largest value, not negative: zero is within all bounds. */
    double limit;
  };
  /** A cone of slacks of the two or three rows of one set. */
  struct Cone
  {
    /** The first of the rows among all. */
    unsigned int row;
    /** Their number. */
    unsigned int n_rows;
    /** h of the three slacks. */
    QuadraticCone::Vector limit;
    /**
     * The coefficients of B of each slack, as many as there are rows. With two
     * rows those of the head are zero, or those of the next one; with three B
     * is diagonal.
     */
    std::array<std::array<double, 3>, 3> b;
    /** The first coefficient of the set among all. */
    std::size_t coefficient = 0;
    /** The number of the bound that its first row has besides; -1: none. */
    int bound = -1;
  };
  /** What stands for the inverse of each slack's matrix in a linear system. */
  struct Weights
  {
    /** A number for each bound. */
    std::vector<double> of_bounds;
    /** W^-2 of each cone. */
    std::vector<QuadraticCone::Scaling> of_cones;
  };

  /**
   * @param rows must outlive this object.
   * @param held true for the bodies that do not move and need no balance.
   * @param curvature Q of each row, the second derivative of its cost; empty
   *   if that is linear.
   */
  ConicForces(const ForceRows &rows,
              std::vector<bool> held,
              std::vector<double> curvature = {});

  /** The rows. */
  const ForceRows &of() const { return rows; }
  /** True for the bodies that do not move. */
  const std::vector<bool> &held_bodies() const { return held; }
  /** Q of each row, or empty. */
  const std::vector<double> &curvature() const { return of_cost; }
  /** All bounds, in the order of the rows, of which each has up to two; behind
   * them those of cones, Cone::bound. */
  const std::vector<Bound> &bounds() const { return all_bounds; }
  /** All cones, two of each section, and one of each arc, disc and cone of
   * friction; by their rows. */
  const std::vector<Cone> &cones() const { return all_cones; }
  /** In the plane: the rows whose force may be anything, in order. */
  const std::vector<unsigned int> &without_limits() const
  {
    return rows_without_limits;
  }
  /** The number of slacks. */
  std::size_t n_slacks() const
  {
    return all_bounds.size() + 3 * all_cones.size();
  }
  /** The three slacks of a cone, of what has a number for each slack. */
  QuadraticCone::Vector of_cone(const std::vector<double> &v,
                                const std::size_t cone) const
  {
    const double *const of = &v[all_bounds.size() + 3 * cone];
    return {{of[0], of[1], of[2]}};
  }
  /** Set these three. */
  void set_cone(std::vector<double> &v,
                const std::size_t cone,
                const QuadraticCone::Vector &value) const
  {
    std::copy(value.begin(), value.end(),
              v.begin() + (all_bounds.size() + 3 * cone));
  }
  /**
   * Call @p f for each cone, by all cores: those of one
   * light_items_of_a_chunk, from a multiple of it on, by one and in order.
   */
  template <typename F>
  void for_each_cone(const F &f) const
  {
    for_chunks(
        all_cones.size(), light_items_of_a_chunk,
        [&](std::size_t, const std::size_t begin, const std::size_t end) {
          for (std::size_t k = begin; k < end; ++k)
            f(k);
        });
  }
  /** The largest of a number and of those of @p f of all cones, by all cores.
   */
  template <typename F>
  double largest_of_cones(const double at_least, const F &f) const
  {
    const std::size_t size = light_items_of_a_chunk;
    std::vector<double> of_chunks(n_chunks(all_cones.size(), size), at_least);
    for_each_cone([&](const std::size_t k) {
      double &largest = of_chunks[k / size];
      largest = std::max(largest, f(k));
    });
    return std::accumulate(
        of_chunks.begin(), of_chunks.end(), at_least,
        [](const double a, const double b) { return std::max(a, b); });
  }

  /** h of each slack. */
  std::vector<double> limits() const;
  /** A x, n_dofs() numbers; zero for held bodies. */
  std::vector<double> on_bodies(const std::vector<double> &x) const;
  /**
   * A^T u, one number a row, zero where there is no force; u is zero for held
   * bodies.
   */
  std::vector<double> along(const std::vector<double> &u) const;
  /** B x. */
  std::vector<double> at_slacks(const std::vector<double> &x) const;
  /** B^T z. */
  std::vector<double> of_rows(const std::vector<double> &z) const;
  /** Set what @p v has for rows without a force to zero. */
  void clear_without_force(std::vector<double> &v) const;
  /** Set what @p loads, n_dofs() numbers, has for held bodies to zero. */
  void clear_held(std::vector<double> &loads) const;

  /** Factorise by SparseFactor::avoid_blas(); to be called before prepare(). */
  void avoid_blas() { factor.avoid_blas(); }
  /**
   * Factorise A K A^T, with a relative shift of its diagonal that makes it
   * definite, and
   *
   *     K = (Q + B^T W^-2 B)^-1.
   *
   * In rows without_limits() K would be infinite, and is far above those of
   * bounds.
   *
   * @param with_curvature true if Q counts.
   * @param proximal is added to the diagonal of what is inverted, but for
   * cones and rows without limits.
   * @return false if no shift helps.
   */
  bool prepare(const Weights &weights,
               bool with_curvature = false,
               double proximal = 0.);
  /** prepare() for a diagonal K, one number a row; there are no cones then. */
  bool prepare_diagonal(std::vector<double> k);
  /** K r, of what is prepared; zero for rows without a force. */
  void multiply(std::vector<double> &r) const;
  /**
   * K (r - A^T u), where the difference is large across the limits of cones and
   * along them, where K is, next to none.
   */
  std::vector<double> multiplied_difference(const std::vector<double> &r,
                                            const std::vector<double> &u) const;
  /** Give that matrix a row and a column more, of loads @p f whose work is
   * given and whose factor is sought, until it is prepared again. */
  void set_border(std::vector<double> f);
  /** A solution with the border. */
  struct Bordered
  {
    /** The displacement, n_dofs() numbers. */
    std::vector<double> u;
    /** The factor of the loads; zero without a border. */
    double alpha;
  };
  /**
   * Solve, in several threads at once if need be,
   *
   *     A K A^T u - alpha f = right,  f . u = work,
   *
   * without the shift, by conjugate gradients among displacements in which f
   * does no work, which the factors precondition: where the only one that
   * hardly any force resists is a mechanism in which f does work, as near the
   * optimum of a factor, they do not see it (Gould, Hribar and Nocedal, *SIAM
   * Journal on Scientific Computing* 23 (2001), 1376).
   *
   * @param right n_dofs() numbers.
   * @param work ignored without a border.
   * @param enough the largest component of a residual to stop at.
   * @param n_gradients the largest number of steps.
   */
  Bordered solve(const std::vector<double> &right,
                 double work,
                 double enough,
                 unsigned int n_gradients) const;
  /** A K A^T times @p u. */
  std::vector<double> product(const std::vector<double> &u) const;

private:
  void find_coefficients();
  void find_rows_without_limits();
  bool factorise();
  double clear_border_work(std::vector<double> &u, double work) const;
  void invert_sets(const Weights &weights, bool with_curvature);
  void invert_set(std::size_t first,
                  std::size_t n,
                  const Weights &weights,
                  bool with_curvature,
                  double *block) const;
  void multiply_by_scalings(const std::vector<double> &d,
                            std::vector<double> &x) const;

  const ForceRows &rows;
  const std::vector<bool> held;
  const std::vector<double> of_cost;
  const JointsOfBodies joints_of_bodies;
  std::vector<Bound> all_bounds;
  std::vector<Cone> all_cones;
  /** Rows whose bounds are both zero. */
  std::vector<unsigned int> without_force;
  /** without_limits(). */
  std::vector<unsigned int> rows_without_limits;
  /** Of each row, or of each pair of a set: K. */
  std::vector<double> coefficients;
  /** In space without a curvature what is prepared: W of each cone, what is
   * added for its bound, zero if it has none, and K of the rows outside cones.
   */
  std::vector<QuadraticCone::Scaling> scalings;
  std::vector<double> of_their_bounds, outside_cones;
  SparseFactor factor;
  /** f, the solution for it without one, and the work of f in that. */
  std::vector<double> border, of_border;
  double work_of_border = 0.;
};
} // namespace Voussoir

#endif
