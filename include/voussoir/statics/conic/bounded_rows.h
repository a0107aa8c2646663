// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_conic_bounded_rows_h
#define voussoir_statics_conic_bounded_rows_h

#include <voussoir/statics/problem/discrete_problem.h>

#include <cstddef>
#include <vector>

namespace Voussoir
{
/**
 * The places at which joints that crush are cut into strips, n_strips() of each
 * joint: strip k is from place k to k + 1, from the start of the joint, 0, to
 * its end, 1.
 */
struct Strips
{
  /** Equal ones. */
  Strips(std::size_t n_joints, unsigned int n_strips);
  /** The number of strips of a joint. */
  unsigned int n_strips() const { return n; }
  /** The places of joint @p e, n_strips() + 1 of them. */
  const double *of(const unsigned int e) const
  {
    return &places[std::size_t(e) * (n + 1)];
  }
  /**
   * Cut joint @p e at @p place and closely beside it, and coarsely elsewhere:
   * the first time as if the place were known to one of the equal strips, and
   * then more closely each time, unless the place has moved.
   */
  void cut_at(unsigned int e, double place);

private:
  unsigned int n;
  std::vector<double> places;
  /** The last place of cut_at() in each joint, and how far its cuts reach. */
  struct Cut
  {
    double place = 0., reach = 0.;
  };
  std::vector<Cut> last_cut;
};

/**
 * The joints of a structure by rows whose forces have nothing but bounds.
 *
 * Tresca's friction has rows that are such. With Coulomb's, |q| <= c|e| + mu
 * sum_k p_k with p_k >= 0 are the forces with
 *
 *     p_k = l_k' + l_k'',  q = q_0 + mu sum_k (l_k' - l_k''),
 *
 * l_k', l_k'' >= 0 and |q_0| <= c|e|: each contact has the rows n_k + mu t_k
 * and n_k - mu t_k, the extreme rays of the cone.
 *
 * A joint that crushes is cut into strips, each of which carries a stress
 * between -f_t and f_c at its midpoint. The forces of some strips are those of
 * the section if its stress changes at a cut, and else a little less: see
 * cuts_for(). Where friction grows with pressure besides, a body without weight
 * is between the strips and the rays.
 *
 * Tension has the forces f_t |e| as another origin: see offset().
 */
class BoundedRows : public Structure
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
   * The loads are those of the problem and offset().
   *
   * @param problem has the joints; it must outlive this object.
   * @param strips of joints that crush; it must outlive this object.
   */
  BoundedRows(const DiscreteProblem &problem, const Strips &strips);

  /** The bounds of each row. */
  const std::vector<Bounds> &bounds() const { return of_rows; }
  /** Of each row of each joint of the structure, from those of these rows. */
  std::vector<double> forces_of(const std::vector<double> &x) const;
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
   * The share of row @p r in the normal stiffness of joint @p e, and in its
   * tensile strength, of a problem with Tresca's friction.
   */
  double share(unsigned int e, unsigned int r) const;
  /** True if joints are cut into several strips, so that others may serve. */
  bool has_strips() const;
  /** The strips with cuts where @p u neither opens nor closes joints. */
  Strips cuts_for(const std::vector<double> &u) const;

private:
  bool has_cone(const unsigned int e) const
  {
    return problem.joints()[e].coefficient > 0.;
  }
  bool crushes(unsigned int e) const;
  /** The joint here that has the strips of joint @p e of the problem. */
  unsigned int with_strips(const unsigned int e) const
  {
    return first[e] + has_cone(e);
  }
  /** The midpoint of a strip. */
  double middle(unsigned int e, unsigned int strip) const;
  void add_rays(unsigned int e, unsigned int minus, unsigned int plus);
  void add_contacts_or_strips(unsigned int e);
  void add(const Joint &joint,
           const std::vector<ContactRow> &rows,
           double tangential);

  const DiscreteProblem &problem;
  const Strips &strips;
  /** For each joint of the problem, the first one here that stands for it. */
  std::vector<unsigned int> first;
  std::vector<Bounds> of_rows;
};
} // namespace Voussoir

#endif
