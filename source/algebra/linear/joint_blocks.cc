// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/linear/joint_blocks.h>

#include <algorithm>

namespace Voussoir
{
namespace
{
/** A row as the unknowns of its two bodies see it. */
template <unsigned int n>
struct RowOfBodies
{
  std::array<double, n> minus, plus;
};

/** The arguments are those of a ContactRow. */
template <unsigned int T, unsigned int R>
RowOfBodies<T + R> of_bodies(const double *direction,
                             const double *turn_minus,
                             const double *turn_plus)
{
  RowOfBodies<T + R> of;
  for (unsigned int i = 0; i < T; ++i)
  {
    of.plus[i] = direction[i];
    of.minus[i] = -direction[i];
  }
  for (unsigned int i = 0; i < R; ++i)
  {
    of.plus[T + i] = turn_plus[i];
    of.minus[T + i] = -turn_minus[i];
  }
  return of;
}

/** Add a b c^T of two rows to the blocks. */
template <unsigned int n>
void add(const double a,
         const RowOfBodies<n> &b,
         const RowOfBodies<n> &c,
         JointBlocks::Blocks &blocks)
{
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
    {
      const unsigned int k = i * n + j;
      blocks.minus[k] += a * b.minus[i] * c.minus[j];
      blocks.plus[k] += a * b.plus[i] * c.plus[j];
      blocks.mixed[k] += a * b.plus[i] * c.minus[j];
    }
}

/** The coefficient of one component of what is isotropic. */
double isotropic(const Structure &structure,
                 const unsigned int e,
                 const double *coefficients)
{
  // The directions of rows have length one.
  double trace = 0.;
  structure.for_each_set(
      e, [&](const unsigned int size, unsigned int, const unsigned int first) {
        for (unsigned int i = 0; i < size; ++i)
          trace += coefficients[first + i * size + i];
      });
  return trace / structure.n_translations();
}
} // namespace

void JointBlocks::clear(Blocks &blocks) const
{
  for (Block *block : {&blocks.minus, &blocks.plus, &blocks.mixed})
    std::fill_n(block->begin(), unknowns * unknowns, 0.);
}

void JointBlocks::find(const unsigned int e,
                       const double *coefficients,
                       Blocks &blocks) const
{
  const double *a = coefficients + structure->first_coefficient(e);
  if (unknowns == 1)
  {
    blocks.minus[0] = blocks.plus[0] = isotropic(*structure, e, a);
    blocks.mixed[0] = -blocks.plus[0];
    return;
  }
  clear(blocks);
  structure->kinematics().dispatch([&](const auto T, const auto R) {
    const auto row_of_bodies = [&](const unsigned int r) {
      const std::size_t k = structure->first_row(e) + r;
      return of_bodies<T, R>(structure->direction(k), structure->turn_minus(k),
                             structure->turn_plus(k));
    };
    structure->for_each_set(e,
                            [&](const unsigned int size, const unsigned int row,
                                const unsigned int first) {
                              for (unsigned int i = 0; i < size; ++i)
                              {
                                const auto b = row_of_bodies(row + i);
                                if (size == 1)
                                  add<T + R>(a[first], b, b, blocks);
                                else
                                  for (unsigned int j = 0; j < size; ++j)
                                    add<T + R>(a[first + i * size + j], b,
                                               row_of_bodies(row + j), blocks);
                              }
                            });
  });
}

void JointBlocks::find(const ContactRow &row,
                       const double a,
                       Blocks &blocks) const
{
  AssertDimension(unknowns, structure->n_unknowns());
  clear(blocks);
  structure->kinematics().dispatch([&](const auto T, const auto R) {
    const auto b = of_bodies<T, R>(row.direction.data(), row.turn_minus.data(),
                                   row.turn_plus.data());
    add<T + R>(a, b, b, blocks);
  });
}

} // namespace Voussoir
