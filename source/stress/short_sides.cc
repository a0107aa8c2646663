// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/stress/short_sides.h>

#include <cmath>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/** The torque of the forces on a cell about its centre; S L^2. */
double torque(const LoadedCell &cell)
{
  const Tensor<2, 2> moments = cell.moments();
  return moments[1][0] - moments[0][1];
}

/** The middle of a sub-cell, in weights of the ends of its side. */
Point<2> middle(const SubTriangulation::Quadrilateral &sub_cell)
{
  Point<2> middle;
  for (const SubTriangulation::Vertex &vertex : sub_cell)
    middle += 0.25 * Point<2>(vertex.a, vertex.b);
  return middle;
}

/** The sub-cell of a triangle that is nearest to a point, in weights. */
unsigned int nearest(const SubTriangulation &cut, const Point<2> &point)
{
  unsigned int result = 0;
  for (unsigned int k = 1; k < cut.of_triangle().size(); ++k)
    if (middle(cut.of_triangle()[k]).distance(point) <
        middle(cut.of_triangle()[result]).distance(point))
      result = k;
  return result;
}

SubCellStress mean(const SubCellStress &a, const SubCellStress &b)
{
  return {0.5 * (a.stress + b.stress), 0.5 * (a.divergence + b.divergence),
          0.5 * (a.skew + b.skew)};
}
} // namespace

ShortSides::ShortSides(const SubTriangulation &cut, const double shortest)
    : shortest(shortest), n_per_side(cut.of_triangle().size())
{
  // The spoke ends where the triangle before it does, and where the one after
  // it begins.
  for (const auto &sub_cell : cut.of_triangle())
  {
    const double along_spoke = middle(sub_cell)[0] + middle(sub_cell)[1];
    nearest_before.push_back(nearest(cut, {0., along_spoke}));
    nearest_after.push_back(nearest(cut, {along_spoke, 0.}));
  }
}

/**
 * Set corner_of and the corners: the vertices in a row that are nearer than the
 * shortest side to the first of them become one corner. It lies between the
 * first and the last, so that leave_out() shares out the force of a uniform
 * stress as the sides do.
 */
bool ShortSides::find_corners(const std::vector<Point<2>> &vertices)
{
  const unsigned int n = vertices.size();
  const double limit = shortest * std::sqrt(std::abs(signed_area(vertices)));
  // After a side that remains, unless there is none.
  unsigned int start = n;
  bool has_short = false;
  for (unsigned int i = 0; i < n; ++i)
    if (vertices[i].distance(vertices[(i + 1) % n]) < limit)
      has_short = true;
    else if (start == n)
      start = i + 1;
  if (!has_short)
    return false;

  std::vector<Point<2>> &corners = remains.vertices;
  corners.clear();
  corner_of.resize(n);
  Point<2> first;
  for (unsigned int k = 0; k < n; ++k)
  {
    const unsigned int i = (start + k) % n;
    if (k > 0 && vertices[i].distance(first) < limit)
      corners.back() = first + 0.5 * (vertices[i] - first);
    else
    {
      first = vertices[i];
      corners.push_back(first);
    }
    corner_of[i] = corners.size() - 1;
  }
  return corners.size() >= 3;
}

bool ShortSides::leave_out(const LoadedCell &cell)
{
  if (!find_corners(cell.vertices))
    return false;
  remains.centre = cell.centre;
  share_out_forces(cell);
  remains.shifts.clear();
  if (!cell.shifts.empty())
    keep_torque(cell);
  return true;
}

void ShortSides::share_out_forces(const LoadedCell &cell)
{
  const unsigned int n = corner_of.size(), n_corners = remains.vertices.size();
  remains.forces.assign(n_corners, Tensor<1, 2>());
  remains.body_forces.assign(n_corners, Tensor<1, 2>());
  for (unsigned int i = 0; i < n; ++i)
  {
    // Twice the same side if it remains.
    const unsigned int after = corner_of[i];
    const unsigned int before = corner_of[(i + 1) % n] == after
                                    ? (after + n_corners - 1) % n_corners
                                    : after;
    for (const unsigned int side : {before, after})
    {
      remains.forces[side] += 0.5 * cell.forces[i];
      remains.body_forces[side] += 0.5 * cell.body_forces[i];
    }
  }
}

/**
 * Keep the couples of the sides that remain. What they and the forces miss of
 * the torque becomes a couple on each, in proportion to the square of its
 * length: for a torque the least tractions. Nothing is missing under a uniform
 * stress.
 */
void ShortSides::keep_torque(const LoadedCell &cell)
{
  const unsigned int n_corners = remains.vertices.size();
  remains.shifts.assign(n_corners, Tensor<1, 2>());
  for (unsigned int i = 0; i < corner_of.size(); ++i)
    if (corner_of[(i + 1) % corner_of.size()] != corner_of[i])
      remains.shifts[corner_of[i]] = cell.shifts[i];

  double square = 0.;
  for (unsigned int i = 0; i < n_corners; ++i)
    square += remains.side(i).norm_square();
  const double factor = 2. / square * (torque(cell) - torque(remains));
  for (unsigned int i = 0; i < n_corners; ++i)
  {
    const Tensor<1, 2> side = remains.side(i);
    remains.shifts[i] += factor * Tensor<1, 2>({-side[1], side[0]});
  }
}

void ShortSides::fill(const std::vector<SubCellStress> &found,
                      const dealii::ArrayView<SubCellStress> &sub_cells) const
{
  const unsigned int n = corner_of.size(), n_corners = remains.vertices.size();
  AssertDimension(found.size(), n_corners * n_per_side);
  AssertDimension(sub_cells.size(), n * n_per_side);
  for (unsigned int i = 0; i < n; ++i)
  {
    const unsigned int after = corner_of[i];
    const unsigned int before = (after + n_corners - 1) % n_corners;
    const bool is_kept = corner_of[(i + 1) % n] != after;
    for (unsigned int k = 0; k < n_per_side; ++k)
      sub_cells[i * n_per_side + k] =
          is_kept ? found[after * n_per_side + k]
                  : mean(found[before * n_per_side + nearest_before[k]],
                         found[after * n_per_side + nearest_after[k]]);
  }
}
} // namespace Voussoir
