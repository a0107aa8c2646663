// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/stress/slender_tetrahedra.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/** The volume of a slender tetrahedron, and the most that a step may change,
 * over that of the cell. */
constexpr double small_volume = 3e-3;
/** What a tetrahedron keeps of its volume at least, if an edge vanishes beside
 * it. */
constexpr double least_rest = 0.5;
/** By what the smaller of two tetrahedra has to become larger. */
constexpr double least_gain = 2.;

using Corners = std::array<unsigned int, 3>;

bool has(const Corners &corners, const unsigned int point)
{
  return std::find(corners.begin(), corners.end(), point) != corners.end();
}

/** One change of the surface. */
struct Step
{
  /** Of all tetrahedra together, in volume. */
  double change;
  /** Of the edge that goes. */
  unsigned int a, b;
  /** Its triangles, in which it runs from a to b and from b to a, and their
   * third corners. */
  unsigned int left, right, p, q;
  /** Whether its ends become one; else p and q are joined instead. */
  bool merges;
};

/** Takes the steps. */
class Merging
{
public:
  Merging(const SurfaceTriangles &surface,
          const std::vector<Tensor<1, 3>> &forces);

  bool take_step();
  void write(SlenderTetrahedra &to) const;

private:
  double volume_of(const Corners &c) const
  {
    return cross_product_3d(points[c[0]], points[c[1]]) *
           Tensor<1, 3>(points[c[2]]) / 6.;
  }
  void judge(Step step);
  void judge_merging(Step step);
  void judge_other_diagonal(Step step);
  void merge(const Step &step);
  void cut_otherwise(const Step &step);
  unsigned int
  beyond(unsigned int triangle, unsigned int a, unsigned int b) const;

  std::vector<Point<3>> points;
  std::vector<unsigned int> faces;
  /** Of all triangles, those that are no more among them. */
  std::vector<Corners> corners;
  std::vector<Tensor<1, 3>> forces;
  std::vector<double> volumes;
  std::vector<char> is_there;
  unsigned int n_there;
  std::vector<std::vector<SlenderTetrahedra::Heir>> heirs;
  double limit = 0.;
  std::optional<Step> best;
};

Merging::Merging(const SurfaceTriangles &surface,
                 const std::vector<Tensor<1, 3>> &forces)
    : points(surface.points), forces(forces),
      is_there(surface.triangles.size(), true),
      n_there(surface.triangles.size())
{
  double sum = 0.;
  for (const SurfaceTriangles::Triangle &triangle : surface.triangles)
  {
    heirs.push_back({{static_cast<unsigned int>(corners.size()), 1.}});
    faces.push_back(triangle.face);
    corners.push_back(triangle.corners);
    volumes.push_back(volume_of(triangle.corners));
    sum += volumes.back();
  }
  limit = small_volume * sum;
}

/** The other triangle with an edge; the one that is given if there is none. */
unsigned int Merging::beyond(const unsigned int triangle,
                             const unsigned int a,
                             const unsigned int b) const
{
  for (unsigned int t = 0; t < corners.size(); ++t)
    if (t != triangle && is_there[t] && has(corners[t], a) &&
        has(corners[t], b))
      return t;
  return triangle;
}

void Merging::judge(Step step)
{
  judge_other_diagonal(step);
  if (volumes[step.left] < limit && volumes[step.right] < limit && n_there > 4)
    judge_merging(step);
}

/** Take it as the best if it is possible, and changes less than others. */
void Merging::judge_merging(Step step)
{
  step.merges = true;
  step.change = std::abs(volumes[step.left]) + std::abs(volumes[step.right]);
  const Point<3> old_a = points[step.a], old_b = points[step.b];
  const Point<3> middle = old_a + 0.5 * (old_b - old_a);
  points[step.a] = points[step.b] = middle;
  bool is_possible = true;
  // Only p and q may be neighbours of both ends.
  std::vector<unsigned int> of_a, of_b;
  for (unsigned int t = 0; t < corners.size(); ++t)
  {
    if (!is_there[t])
      continue;
    const bool has_a = has(corners[t], step.a), has_b = has(corners[t], step.b);
    for (const unsigned int x : corners[t])
    {
      if (has_a && x != step.a)
        of_a.push_back(x);
      if (has_b && x != step.b)
        of_b.push_back(x);
    }
    if (has_a == has_b)
      continue;
    const double volume = volume_of(corners[t]);
    step.change += std::abs(volume - volumes[t]);
    is_possible &= volume > least_rest * volumes[t];
  }
  points[step.a] = old_a;
  points[step.b] = old_b;
  for (const unsigned int x : of_a)
    is_possible &= x == step.b || x == step.p || x == step.q ||
                   std::find(of_b.begin(), of_b.end(), x) == of_b.end();
  if (is_possible && step.change < limit &&
      (!best || step.change < best->change))
    best = step;
}

void Merging::judge_other_diagonal(Step step)
{
  step.merges = false;
  const double first = volume_of({{step.p, step.a, step.q}}),
               second = volume_of({{step.q, step.b, step.p}});
  const double smaller = std::min(volumes[step.left], volumes[step.right]);
  step.change =
      std::abs(first + second - volumes[step.left] - volumes[step.right]);
  if (smaller < limit && step.change < limit &&
      std::min(first, second) > std::max(least_gain * smaller, 0.) &&
      beyond(corners.size(), step.p, step.q) == corners.size() &&
      (!best || step.change < best->change))
    best = step;
}

/** @return false if there is none. */
bool Merging::take_step()
{
  best.reset();
  for (unsigned int left = 0; left < corners.size(); ++left)
    for (unsigned int m = 0; is_there[left] && m < 3; ++m)
    {
      const unsigned int a = corners[left][m], b = corners[left][(m + 1) % 3],
                         p = corners[left][(m + 2) % 3];
      if (volumes[left] >= limit)
        continue;
      const unsigned int right = beyond(left, a, b);
      unsigned int q = 0;
      for (const unsigned int x : corners[right])
        if (x != a && x != b)
          q = x;
      judge({0., a, b, left, right, p, q, false});
    }
  if (best && best->merges)
    merge(*best);
  else if (best)
    cut_otherwise(*best);
  return best.has_value();
}

void Merging::merge(const Step &step)
{
  const auto [change, a, b, left, right, p, q, merges] = step;
  for (const auto &[gone, third] : {std::pair(left, p), std::pair(right, q)})
  {
    const unsigned int to[] = {beyond(gone, a, third), beyond(gone, b, third)};
    for (const unsigned int t : to)
      forces[t] += 0.5 * forces[gone];
    for (auto &list : heirs)
      for (unsigned int k = 0; k < list.size(); ++k)
        if (list[k].triangle == gone)
        {
          const double half = 0.5 * list[k].share;
          list[k] = {to[0], half};
          list.push_back({to[1], half});
        }
    is_there[gone] = false;
    --n_there;
  }
  points[a] += 0.5 * (points[b] - points[a]);
  for (unsigned int t = 0; t < corners.size(); ++t)
    if (is_there[t] && (has(corners[t], a) || has(corners[t], b)))
    {
      std::replace(corners[t].begin(), corners[t].end(), b, a);
      volumes[t] = volume_of(corners[t]);
    }
}

void Merging::cut_otherwise(const Step &step)
{
  const auto [change, a, b, left, right, p, q, merges] = step;
  if (volumes[right] > volumes[left])
    faces[left] = faces[right];
  faces[right] = faces[left];
  corners[left] = {{p, a, q}};
  corners[right] = {{q, b, p}};
  for (const unsigned int t : {left, right})
    volumes[t] = volume_of(corners[t]);
  const Tensor<1, 3> sum = forces[left] + forces[right];
  const double share = volumes[left] / (volumes[left] + volumes[right]);
  forces[left] = share * sum;
  forces[right] = (1. - share) * sum;
  for (auto &list : heirs)
  {
    double of_both = 0.;
    for (auto &heir : list)
      if (heir.triangle == left || heir.triangle == right)
        of_both += std::exchange(heir.share, 0.);
    if (of_both > 0.)
    {
      list.push_back({left, share * of_both});
      list.push_back({right, (1. - share) * of_both});
    }
  }
}

void Merging::write(SlenderTetrahedra &to) const
{
  std::vector<unsigned int> number(corners.size());
  to.surface.points = points;
  for (unsigned int t = 0; t < corners.size(); ++t)
    if (is_there[t])
    {
      number[t] = to.surface.triangles.size();
      to.surface.triangles.push_back({corners[t], faces[t], {}, {}});
      to.forces.push_back(forces[t]);
    }
  to.heirs.resize(heirs.size());
  for (unsigned int t = 0; t < heirs.size(); ++t)
    for (const SlenderTetrahedra::Heir &heir : heirs[t])
      if (heir.share > 0.)
        to.heirs[t].push_back({number[heir.triangle], heir.share});
}
} // namespace

SlenderTetrahedra::SlenderTetrahedra(const SurfaceTriangles &of,
                                     const std::vector<Tensor<1, 3>> &on)
{
  Merging merging(of, on);
  // Each step leaves less of slender tetrahedra.
  for (unsigned int step = 0; step < of.triangles.size(); ++step)
    if (!merging.take_step())
      break;
  merging.write(*this);
  number_edges(surface);
}
} // namespace Voussoir
