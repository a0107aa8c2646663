// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/formula/area_pieces.h>
#include <voussoir/formula/edge_pieces.h>
#include <voussoir/formula/gauss_kronrod.h>
#include <voussoir/formula/triangle_integral.h>
#include <voussoir/formula/triangle_rule.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
using Triangle = std::array<Point<2>, 3>;
using Function = std::function<Tensor<1, 2>(const Point<2> &)>;
/** Of f, and of the components of f times those of the distance from the
 * origin over the scale, row by row. */
using Sums = Integrals<6>;

/** @{ */
/** The tolerances of integrate() along one coordinate, and along the other. */
constexpr double inner_tolerance = 1e-13;
constexpr double outer_tolerance = 1e-12;
/** @} */

/** The points of the rule in each part along a coordinate. */
constexpr unsigned int n_points = 21;

/** The width of a strip, over that of its piece, that is rounding. */
constexpr double narrowest_strip = 1e-14;

/**
 * LinearFit::unevenness() with which the rule is good, over the geometric
 * mean of the sizes of the function in the triangle and in all of them. The
 * errors of the integral and of its moments are at most about its square times
 * the local size: of a wave that passes zero, the moments.
 */
constexpr double smallest_unevenness = 2e-5;

/** The change of an integral by cutting its triangle in four, over its size,
 * that shows that it needs no more of that. */
constexpr double smallest_change = 1e-12;

/** The change of the whole integral that is not looked for any more, over the
 * size of the function. */
constexpr double smallest_doubt = 1e-14;

/**
 * A change, over smallest_change, that two more cuts in four take below it: one
 * divides it by 2^6. Of a larger one integrate() needs fewer evaluations.
 */
constexpr double reachable_change = 4096.;

/** The same change with which not even the estimates of integrate() can be
 * trusted: a peak was met, but not resolved. */
constexpr double roughness = 1e-2;

/** The part of the area in which nothing is looked for any more. */
constexpr double smallest_part = 1e-14;

/** The largest number of triangles that are cut in four. */
constexpr unsigned int n_max_cut = 1000;

/**
 * The evaluations of the function after which what is left takes each of its
 * rules once.
 */
constexpr unsigned int n_max_evaluations = 2000000;

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

class Integrator
{
public:
  Integrator(const Triangle &triangle,
             const Point<2> &origin,
             const Function &f,
             const Jumps &jumps)
      : triangle(triangle), origin(origin), area(area_of(triangle)),
        scale(std::sqrt(area)), f(f), jumps(jumps)
  {
  }

  TriangleIntegral integral()
  {
    if (jumps.empty())
      integrate_smooth();
    else
      integrate_pieces();
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

private:
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

  void integrate_smooth()
  {
    const Found found = apply_rule(triangle);
    mean_size = found.size / area;
    samples = found.samples;
    const Jumps::Limits no_limits = jumps.no_limits();
    look_at(triangle, found, no_limits);
    cut_doubtful();
  }

  void integrate_pieces()
  {
    const std::vector<AreaPiece> pieces =
        area_pieces({triangle.begin(), triangle.end()}, jumps);
    double size = 0.;
    for (const AreaPiece &piece : pieces)
      for (const Triangle &part : triangles_of(piece.corners))
        size += apply_rule(part).size;
    mean_size = size / area;
    for (const AreaPiece &piece : pieces)
      if (piece.crossing)
        integrate_strips(piece);
      else
        for (const Triangle &part : triangles_of(piece.corners))
          if (piece.is_uncertain)
          {
            uncertain += area_of(part);
            sum += apply_rule(part).sums;
          }
          else
            look_at(part, apply_rule(part), piece.limits);
    cut_doubtful();
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
    static const TriangleRule rule;
    const Tensor<1, 2> a = part[1] - part[0], b = part[2] - part[0];
    const double part_area = 0.5 * cross(a, b);
    Found found;
    std::array<LinearFit<TriangleRule::n_points>::Values, 2> values;
    for (unsigned int q = 0; q < rule.n_points; ++q)
    {
      const Sums there =
          at(part[0] + rule.points[q][0] * a + rule.points[q][1] * b);
      const double weight = rule.weights[q] * part_area;
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

  /** A triangle in which the function is smooth, and what is known of it. */
  struct Part
  {
    Triangle corners;
    Found found;
    const Jumps::Limits *limits;
    /** The integral of what bounds allow and was not seen; zero if none. */
    double hidden;
    /** The change that cutting it may bring, roughly. */
    double doubt;

    bool operator<(const Part &other) const
    {
      return doubt < other.doubt;
    }
  };

  /** Add the integral over a triangle, or put it off to be cut. */
  void look_at(const Triangle &corners,
               const Found &found,
               const Jumps::Limits &limits)
  {
    const double part_area = area_of(corners);
    const double even =
        smallest_unevenness * std::sqrt(mean_size * found.size / part_area);
    const double hidden = hidden_in(corners, found, limits, even);
    if (part_area <= smallest_part * area ||
        (found.unevenness <= even && hidden == 0.))
    {
      sum += found.sums;
      return;
    }
    doubtful.push_back({corners, found, &limits, hidden,
                        std::max(hidden, found.unevenness * part_area)});
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
      // The mean may be larger than when the part was put off.
      if (part.doubt <= smallest_doubt * mean_size * area)
        sum += part.found.sums;
      else
        cut(part);
    }
  }

  void cut(const Part &part)
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
    mean_size = std::max(mean_size, all.size / area);
    const double change = abs(all.sums - part.found.sums);
    const double enough = smallest_change * mean_size * area_of(part.corners);
    const bool is_rough = change > roughness * all.size;
    const bool is_last = n_cut >= n_max_cut;
    if ((change <= enough && part.hidden == 0.) || (is_last && is_rough))
    {
      sum += all.sums;
      error += change <= enough ? change : all.size;
      return;
    }
    if (is_last ||
        (change > reachable_change * enough && !is_rough && part.hidden == 0.))
    {
      AreaPiece piece;
      piece.corners.assign(part.corners.begin(), part.corners.end());
      return integrate_strips(piece);
    }
    ++n_cut;
    for (unsigned int k = 0; k < 4; ++k)
      look_at(triangles[k], finer[k], *part.limits);
  }

  /** See Part::hidden; for @p negligible see Samples::cover(). */
  double hidden_in(const Triangle &part,
                   const Found &found,
                   const Jumps::Limits &limits,
                   const double negligible) const
  {
    if (!jumps.has_formulas())
      return 0.;
    const auto bounds = jumps.bounds_in(rectangle_around(part), limits);
    if (cover(found.samples, bounds, negligible))
      return 0.;
    double range = 0.;
    for (const Bounds &of_component : bounds)
      range = std::max(range, width(of_component.value));
    return range * area_of(part);
  }

  /** Add the integral over a piece that one curve may cross. */
  void integrate_strips(const AreaPiece &piece)
  {
    const std::vector<double> cuts = strips(piece);
    for (unsigned int k = 0; k + 1 < cuts.size(); ++k)
    {
      const auto strip = integrate<n_points>(
          [&](const double s) { return across(piece, s); }, cuts[k],
          cuts[k + 1], tolerance_or_any(outer_tolerance));
      sum += strip.value;
      error += strip.error;
    }
  }

  /**
   * The tolerance of integrate(): infinite once its evaluations are used up.
   */
  double tolerance_or_any(const double tolerance) const
  {
    return n_evaluations < n_max_evaluations
               ? tolerance
               : std::numeric_limits<double>::infinity();
  }

  /**
   * The coordinates at which corners are, or the curve leaves the piece;
   * ascending.
   */
  std::vector<double> strips(const AreaPiece &piece) const
  {
    const unsigned int s = 1 - piece.along;
    std::vector<double> all;
    for (unsigned int i = 0; i < piece.corners.size(); ++i)
    {
      const Point<2> &a = piece.corners[i];
      const Point<2> &b = piece.corners[(i + 1) % piece.corners.size()];
      all.push_back(a[s]);
      if (piece.crossing)
        for (const EdgePiece &part : edge_pieces(a, b, jumps, piece.limits))
          all.push_back(a[s] + part.end * (b[s] - a[s]));
    }
    std::sort(all.begin(), all.end());
    const double narrow = narrowest_strip * (all.back() - all.front());
    std::vector<double> cuts;
    for (const double cut : all)
      if (cuts.empty() || cut > cuts.back() + narrow)
        cuts.push_back(cut);
    return cuts;
  }

  /** The integral along the line at @p s through a piece. */
  Sums across(const AreaPiece &piece, const double s)
  {
    const auto [a, b] = ends(piece, s);
    const double length = b[piece.along] - a[piece.along];
    const auto between = [&](const double begin, const double end) {
      return length * integrate<n_points>(
                          [&](const double t) { return at(a + t * (b - a)); },
                          begin, end, tolerance_or_any(inner_tolerance))
                          .value;
    };
    if (!(length > 0.))
      return 0.;
    if (piece.crossing)
    {
      const double first = jumps.distance(*piece.crossing, a);
      const double last = jumps.distance(*piece.crossing, b);
      if (first * last < 0.)
      {
        const double root =
            root_between(a, b, first, last, jumps, *piece.crossing);
        return between(0., root) + between(root, 1.);
      }
    }
    return between(0., 1.);
  }

  /** The lower and the upper end of the line at @p s through a piece. */
  static std::pair<Point<2>, Point<2>> ends(const AreaPiece &piece,
                                            const double s)
  {
    const unsigned int along = piece.along, other = 1 - piece.along;
    Point<2> lower, upper;
    bool is_first = true;
    for (unsigned int i = 0; i < piece.corners.size(); ++i)
    {
      const Point<2> &a = piece.corners[i];
      const Point<2> &b = piece.corners[(i + 1) % piece.corners.size()];
      if ((s - a[other]) * (s - b[other]) > 0. || a[other] == b[other])
        continue;
      Point<2> p;
      p[other] = s;
      p[along] = a[along] +
                 (s - a[other]) / (b[other] - a[other]) * (b[along] - a[along]);
      if (is_first || p[along] < lower[along])
        lower = p;
      if (is_first || p[along] > upper[along])
        upper = p;
      is_first = false;
    }
    return {lower, upper};
  }

  const Triangle &triangle;
  const Point<2> origin;
  const double area, scale;
  const Function &f;
  const Jumps &jumps;
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
                                   const Function &f,
                                   const Jumps &jumps)
{
  return Integrator(corners, origin, f, jumps).integral();
}
} // namespace Voussoir
