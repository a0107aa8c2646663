// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/joints_of_bodies.h>
#include <voussoir/base/chunks.h>

#include <array>
#include <numeric>

namespace Voussoir
{
JointsOfBodies::JointsOfBodies(const Structure &structure)
    : structure(structure), first(structure.n_bodies() + 1, 0),
      sides(2 * structure.joints().size())
{
  for (const Structure::Joint &joint : structure.joints())
  {
    ++first[joint.cell_minus + 1];
    ++first[joint.cell_plus + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (unsigned int e = 0; e < structure.joints().size(); ++e)
  {
    sides[next[structure.joints()[e].cell_minus]++] = {e, false};
    sides[next[structure.joints()[e].cell_plus]++] = {e, true};
  }
}

std::vector<double>
JointsOfBodies::forces_on_bodies(const double factor,
                                 const std::vector<double> &forces) const
{
  std::vector<double> sums(structure.n_dofs(), 0.);
  structure.kinematics().dispatch([&](const auto T, const auto R) {
    // As Structure::add_gradient() does for both bodies of a joint.
    const auto add = [&](const Side &side, double *const sum) {
      const std::size_t begin = structure.first_row(side.joint),
                        end = structure.first_row(side.joint + 1);
      const double *direction = structure.direction(begin);
      const double *turn = side.is_plus ? structure.turn_plus(begin)
                                        : structure.turn_minus(begin);
      std::array<double, T> of_joint = {};
      for (std::size_t k = begin; k < end; ++k, direction += T, turn += R)
      {
        const double force = factor * forces[k];
        for (unsigned int i = 0; i < T; ++i)
          of_joint[i] += force * direction[i];
        for (unsigned int i = 0; i < R; ++i)
          sum[T + i] += side.is_plus ? force * turn[i] : -(force * turn[i]);
      }
      for (unsigned int i = 0; i < T; ++i)
        sum[i] += side.is_plus ? of_joint[i] : -of_joint[i];
    };
    for_chunks(
        structure.n_bodies(), items_of_a_chunk,
        [&](std::size_t, const std::size_t begin, const std::size_t end) {
          for (std::size_t b = begin; b < end; ++b)
            for (std::size_t k = first[b]; k < first[b + 1]; ++k)
              add(sides[k], &sums[(T + R) * b]);
        });
  });
  return sums;
}
} // namespace Voussoir
