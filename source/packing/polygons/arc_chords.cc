// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polygons/arc.h>
#include <voussoir/packing/polygons/arc_chords.h>
#include <voussoir/packing/polygons/drawn_lines.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/numbers.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace Voussoir
{
namespace
{
using dealii::Point;
using Polygon = PolygonList::Polygon;
using Points = std::vector<Point<2>>;
using Box = dealii::BoundingBox<2>;

/** The deviation of chords over the size of what is drawn, if none is given. */
constexpr double usual_deviation = 1e-3;

/** The largest angle of a chord. */
constexpr double right_angle = 0.5 * dealii::numbers::PI;

/** The most chords of an arc; more are a deviation in another unit. */
constexpr double most_chords = 1e4;

/** Rounding of a number of chords, which must not add one. */
constexpr double rounding_of_number = 1e-9;

/** The least number of chords of an arc that are nowhere too far from it. */
double number_of_chords(const Arc &arc, const double deviation)
{
  // A chord of an angle a is off by r (1 - cos(a/2)) = 2 r sin^2(a/4).
  const double sine = std::sqrt(0.5 * deviation / arc.radius());
  const double largest =
      std::min(right_angle, 4. * std::asin(std::min(1., sine)));
  return std::max(
      1., std::ceil(std::abs(arc.angle()) / largest - rounding_of_number));
}

/** Replaces the arcs of one list; one object, used once. */
class ArcReplacer
{
public:
  ArcReplacer(PolygonList &polygons,
              const double deviation,
              const double tolerance)
      : polygons(polygons), deviation(deviation), tolerance(tolerance),
        corners([&] {
          Points all;
          for (const Polygon &polygon : polygons.polygons)
            if (polygon.is_finite())
              all.insert(all.end(), polygon.ring.begin(), polygon.ring.end());
          return all;
        }()),
        corner_tree(dealii::pack_rtree(corners))
  {}

  void replace()
  {
    for (Polygon &polygon : polygons.polygons)
      if (!polygon.bulges.empty())
        replace(polygon);
    if (n_arcs > 0)
      polygons.notices.push_back(
          text(counted(n_arcs, "arc"), " of '", polygons.file.string(),
               n_arcs == 1 ? "' is" : "' are", " replaced by ",
               counted(n_chords, "chord"), ", nowhere further away than ",
               deviation, "; see 'Packing/polygons/Arc tolerance'."));
  }

private:
  void replace(Polygon &polygon)
  {
    Points ring;
    for (std::size_t i = 0; i < polygon.ring.size(); ++i)
    {
      ring.push_back(polygon.ring[i]);
      if (i == polygon.n_sides() || polygon.bulges[i] == 0.)
        continue;
      ++n_arcs;
      for (const Arc &part :
           parts({polygon.ring[i], polygon.end_of_side(i), polygon.bulges[i]}))
      {
        if (!(part.start == ring.back()))
          ring.push_back(part.start);
        const Points inside = chord_points(part);
        ring.insert(ring.end(), inside.begin(), inside.end());
        n_chords += inside.size() + 1;
      }
    }
    polygon.ring = ring;
    polygon.bulges.clear();
  }

  /** The arc, cut where other corners lie on it. */
  std::vector<Arc> parts(const Arc &arc) const
  {
    const double angle = std::abs(arc.angle()), radius = arc.radius();
    // Of an arc up to a half, as far as it rises; of more, the whole circle.
    Box box(std::array<Point<2>, 2>{{arc.start, arc.end}});
    box.extend(tolerance +
               (std::abs(arc.bulge) > 1.
                    ? 2. * radius
                    : 0.5 * std::abs(arc.bulge) * arc.start.distance(arc.end)));
    std::vector<std::pair<double, Point<2>>> cuts;
    for (auto p = corner_tree.qbegin(boost::geometry::index::intersects(box));
         p != corner_tree.qend(); ++p)
    {
      const double turned = arc.angle_to(*p);
      if (turned < angle && p->distance(arc.start) > tolerance &&
          p->distance(arc.end) > tolerance &&
          std::abs(p->distance(arc.centre()) - radius) <= tolerance)
        cuts.emplace_back(turned, *p);
    }
    std::sort(cuts.begin(), cuts.end(), [](const auto &a, const auto &b) {
      return std::make_tuple(a.first, a.second[0], a.second[1]) <
             std::make_tuple(b.first, b.second[0], b.second[1]);
    });
    std::vector<Arc> found;
    double last = 0.;
    Point<2> start = arc.start;
    const auto add_up_to = [&](const double turned, const Point<2> &end) {
      const double bulge = std::tan(0.25 * (turned - last));
      found.push_back({start, end, arc.bulge > 0. ? bulge : -bulge});
      last = turned;
      start = end;
    };
    for (const auto &[turned, p] : cuts)
      if (p.distance(start) > tolerance)
        add_up_to(turned, p);
    if (found.empty())
      return {arc};
    add_up_to(angle, arc.end);
    return found;
  }

  /** The vertices between the ends of an arc, in its direction. */
  Points chord_points(const Arc &arc)
  {
    const auto is_at = [&](const Point<2> &a, const Point<2> &b) {
      return a.distance(b) <= 2. * tolerance;
    };
    const Point<2> middle = arc.middle();
    Box box(std::array<Point<2>, 2>{{middle, middle}});
    box.extend(2. * tolerance);
    for (auto k = made_tree.qbegin(boost::geometry::index::intersects(box));
         k != made_tree.qend(); ++k)
    {
      const auto &[other, points] = made[k->second];
      if (!is_at(other.middle(), middle))
        continue;
      if (is_at(other.start, arc.start) && is_at(other.end, arc.end))
        return points;
      if (is_at(other.start, arc.end) && is_at(other.end, arc.start))
        return Points(points.rbegin(), points.rend());
    }
    const bool is_forward = std::make_pair(arc.start[0], arc.start[1]) <
                            std::make_pair(arc.end[0], arc.end[1]);
    const Arc canonical = is_forward ? arc : arc.reversed();
    const double n = number_of_chords(canonical, deviation);
    if (!(n <= most_chords))
      throw InputError(
          text("'Packing/polygons/Arc tolerance' = '", deviation, "' makes ", n,
               " chords of the arc from ", text_of_point(arc.start), " to ",
               text_of_point(arc.end), " of '", polygons.file.string(),
               "'; give more, a length after 'Scale', or 0 for a thousandth "
               "of the mean size of a line."));
    Points points;
    for (unsigned int k = 1; k < n; ++k)
      points.push_back(canonical.at(k / n * canonical.angle()));
    made_tree.insert({middle, made.size()});
    made.emplace_back(canonical, points);
    return is_forward ? points : Points(points.rbegin(), points.rend());
  }

  PolygonList &polygons;
  const double deviation, tolerance;
  const Points corners;
  const decltype(dealii::pack_rtree(Points())) corner_tree;
  /** The arcs so far with the vertices between their ends. */
  std::vector<std::pair<Arc, Points>> made;
  dealii::RTree<std::pair<Point<2>, std::size_t>> made_tree;
  std::size_t n_arcs = 0, n_chords = 0;
};

} // namespace

void replace_arcs(PolygonList &polygons,
                  const double deviation,
                  const double tolerance)
{
  bool has_arcs = false;
  for (Polygon &polygon : polygons.polygons)
  {
    if (polygon.is_broken || !polygon.is_finite())
      polygon.bulges.clear();
    has_arcs |= !polygon.bulges.empty();
  }
  if (has_arcs)
    ArcReplacer(polygons,
                deviation > 0. ? deviation
                               : usual_deviation * drawn_size(polygons),
                tolerance)
        .replace();
}
} // namespace Voussoir
