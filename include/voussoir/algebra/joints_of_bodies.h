// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_joints_of_bodies_h
#define voussoir_algebra_joints_of_bodies_h

#include <voussoir/algebra/structure.h>

#include <cstddef>
#include <vector>

namespace Voussoir
{
/**
 * The joints of each body of a structure: by them all cores sum forces on the
 * bodies, body by body.
 */
class JointsOfBodies
{
public:
  /** @param structure it must outlive this object. */
  explicit JointsOfBodies(const Structure &structure);
  /**
   * What Structure::add_jump_gradients() gives with zero to begin with, to the
   * last bit.
   *
   * @param factor of all forces.
   * @param forces of each row of each joint.
   * @return n_dofs() numbers.
   */
  std::vector<double> forces_on_bodies(double factor,
                                       const std::vector<double> &forces) const;

private:
  /** A joint, and whether the body is c+ of it. */
  struct Side
  {
    unsigned int joint;
    bool is_plus;
  };
  const Structure &structure;
  /** The number of the first side of each body, and at last of all. */
  std::vector<std::size_t> first;
  /** Of all bodies, by their joints. */
  std::vector<Side> sides;
};
} // namespace Voussoir

#endif
