// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_extreme_rays_h
#define voussoir_statics_extreme_rays_h

#include <voussoir/algebra/structure.h>

#include <vector>

namespace Voussoir
{
/**
 * The joints of a structure by the extreme rays of their cones, so that only
 * bounds on forces are left.
 *
 * The forces |q| <= c|e| + mu sum_k p_k with p_k >= 0 are those with
 *
 *     p_k = l_k' + l_k'',  q = q_0 + mu sum_k (l_k' - l_k''),
 *
 * l_k', l_k'' >= 0 and |q_0| <= c|e|: each contact has the rows n_k + mu t_k
 * and n_k - mu t_k in the place of n_k, whose forces are not positive, and the
 * tangential row has the cohesion alone. The jumps in these rows are the
 * openings less mu times the sliding either way. If no joint has a
 * coefficient of friction all rows are those of the structure.
 */
class ExtremeRays : public Structure
{
public:
  /** @param joints of one process; its loads are left out. */
  explicit ExtremeRays(const Structure &joints);

  /** Of each row of each joint of the structure, from those of the rays. */
  std::vector<double> forces_of(const std::vector<double> &rays) const;

private:
  /** Contacts of the structure. */
  unsigned int n_points;
};
} // namespace Voussoir

#endif
