// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/base/text.h>
#include <voussoir/formula/integrals/triangle_integral.h>
#include <voussoir/packing/area_moments.h>
#include <voussoir/packing/convex_pieces.h>
#include <voussoir/scene/loads/body_force.h>

#include <algorithm>
#include <numeric>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
Patch box_of(const Packing<2> &packing, const unsigned int c)
{
  std::vector<Point<2>> vertices;
  for (unsigned int i = 0; i < packing.n_sides(c); ++i)
    vertices.push_back(packing.vertex(c, i));
  return box_around(vertices);
}

/** True if bounds allow values in a cell beyond those in its triangles. */
bool may_hide_a_peak(const std::vector<TriangleIntegral> &parts,
                     const Discontinuities &jumps,
                     const Packing<2> &packing,
                     const unsigned int c)
{
  if (!jumps.has_formulas())
    return false;
  std::array<Samples, 2> samples;
  for (const TriangleIntegral &part : parts)
    for (unsigned int i = 0; i < 2; ++i)
    {
      samples[i].add(part.samples[i].least);
      samples[i].add(part.samples[i].most);
    }
  return !cover(samples, jumps.bounds_in(box_of(packing, c), jumps.no_limits()),
                0.);
}

using Function = std::function<Tensor<1, 2>(const Point<2> &)>;

using Triangle = std::array<Point<2>, 3>;

/** Put into @p triangles those between a point and the sides of a polygon. */
void add_fan(const Point<2> &centre,
             const std::vector<Point<2>> &ring,
             std::vector<Triangle> &triangles)
{
  for (std::size_t i = 0; i < ring.size(); ++i)
    triangles.push_back({{centre, ring[i], ring[(i + 1) % ring.size()]}});
}

/**
 * Put into @p triangles those of a cell: between its centre and each side, or
 * if it cannot be seen whole from there, those of its convex pieces.
 */
void cut(const Packing<2> &packing,
         const unsigned int c,
         std::vector<Triangle> &triangles)
{
  triangles.clear();
  if (packing.is_seen_whole(c))
  {
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
      triangles.push_back({{packing.centre(c), packing.vertex(c, i),
                            packing.vertex(c, i + 1)}});
    return;
  }
  const std::vector<Point<2>> ring = ring_of(packing, c);
  for (const auto &piece : convex_pieces(ring))
  {
    std::vector<Point<2>> of_piece;
    for (const unsigned int v : piece)
      of_piece.push_back(ring[v]);
    add_fan(centroid(of_piece), of_piece, triangles);
  }
}

/**
 * Put into @p parts the integrals over the @p triangles of a cell, by one rule
 * each.
 *
 * @return true if nothing can be between its points, by one look at the whole
 *   cell, which is cheaper than one at each triangle.
 */
bool integrate_quickly(const Packing<2> &packing,
                       const unsigned int c,
                       const std::vector<Triangle> &triangles,
                       const Function &b,
                       const Discontinuities &jumps,
                       std::vector<TriangleIntegral> &parts)
{
  parts.clear();
  if (!jumps.empty() &&
      !jumps.crossings(box_of(packing, c), jumps.no_limits()).empty())
    return false;
  for (const Triangle &triangle : triangles)
  {
    const auto part = quick_triangle_integral(triangle, packing.centre(c), b);
    if (!part)
      return false;
    parts.push_back(*part);
  }
  return !may_hide_a_peak(parts, jumps, packing, c);
}

/** Integrate over a cell exactly, whatever it takes. */
void integrate(const Packing<2> &packing,
               const unsigned int c,
               const std::vector<Triangle> &triangles,
               const Function &b,
               const Discontinuities &jumps,
               std::vector<TriangleIntegral> &parts)
{
  parts.clear();
  for (const Triangle &triangle : triangles)
    parts.push_back(triangle_integral(triangle, packing.centre(c), b, jumps));
}
} // namespace

BodyForce::BodyForce(
    const Packing<2> &packing,
    const std::function<Tensor<1, 2>(const Point<2> &, unsigned int)> &b,
    const Discontinuities &jumps,
    Inaccuracies *const inaccuracies)
{
  std::vector<unsigned int> all(packing.n_cells());
  std::iota(all.begin(), all.end(), 0);
  add(packing, all, b, jumps, inaccuracies);
}

void BodyForce::add(
    const Packing<2> &packing,
    const std::vector<unsigned int> &cells,
    const std::function<Tensor<1, 2>(const Point<2> &, unsigned int)> &b,
    const Discontinuities &jumps,
    Inaccuracies *const inaccuracies)
{
  if (empty())
    allocate(packing);
  std::vector<TriangleIntegral> parts;
  std::vector<Triangle> triangles;
  for (const unsigned int c : cells)
  {
    const std::function<Tensor<1, 2>(const Point<2> &)> b_c =
        [&](const Point<2> &x) { return b(x, c); };
    cut(packing, c, triangles);
    if (!integrate_quickly(packing, c, triangles, b_c, jumps, parts))
      integrate(packing, c, triangles, b_c, jumps, parts);
    double error = 0., size = 0., uncertain = 0.;
    for (unsigned int i = 0; i < parts.size(); ++i)
    {
      // A cell that is cut into pieces has no sub-cells of its own.
      on_sub_cell[packing.first_side(c) + (packing.is_seen_whole(c) ? i : 0)] +=
          parts[i].value;
      moment_of_cell[c] += parts[i].moment;
      error += parts[i].error;
      size += parts[i].size;
      uncertain = std::max(uncertain, parts[i].uncertain);
    }
    if (inaccuracies != nullptr)
      inaccuracies->look_at(error, size, uncertain, [&] {
        return text("in ", packing.describe(c), " at ",
                    text_of_point(packing.centre(c)));
      });
  }
}

void BodyForce::add(const Packing<2> &packing,
                    const unsigned int cell,
                    const Tensor<1, 2> &f)
{
  if (empty())
    allocate(packing);
  for (unsigned int i = 0; i < packing.n_sides(cell); ++i)
  {
    const Tensor<1, 2> a = packing.vertex(cell, i) - packing.centre(cell);
    const Tensor<1, 2> b = packing.vertex(cell, i + 1) - packing.centre(cell);
    const Tensor<1, 2> share = 0.5 * cross(a, b) / packing.area(cell) * f;
    on_sub_cell[packing.first_side(cell) + i] += share;
    moment_of_cell[cell] += outer_product(share, (a + b) / 3.);
  }
}

void BodyForce::add(const double factor, const BodyForce &other)
{
  if (empty())
  {
    on_sub_cell.resize(other.on_sub_cell.size());
    moment_of_cell.resize(other.moment_of_cell.size());
  }
  for (std::size_t i = 0; i < other.on_sub_cell.size(); ++i)
    on_sub_cell[i] += factor * other.on_sub_cell[i];
  for (std::size_t c = 0; c < other.moment_of_cell.size(); ++c)
    moment_of_cell[c] += factor * other.moment_of_cell[c];
}

void BodyForce::add(const Packing<2> &packing,
                    const unsigned int cell,
                    const Tensor<1, 2> &f,
                    const Point<2> &place)
{
  add(packing, cell, f);
  const AreaMoments of_area = area_moments(packing, cell);
  const Tensor<1, 2> centroid = of_area.centroid();
  const Tensor<2, 2> second = of_area.second_about_centroid();
  const double torque = cross(place - packing.centre(cell) - centroid, f);
  const double density = torque / trace(second);
  for (unsigned int i = 0; i < packing.n_sides(cell); ++i)
  {
    const Tensor<1, 2> a = packing.vertex(cell, i) - packing.centre(cell);
    const Tensor<1, 2> b = packing.vertex(cell, i + 1) - packing.centre(cell);
    const Tensor<1, 2> arm = (a + b) / 3. - centroid;
    on_sub_cell[packing.first_side(cell) + i] +=
        0.5 * density * cross(a, b) * Tensor<1, 2>({-arm[1], arm[0]});
  }
  for (unsigned int j = 0; j < 2; ++j)
  {
    moment_of_cell[cell][0][j] -= density * second[1][j];
    moment_of_cell[cell][1][j] += density * second[0][j];
  }
}

void BodyForce::allocate(const Packing<2> &packing)
{
  on_sub_cell.resize(packing.first_side(packing.n_cells()));
  moment_of_cell.resize(packing.n_cells());
}

Tensor<1, 2> BodyForce::force(const Packing<2> &packing,
                              const unsigned int cell) const
{
  Tensor<1, 2> sum;
  for (unsigned int i = 0; i < packing.n_sides(cell); ++i)
    sum += force(packing, cell, i);
  return sum;
}

Tensor<1, 2> BodyForce::force(const Packing<2> &packing,
                              const unsigned int cell,
                              const unsigned int i) const
{
  return empty() ? Tensor<1, 2>() : on_sub_cell[packing.first_side(cell) + i];
}

Tensor<2, 2> BodyForce::moment(const unsigned int cell) const
{
  return empty() ? Tensor<2, 2>() : moment_of_cell[cell];
}

double BodyForce::torque(const unsigned int cell) const
{
  const Tensor<2, 2> of = moment(cell);
  return of[1][0] - of[0][1];
}

BodyForce BodyForce::transformed(const Packing<2> &packing,
                                 const Tensor<2, 2> &A,
                                 const std::vector<double> &share_of_cell) const
{
  BodyForce other = *this;
  for (unsigned int c = 0; c < moment_of_cell.size(); ++c)
  {
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
    {
      Tensor<1, 2> &f = other.on_sub_cell[packing.first_side(c) + i];
      f = share_of_cell[c] * (A * f);
    }
    other.moment_of_cell[c] = share_of_cell[c] * (A * moment_of_cell[c]);
  }
  return other;
}

BodyForce BodyForce::turned(const std::vector<double> &angles) const
{
  BodyForce other = *this;
  for (unsigned int c = 0; c < moment_of_cell.size(); ++c)
    // Of b and R (x - x_c).
    other.moment_of_cell[c] =
        moment_of_cell[c] * transpose(rotation_by(angles[c]));
  return other;
}
} // namespace Voussoir
