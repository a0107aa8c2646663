// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/linear/joint_blocks.h>

namespace Voussoir
{

void JointBlocks::find(const unsigned int e,
                       const double *coefficients,
                       Blocks &blocks) const
{
  const unsigned int n_rows = structure->n_rows();
  const double *a = coefficients + std::size_t(e) * n_rows;
  if (unknowns == 1)
  {
    blocks.minus[0] = blocks.plus[0] = a[n_rows - 1];
    blocks.mixed[0] = -a[n_rows - 1];
    return;
  }
  blocks = {};
  for (unsigned int r = 0; r < n_rows; ++r)
    add(structure->row(e, r), a[r], blocks);
}

void JointBlocks::add(const ContactRow &row,
                      const double a,
                      Blocks &blocks) const
{
  const dealii::Tensor<1, 2> &d = row.direction;
  const double plus[] = {d[0], d[1], row.turn_plus};
  const double minus[] = {-d[0], -d[1], -row.turn_minus};
  for (unsigned int i = 0; i < unknowns; ++i)
    for (unsigned int j = 0; j < unknowns; ++j)
    {
      const unsigned int k = i * unknowns + j;
      blocks.minus[k] += a * minus[i] * minus[j];
      blocks.plus[k] += a * plus[i] * plus[j];
      blocks.mixed[k] += a * plus[i] * minus[j];
    }
}

} // namespace Voussoir
