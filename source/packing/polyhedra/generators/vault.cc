// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/packing/polyhedra/generators/block_builder.h>
#include <voussoir/packing/polyhedra/generators/block_resolution.h>
#include <voussoir/packing/polyhedra/generators/vault.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace Voussoir
{
using dealii::Point;

namespace
{
/** The head joints of even rows and of odd ones, along y; lengths. */
std::array<std::vector<double>, 2> head_joints_of_rows(
    const Bond bond, const unsigned int n_in_row, const double length)
{
  std::array<std::vector<double>, 2> joints;
  const unsigned int end = quarters_in_stretcher * n_in_row;
  for (const unsigned int row : {0, 1})
    for (const unsigned int quarter : head_joints(bond, row, n_in_row))
      joints[row].push_back(length * quarter / end);
  return joints;
}

/** The sine of the angle by which a straight side turns in rounding at most. */
constexpr double straight = 1e-12;

/** Whether a corner only divides a side, as joints of rings do that of a pier.
 */
bool divides_side(const CellLoops &arch,
                  const unsigned int cell,
                  const unsigned int i)
{
  const unsigned int n = arch.n_sides(cell);
  const Point<2> &p = arch.vertices[arch.corner(cell, i)];
  const auto before = p - arch.vertices[arch.corner(cell, (i + n - 1) % n)];
  const auto after = arch.vertices[arch.corner(cell, (i + 1) % n)] - p;
  return before * after > 0. &&
         std::abs(before[0] * after[1] - before[1] * after[0]) <=
             straight * before.norm() * after.norm();
}

/**
 * The polygon of a cell of the arch, at a place along y, whose sides are whole:
 * a face may touch several blocks.
 */
BlockBuilder::Loop
section_of_vault(const CellLoops &arch, const unsigned int cell, const double y)
{
  BlockBuilder::Loop loop;
  for (unsigned int i = 0; i < arch.n_sides(cell); ++i)
  {
    if (divides_side(arch, cell, i))
      continue;
    const Point<2> &p = arch.vertices[arch.corner(cell, i)];
    loop.emplace_back(p[0], y, p[1]);
  }
  return loop;
}

/** The largest coordinate. */
double extent_of(const CellLoops &arch)
{
  double extent = 0.;
  for (const Point<2> &p : arch.vertices)
    extent = std::max({extent, std::abs(p[0]), std::abs(p[1])});
  return extent;
}

/** The shortest side of all cells. */
double shortest_side_of(const CellLoops &arch)
{
  double shortest = std::numeric_limits<double>::max();
  for (unsigned int c = 0; c < arch.n_cells(); ++c)
    for (unsigned int i = 0, n = arch.n_sides(c); i < n; ++i)
      shortest =
          std::min(shortest, arch.vertices[arch.corner(c, i)].distance(
                                 arch.vertices[arch.corner(c, (i + 1) % n)]));
  return shortest;
}
} // namespace

void VaultGenerator::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  arch.add_parameters(prm);
  prm.add_parameter("Length", length,
                    "Length of the vault along y, from 0 on; positive.",
                    Double(0.));
  prm.add_parameter("Blocks per row", n_in_row,
                    "Number of blocks along the vault, from which each "
                    "voussoir of the arch is made; 1 with stack bond for an "
                    "arch.",
                    Integer(1, 1000000));
  add_choice<Bond>(
      prm, "Bond", bond,
      {{Bond::running, "running",
        "every second row is shifted by half a block and has a half block at "
        "either end."},
       {Bond::stack, "stack",
        "the head joints of all rows are in one plane, so that the vault is "
        "a row of arches."}},
      "How the blocks of a row overlap those of the next.");
}

CellFaces VaultGenerator::generate(const std::filesystem::path &directory,
                                   Terminal &terminal) const
{
  check_measures("Packing/vault", {{"Length", length}});
  const CellLoops profile = arch.generate(directory, terminal);
  const unsigned int n_rows = profile.n_cells();
  check_number_of_cells(double(n_rows) * (n_in_row + 1.),
                        "'Packing/vault/Voussoirs', 'Abutments' and 'Blocks "
                        "per row'");
  check_resolution(
      "Packing/vault",
      {{"'Thickness', 'Voussoirs' and 'Abutments'", shortest_side_of(profile)},
       {"'Length' and 'Blocks per row'", length / (2. * n_in_row)}},
      std::max(extent_of(profile), length));

  const auto joints = head_joints_of_rows(bond, n_in_row, length);
  BlockBuilder builder(profile.group_names);
  builder.reserve_boxes(n_rows * (n_in_row + 1));
  for (unsigned int row = 0; row < n_rows; ++row)
  {
    const std::vector<double> &y = joints[arch.rank_of(row) % 2];
    for (unsigned int k = 0; k + 1 < y.size(); ++k)
      builder.add_frustum(section_of_vault(profile, row, y[k]),
                          section_of_vault(profile, row, y[k + 1]),
                          profile.group[row]);
  }
  return builder.take();
}
} // namespace Voussoir
