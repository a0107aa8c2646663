// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_tests_algebra_disc_joint_h
#define voussoir_tests_algebra_disc_joint_h

#include <voussoir/algebra/newton.h>

#include "tests.h"

// Bodies in space on joints with contacts and a disc of friction, for tests.

namespace Voussoir
{
using Vector3 = dealii::Tensor<1, 3>;

inline const Kinematics in_space("translations in space", 3, 0);
inline const Kinematics turning_in_space("rotations in space", 3, 3);

inline Vector3 vector(const double x, const double y, const double z)
{
  Vector3 v;
  v[0] = x;
  v[1] = y;
  v[2] = z;
  return v;
}

inline std::array<double, 3> numbers(const Vector3 &v)
{
  return {{v[0], v[1], v[2]}};
}

/** The row of a point, from the centres of c- and c+. */
inline ContactRow row(const Vector3 &direction,
                      const Vector3 &from_minus = Vector3(),
                      const Vector3 &from_plus = Vector3())
{
  return {numbers(direction), numbers(cross_product_3d(from_minus, direction)),
          numbers(cross_product_3d(from_plus, direction))};
}

/** Any two tangents of a normal. */
inline std::array<Vector3, 2> tangents(const Vector3 &normal)
{
  const Vector3 other =
      std::abs(normal[0]) < 0.7 ? vector(1., 0., 0.) : vector(0., 1., 0.);
  Vector3 first = cross_product_3d(normal, other);
  first /= first.norm();
  return {{first, cross_product_3d(normal, first)}};
}

/**
 * Elastic joints: contacts in sets of one row, which share the stiffness, and
 * sliding in a disc of two rows, up to the strength.
 */
class DiscJoint : public JointLaw
{
public:
  explicit DiscJoint(const Structure &structure) : structure(structure) {}

  void find_forces(const unsigned int e,
                   const double *jumps,
                   double *forces) const override
  {
    const double k = structure.joints()[e].stiffness();
    structure.for_each_set(
        e, [&](const unsigned int size, const unsigned int r, unsigned int) {
          if (size == 1)
          {
            forces[r] = k / n_contacts(e) * std::min(jumps[r], 0.);
            return;
          }
          const double force = k * std::hypot(jumps[r], jumps[r + 1]);
          const double share = std::min(1., structure.limit(e) / force);
          for (unsigned int i = 0; i < 2; ++i)
            forces[r + i] = (force > 0. ? share : 1.) * k * jumps[r + i];
        });
  }

  bool find_second_derivatives(const unsigned int e,
                               const double *jumps,
                               double *second) const override
  {
    const double k = structure.joints()[e].stiffness();
    bool all = true, has_disc = false;
    structure.for_each_set(e, [&](const unsigned int size, const unsigned int r,
                                  const unsigned int first) {
      double *block = second + first;
      if (size == 1)
      {
        block[0] = jumps[r] <= 0. ? k / n_contacts(e) : 0.;
        all &= jumps[r] <= 0.;
        return;
      }
      has_disc = true;
      const double length = std::hypot(jumps[r], jumps[r + 1]);
      const bool slides = k * length > structure.limit(e);
      all &= !slides;
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j)
        {
          const double one = i == j ? 1. : 0.;
          block[2 * i + j] =
              slides ? structure.limit(e) / length *
                           (one - jumps[r + i] / length * jumps[r + j] / length)
                     : k * one;
        }
    });
    return all && has_disc && !structure.is_plane();
  }

private:
  unsigned int n_contacts(const unsigned int e) const
  {
    unsigned int n = 0;
    structure.for_each_set(e, [&](const unsigned int size, unsigned int,
                                  unsigned int) { n += size == 1 ? 1 : 0; });
    return n;
  }

  const Structure &structure;
};

/** A part with a joint of as many contacts, and with or without friction. */
inline void add_joint(Structure::Part &part,
                      const Structure::Joint &joint,
                      const Vector3 &normal,
                      const std::vector<Vector3> &points,
                      const bool has_friction)
{
  const Vector3 &minus = part.centres[joint.cell_minus],
                &plus = part.centres[joint.cell_plus];
  std::vector<ContactRow> rows;
  std::vector<unsigned int> sets(points.size(), 1);
  Vector3 mean;
  for (const Vector3 &x : points)
  {
    rows.push_back(row(normal, x - minus, x - plus));
    mean += 1. / points.size() * x;
  }
  if (has_friction)
  {
    for (const Vector3 &t : tangents(normal))
      rows.push_back(row(t, mean - minus, mean - plus));
    sets.push_back(2);
  }
  part.joints.add(joint, rows, part.kinematics, sets);
}

/** Newton's method from rest. */
Newton
solved(const Structure &structure, const JointLaw &law, JointSystem &system)
{
  Newton newton(structure, law, system,
                std::vector<double>(structure.n_dofs(), 0.));
  while (newton.imbalance() > 1e-13 && newton.n_iterations() < 200)
    newton.step(least_shift, newton.u());
  return newton;
}
} // namespace Voussoir

#endif
