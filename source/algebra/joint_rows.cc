// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/joint_rows.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>

namespace Voussoir
{
void JointRows::add(const Joint &joint,
                    const std::vector<ContactRow> &rows,
                    const Kinematics &kinematics,
                    const std::vector<unsigned int> &sets,
                    const std::vector<double> &shares_of_sets)
{
  shares.insert(shares.end(), shares_of_sets.begin(), shares_of_sets.end());
  Assert(first_row.back() + std::uint64_t(rows.size()) <
             std::numeric_limits<unsigned int>::max(),
         dealii::ExcMessage("There are too many rows."));
  const bool has_block = std::any_of(sets.begin(), sets.end(),
                                     [](const auto size) { return size > 1; });
  if (has_block && first_set.empty())
  {
    // So far each row has been a set with one coefficient.
    set_sizes.assign(first_row.back(), 1);
    first_set = first_coefficient = first_row;
  }
  if (!first_set.empty())
    add_sets(sets.empty() ? std::vector<unsigned int>(rows.size(), 1) : sets,
             rows.size());
  list.push_back(joint);
  first_row.push_back(first_row.back() + rows.size());
  const unsigned int T = kinematics.n_translations();
  const unsigned int R = kinematics.n_rotations();
  for (const ContactRow &row : rows)
  {
    for (unsigned int i = 0; i < T; ++i)
      direction.push_back(row.direction[i]);
    for (unsigned int i = 0; i < R; ++i)
    {
      turn_minus.push_back(row.turn_minus[i]);
      turn_plus.push_back(row.turn_plus[i]);
    }
  }
}

void JointRows::add_sets(const std::vector<unsigned int> &sets,
                         const std::size_t n_rows)
{
  AssertDimension(std::accumulate(sets.begin(), sets.end(), std::size_t(0)),
                  n_rows);
  (void)n_rows;
  unsigned int n_coefficients = first_coefficient.back();
  for (const unsigned int size : sets)
    n_coefficients += size * size;
  set_sizes.insert(set_sizes.end(), sets.begin(), sets.end());
  first_set.push_back(set_sizes.size());
  first_coefficient.push_back(n_coefficients);
}

void JointRows::reserve(const std::size_t n_joints,
                        const std::size_t n_rows,
                        const Kinematics &kinematics)
{
  list.reserve(n_joints);
  first_row.reserve(n_joints + 1);
  direction.reserve(n_rows * kinematics.n_translations());
  turn_minus.reserve(n_rows * kinematics.n_rotations());
  turn_plus.reserve(n_rows * kinematics.n_rotations());
}
} // namespace Voussoir
