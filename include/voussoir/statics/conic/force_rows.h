// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_conic_force_rows_h
#define voussoir_statics_conic_force_rows_h

#include <voussoir/statics/problem/discrete_problem.h>

#include <vector>

namespace Voussoir
{
/**
 * The joints of a structure by rows whose forces have bounds, but for those of
 * sections.
 *
 * Tresca's friction has rows that are such. With Coulomb's, |q| <= c|e| + mu
 * sum_k p_k with p_k >= 0 are the forces with
 *
 *     p_k = l_k' + l_k'',  q = q_0 + mu sum_k (l_k' - l_k''),
 *
 * l_k', l_k'' >= 0 and |q_0| <= c|e|: each contact has the rows n_k + mu t_k
 * and n_k - mu t_k, the extreme rays of the cone.
 *
 * Where blocks turn, a joint that crushes is a Section. Where friction grows
 * with pressure besides, a body without weight is between the rays and the
 * section.
 *
 * Tension has the forces f_t |e| as another origin: see offset().
 *
 * Smoothed friction of Tresca has an Arc.
 *
 * In space the rows are those of the problem: each pressure has a bound or,
 * with friction that grows with it, a FrictionCone, and each cell of friction a
 * Disc.
 */
class ForceRows : public Structure
{
public:
  /** The bounds of the force of a row, negative in compression. */
  struct Bounds
  {
    /** Not positive, possibly infinite. */
    double least;
    /** Not negative. */
    double greatest;
  };
  /**
   * The pressures p_1, p_2 >= 0 at both ends of a joint whose stress is
   * nowhere more than the strength f: with N = p_1 + p_2 and the moment M
   * about the middle, |M| <= N (f |e| - N) / (2 f), which is
   *
   *     N^2 <= 2 f |e| p_k,  k = 1, 2.
   *
   * The two rows have no bounds, and are one set.
   */
  struct Section
  {
    /** The first of the two rows among all. */
    unsigned int row;
    /** f |e|. */
    double strength;
  };

  /**
   * The tangential force q and what it leaves of the strength b: q^2 + w^2 <=
   * b^2. The two rows have no bounds, and are one set; w acts on no body.
   */
  struct Arc
  {
    /** The row of q among all; that of w is the next. */
    unsigned int row;
    /** b. */
    double strength;
  };
  /** In space: the tangential forces q of two rows, |q| <= b. */
  struct Disc
  {
    /** The first of the rows among all; they have no bounds. */
    unsigned int row;
    /** b. */
    double strength;
  };
  /** In space: a pressure p >= 0 and the tangential forces, |q| <= mu p. */
  struct FrictionCone
  {
    /** The row of the pressure among all, with those of q; without bounds. */
    unsigned int row;
    /** mu, positive. */
    double coefficient;
    /** The largest pressure, possibly infinite. */
    double strength;
  };

  /** What limits friction. */
  enum class Friction
  {
    /** Bounds. */
    bounded,
    /** Arcs, wherever there is friction. */
    in_arcs
  };

  /**
   * The loads are those of the problem and offset().
   *
   * @param problem has the joints; it must outlive this object.
   * @param friction of it; arcs for Tresca's alone.
   */
  explicit ForceRows(const DiscreteProblem &problem,
                     Friction friction = Friction::bounded);

  /** The bounds of each row. */
  const std::vector<Bounds> &bounds() const { return of_rows; }
  /** All sections. */
  const std::vector<Section> &sections() const { return all_sections; }
  /** All arcs. */
  const std::vector<Arc> &arcs() const { return all_arcs; }
  /** All discs. */
  const std::vector<Disc> &discs() const { return all_discs; }
  /** All cones of friction. */
  const std::vector<FrictionCone> &friction_cones() const { return all_cones; }
  /** The problem. */
  const DiscreteProblem &of() const { return problem; }
  /** Of each row of each joint of the structure, from those of these rows. */
  std::vector<double> forces_of(const std::vector<double> &x) const;
  /** In space: the x of these forces. */
  std::vector<double> rows_of(const std::vector<double> &forces) const;
  /**
   * Add @p factor times the coefficients of row @p r of joint @p e of the
   * structure, as a linear function of x, to @p c; see forces_of().
   */
  void add_force(unsigned int e,
                 unsigned int r,
                 double factor,
                 std::vector<double> &c) const;
  /**
   * The forces of the structure that belong to x = 0 on its bodies, n_dofs()
   * numbers, to be added to the loads.
   */
  std::vector<double> offset() const;
  /**
   * The most work that forces within their limits do on the jumps of all rows,
   * but for those that close or open what has no limit.
   */
  double dissipation_of_jumps(const std::vector<double> &jump) const;

private:
  bool has_cone(const unsigned int e) const
  {
    return problem.joints()[e].coefficient > 0.;
  }
  bool crushes(unsigned int e) const;
  /** The joint here that has the contacts of joint @p e of the problem. */
  unsigned int with_contacts(const unsigned int e) const
  {
    return first[e] + (has_cone(e) && crushes(e) ? 1 : 0);
  }
  void add_rays(unsigned int e, unsigned int minus, unsigned int plus);
  void add_contacts(unsigned int e, Friction friction);
  void add_sets(unsigned int e);
  std::vector<double> tension() const;

  const DiscreteProblem &problem;
  /** For each joint of the problem, the first one here that stands for it. */
  std::vector<unsigned int> first;
  std::vector<Bounds> of_rows;
  std::vector<Section> all_sections;
  std::vector<Arc> all_arcs;
  std::vector<Disc> all_discs;
  std::vector<FrictionCone> all_cones;
};
} // namespace Voussoir

#endif
