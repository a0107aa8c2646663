// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/formula/integrals/linear_fit.h>
#include <voussoir/formula/integrals/strip_integral.h>
#include <voussoir/formula/integrals/triangle_integral.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
using Triangle = std::array<Point<2>, 3>;
using TriangleFunction = std::function<Tensor<1, 2>(const Point<2> &)>;
/** Of f, and of the components of f times those of the distance from the
 * origin over the scale, row by row. */
using Sums = AreaSums;

/**
 * LinearFit::unevenness() with which the rule is good, over the geometric
 * mean of the sizes of the function in the triangle and in all of them. The
 * errors of the integral and of its moments are at most about its square times
 * the local size: of a wave that passes zero, the moments.
 */
constexpr double smallest_triangle_unevenness = 2e-5;

/** The change of an integral by cutting its triangle in four, over its size,
 * that shows that it needs no more of that. */
constexpr double smallest_change = 1e-12;

/** The change of the whole integral that is not looked for any more, over the
 * size of the function. */
constexpr double smallest_doubt = 1e-14;

/**
 * A change, over smallest_change, that two more cuts in four take below it: one
 * divides it by 2^6. Of a larger one strip_integral() needs fewer evaluations.
 */
constexpr double reachable_change = 4096.;

/** A change, over the integral, with which not even the estimate of
 * strip_integral() can be trusted: a peak was met, but not resolved. */
constexpr double roughness_of_triangle = 1e-2;

/** The part of the area in which nothing is looked for any more. */
constexpr double smallest_part = 1e-14;

/** The largest number of triangles that are cut in four. */
constexpr unsigned int n_max_cut = 1000;

/**
 * The evaluations of the function after which what is left takes each of its
 * rules once.
 */
constexpr unsigned int n_max_evaluations = 2000000;

/**
 * A quadrature rule on triangles of seven points and degree five, with a
 * measure of how uneven a function is in these points.
 *
 * Of functions that are smooth the measure falls like the square of the size of
 * the triangle, and the error of the rule like the sixth power. For plane waves
 * and exponentials in all directions the error is at most 0.11 times its cube;
 * null rules of higher degree are blind in some directions.
 */
using TriangleRule = FittedRule<2, 7>;

double area_of(const Triangle &triangle)
{
  return 0.5 * cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
}

std::array<Triangle, 4> quarters(const Triangle &t)
{
  const auto middle = [&](const unsigned int i, const unsigned int j) {
    return t[i] + 0.5 * (t[j] - t[i]);
  };
  const Point<2> a = middle(1, 2), b = middle(2, 0), c = middle(0, 1);
  return {{{{t[0], c, b}}, {{c, t[1], a}}, {{b, a, t[2]}}, {{a, b, c}}}};
}

/** The triangles of the first corner of a convex polygon and its sides. */
std::vector<Triangle> triangles_of(const std::vector<Point<2>> &corners)
{
  std::vector<Triangle> triangles;
  for (unsigned int i = 1; i + 1 < corners.size(); ++i)
    triangles.push_back({{corners[0], corners[i], corners[i + 1]}});
  return triangles;
}

class TriangleIntegrator
{
public:
  TriangleIntegrator(const Triangle &triangle,
                     const Point<2> &origin,
                     const TriangleFunction &f,
                     const Discontinuities &jumps)
      : triangle(triangle), origin(origin), area(area_of(triangle)),
        scale(std::sqrt(area)), f(f), jumps(jumps)
  {}

  TriangleIntegral integral()
  {
    if (!jumps.empty())
    {
      integrate_pieces();
      return result();
    }
    const Discontinuities::Limits no_limits = jumps.no_limits();
    look_at(whole(no_limits));
    cut_doubtful();
    return result();
  }

  std::optional<TriangleIntegral> quick_integral()
  {
    const Discontinuities::Limits no_limits = jumps.no_limits();
    const Part part = whole(no_limits);
    if (part.found.unevenness > evenness(part, mean_size))
      return {};
    sum = part.found.sums;
    return result();
  }

private:
  TriangleIntegral result() const
  {
    TriangleIntegral result;
    for (unsigned int i = 0; i < 2; ++i)
    {
      result.value[i] = sum.values[i];
      for (unsigned int j = 0; j < 2; ++j)
        result.moment[i][j] = scale * sum.values[2 + 2 * i + j];
    }
    result.error = error;
    result.size = mean_size * area;
    result.samples = samples;
    result.uncertain = uncertain / area;
    return result;
  }

  /** The result of the rule in a triangle. */
  struct Found
  {
    Sums sums = 0.;
    /** The larger one of both components. */
    double unevenness = 0.;
    /** The integral of the size of the function. */
    double size = 0.;
    std::array<Samples, 2> samples;
  };

  /** A triangle in which the function is smooth, and what is known of it. */
  struct Part
  {
    Triangle corners;
    Found found;
    const Discontinuities::Limits *limits;
    /** The change that cutting it may bring, roughly. */
    double doubt;

    bool operator<(const Part &other) const { return doubt < other.doubt; }
  };

  /** All of the triangle, whose mean size and samples it sets. */
  Part whole(const Discontinuities::Limits &no_limits)
  {
    const Found found = apply_rule(triangle);
    mean_size = found.size / area;
    samples = found.samples;
    return {triangle, found, &no_limits, 0.};
  }

  void integrate_pieces()
  {
    const std::vector<AreaPiece> pieces =
        area_pieces({triangle.begin(), triangle.end()}, jumps);
    std::vector<std::pair<Part, const AreaPiece *>> parts;
    for (const AreaPiece &piece : pieces)
      for (const Triangle &part : triangles_of(piece.corners))
      {
        parts.push_back({{part, apply_rule(part), &piece.limits, 0.}, &piece});
        mean_size += parts.back().first.found.size / area;
      }
    for (const auto &[part, piece] : parts)
      if (piece->is_uncertain)
      {
        uncertain += area_of(part.corners);
        sum += part.found.sums;
      }
      else if (!piece->crossing)
        look_at(part);
    cut_doubtful();
    // Last, when the size of the function is known best.
    for (const AreaPiece &piece : pieces)
      if (piece.crossing && !piece.is_uncertain)
        integrate_strips(piece);
  }

  /** At a point; the constant is the mean size. */
  Sums at(const Point<2> &p)
  {
    ++n_evaluations;
    const Tensor<1, 2> value = f(p);
    const Tensor<1, 2> arm = (p - origin) / scale;
    Sums sums;
    sums.values = {{value[0], value[1], value[0] * arm[0], value[0] * arm[1],
                    value[1] * arm[0], value[1] * arm[1], mean_size}};
    return sums;
  }

  Found apply_rule(const Triangle &part)
  {
    static const TriangleRule rule(dealii::QGaussSimplex<2>(3));
    const Tensor<1, 2> a = part[1] - part[0], b = part[2] - part[0];
    const double part_area = 0.5 * cross(a, b);
    Found found;
    std::array<std::array<double, rule.n_points>, 2> values;
    for (unsigned int q = 0; q < rule.n_points; ++q)
    {
      const Sums there =
          at(part[0] + rule.points[q][0] * a + rule.points[q][1] * b);
      // deal.II's weights are those of the triangle (0, 0), (1, 0), (0, 1).
      const double weight = 2. * rule.weights[q] * part_area;
      found.sums += weight * there;
      found.size += weight * std::max(std::abs(there.values[0]),
                                      std::abs(there.values[1]));
      for (unsigned int i = 0; i < 2; ++i)
      {
        values[i][q] = there.values[i];
        found.samples[i].add(there.values[i]);
      }
    }
    for (unsigned int i = 0; i < 2; ++i)
      found.unevenness =
          std::max(found.unevenness, rule.fit.unevenness(values[i]));
    return found;
  }

  /** Add the integral over a triangle, or put it off to be cut. */
  void look_at(Part part)
  {
    // By its own size alone, since that of all may still be far too large, if a
    // point of the rule has met a peak.
    const double size = part.found.size / area_of(part.corners);
    const double hidden = hidden_in(part, evenness(part, size));
    if (area_of(part.corners) <= smallest_part * area ||
        (part.found.unevenness <= evenness(part, size) && hidden == 0.))
    {
      sum += part.found.sums;
      return;
    }
    part.doubt =
        std::max(hidden, part.found.unevenness * area_of(part.corners));
    doubtful.push_back(std::move(part));
    std::push_heap(doubtful.begin(), doubtful.end());
  }

  /** Go through what was put off, the most doubtful first. */
  void cut_doubtful()
  {
    while (!doubtful.empty())
    {
      std::pop_heap(doubtful.begin(), doubtful.end());
      const Part part = doubtful.back();
      doubtful.pop_back();
      const double even = evenness(part, mean_size);
      const bool hides = hidden_in(part, even) > 0.;
      if (part.doubt <= smallest_doubt * mean_size * area ||
          (part.found.unevenness <= even && !hides))
        sum += part.found.sums;
      else
        cut(part, hides);
    }
  }

  /** @param hides true if hidden_in() is not zero. */
  void cut(const Part &part, const bool hides)
  {
    const std::array<Triangle, 4> triangles = quarters(part.corners);
    std::array<Found, 4> finer;
    Found all;
    for (unsigned int k = 0; k < 4; ++k)
    {
      finer[k] = apply_rule(triangles[k]);
      all.sums += finer[k].sums;
      all.size += finer[k].size;
    }
    mean_size = std::max(mean_size + (all.size - part.found.size) / area, 0.);
    const double change = abs(all.sums - part.found.sums);
    const double enough = smallest_change * mean_size * area_of(part.corners);
    const bool is_rough = change > roughness_of_triangle * all.size;
    const bool is_last = n_cut >= n_max_cut;
    if ((change <= enough && !hides) || (is_last && is_rough))
    {
      sum += all.sums;
      error += change <= enough ? change : all.size;
      return;
    }
    if (is_last || (change > reachable_change * enough && !is_rough && !hides))
    {
      AreaPiece piece;
      piece.corners.assign(part.corners.begin(), part.corners.end());
      return integrate_strips(piece);
    }
    ++n_cut;
    for (unsigned int k = 0; k < 4; ++k)
      look_at({triangles[k], finer[k], part.limits, 0.});
  }

  /** The unevenness with which the rule is good, beside a function of @p size
   * elsewhere. */
  static double evenness(const Part &part, const double size)
  {
    return smallest_triangle_unevenness *
           std::sqrt(size * part.found.size / area_of(part.corners));
  }

  /** The integral of what bounds allow and was not seen, zero if none; for
   * @p negligible see Samples::cover(). */
  double hidden_in(const Part &part, const double negligible) const
  {
    if (!jumps.has_formulas())
      return 0.;
    const auto bounds =
        jumps.bounds_in(rectangle_around(part.corners), *part.limits);
    if (cover(part.found.samples, bounds, negligible))
      return 0.;
    double range = 0.;
    for (const Bounds &of_component : bounds)
      range = std::max(range, width(of_component.value));
    return range * area_of(part.corners);
  }

  void integrate_strips(const AreaPiece &piece)
  {
    const auto found = strip_integral(
        piece, jumps, [this](const Point<2> &p) { return at(p); },
        [this] { return n_evaluations >= n_max_evaluations; });
    sum += found.value;
    error += found.error;
  }

  const Triangle &triangle;
  const Point<2> origin;
  const double area, scale;
  const TriangleFunction &f;
  const Discontinuities &jumps;
  Sums sum = 0.;
  std::array<Samples, 2> samples;
  double mean_size = 0., error = 0., uncertain = 0.;
  /** A heap. */
  std::vector<Part> doubtful;
  unsigned int n_cut = 0, n_evaluations = 0;
};
} // namespace

TriangleIntegral triangle_integral(const Triangle &corners,
                                   const Point<2> &origin,
                                   const TriangleFunction &f,
                                   const Discontinuities &jumps)
{
  return TriangleIntegrator(corners, origin, f, jumps).integral();
}

std::optional<TriangleIntegral> quick_triangle_integral(
    const Triangle &corners, const Point<2> &origin, const TriangleFunction &f)
{
  static const Discontinuities continuous;
  return TriangleIntegrator(corners, origin, f, continuous).quick_integral();
}
} // namespace Voussoir
