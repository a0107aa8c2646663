// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_ranges_state_polytope_h
#define voussoir_analyses_ranges_state_polytope_h

#include <voussoir/scene/scene.h>
#include <voussoir/statics/problem/discrete_problem.h>

#include <array>
#include <cstddef>
#include <vector>

namespace Voussoir
{
/**
 * The admissible states of a scene as a polytope: vectors x of nondimensional
 * forces, those of the rows of each joint as in Structure, that balance the
 * loads and are within the limits() of the joints.
 */
class StatePolytope
{
public:
  /** A limit of one joint: outward . x of its rows is at most value. */
  struct Limit
  {
    /** The joint. */
    unsigned int joint;
    /** The number of its first row among all. */
    std::size_t first;
    /** The number of its rows. */
    unsigned int n_rows;
    /** The coefficients of its rows; zero beyond the last. */
    std::array<double, 3> outward;
    /** The largest value. */
    double value;
  };

  /** @param scene whose joints bear pressure alone, of any size. */
  explicit StatePolytope(const Scene &scene);

  /** The bodies, loads and rows, without the limits. */
  const DiscreteProblem &problem() const { return unlimited; }
  /** The number of all forces. */
  std::size_t n_forces() const { return unlimited.n_all_rows(); }
  /** Pressure, and the friction of joints that have any. */
  const std::vector<Limit> &limits() const { return all_limits; }
  /** What outward . d of @p limit is. */
  double along(const Limit &limit, const std::vector<double> &d) const
  {
    const double *of_joint = &d[limit.first];
    double sum = 0.;
    for (unsigned int r = 0; r < limit.n_rows; ++r)
      sum += limit.outward[r] * of_joint[r];
    return sum;
  }
  /** How far @p x is inside of @p limit. */
  double room(const Limit &limit, const std::vector<double> &x) const
  {
    return limit.value - along(limit, x);
  }

private:
  const DiscreteProblem unlimited;
  std::vector<Limit> all_limits;
};
} // namespace Voussoir

#endif
