// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/convex_pieces.h>
#include <voussoir/packing/polygons/line_work.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/boost_adaptors/point.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace Voussoir
{
namespace
{
using dealii::Point;
using Ring = std::vector<Point<2>>;
using Polygon = PolygonList::Polygon;
using Box = dealii::BoundingBox<2>;

/** The distance of a point from a segment; a length. */
double distance_from(const Point<2> &p, const LinePiece &piece)
{
  return p.distance(nearest_on_segment(p, piece.start, piece.end));
}

/** Some point inside, if it is a cell; others are refused later. */
std::optional<Point<2>> point_inside(const Ring &ring)
{
  if (!is_simple(ring) || !(signed_area(ring) > 0.))
    return {};
  Ring piece;
  const auto pieces = convex_pieces(ring);
  for (const unsigned int v : pieces.front())
    piece.push_back(ring[v]);
  return centroid(piece);
}

/** Joins the lines of one list; one object, used once. */
class LineJoiner
{
public:
  LineJoiner(PolygonList &polygons, const double tolerance)
      : polygons(polygons), tolerance(tolerance),
        pieces(pieces_of_lines(polygons, tolerance)), found(faces_of(pieces)),
        is_divided(polygons.polygons.size(), false)
  {}

  void join()
  {
    // Of what ends freely follows that others bound no cell.
    const bool some_end = std::any_of(
        found.loose.begin(), found.loose.end(), [&](const LooseLine &line) {
          return line.ends_freely && is_open(line.source);
        });
    for (const LooseLine &line : found.loose)
      if (is_open(line.source) && line.ends_freely == some_end)
        refuse_loose(line);
    polygons.refuse_faults();
    add_faces();
    if (cells.empty())
      throw InputError("The lines of '" + polygons.file.string() +
                       "' enclose nothing; a packing needs at least one "
                       "cell.");
    polygons.polygons = std::move(cells);
    refuse_holes();
  }

private:
  bool is_open(const unsigned int source) const
  {
    return polygons.polygons[source].is_open;
  }

  /** Refuse a line of which a part bounds no cell. */
  void refuse_loose(const LooseLine &line)
  {
    const Polygon &polygon = polygons.polygons[line.source];
    const std::string what = "The line from " +
                             text_of_point(polygon.ring.front()) + " to " +
                             text_of_point(polygon.ring.back()) + " (" +
                             polygons.record_of(line.source, true) + ") ";
    double nearest = 0.;
    std::string fault;
    if (line.ends_freely)
    {
      nearest = std::numeric_limits<double>::max();
      for (const LinePiece &piece : pieces)
        if (piece.source != line.source)
          nearest = std::min(nearest, distance_from(line.place, piece));
      const bool is_alone = nearest == std::numeric_limits<double>::max();
      nearest = is_alone ? 0. : nearest;
      fault = "ends at " + text_of_point(line.place) +
              (is_alone ? " and is the only one"
                        : text(", ", nearest,
                               " from the nearest other line, more than the "
                               "matching tolerance ",
                               tolerance)) +
              "; let it end on another line, or leave it out by "
              "'Packing/polygons/Layers'.";
    }
    else
      fault = "bounds no cell, though others meet it at both ends; delete it, "
              "or leave it out by 'Packing/polygons/Layers'.";
    polygons.faults.emplace_back(DrawingFault::Kind::not_closed,
                                 std::vector<unsigned int>(), what + fault);
    polygons.faults.back().size = nearest;
    polygons.faults.back().line = polygon.ring;
  }

  /** True if a side of the face is a part of open lines only. */
  bool is_cell(const LineFace &face) const
  {
    return std::any_of(face.sources.begin(), face.sources.end(),
                       [&](const std::vector<unsigned int> &sources) {
                         return std::all_of(
                             sources.begin(), sources.end(),
                             [&](const unsigned int s) { return is_open(s); });
                       });
  }

  /** The cells: closed lines that are not divided, and then faces. */
  void add_faces()
  {
    std::vector<Box> boxes;
    std::vector<unsigned int> closed;
    for (unsigned int c = 0; c < polygons.polygons.size(); ++c)
      if (const Polygon &polygon = polygons.polygons[c];
          !polygon.is_open && !polygon.is_broken && polygon.is_drawable())
      {
        closed.push_back(c);
        boxes.emplace_back(polygon.ring);
      }
    const auto tree = dealii::pack_rtree_of_indices(boxes);
    std::vector<Polygon> faces;
    for (const LineFace &face : found.faces)
    {
      if (!is_cell(face))
        continue;
      std::optional<unsigned int> whole;
      if (const std::optional<Point<2>> inside = point_inside(face.ring))
        for (auto k = tree.qbegin(boost::geometry::index::intersects(*inside));
             k != tree.qend(); ++k)
          if (is_inside(*inside, polygons.polygons[closed[*k]].ring))
          {
            is_divided[closed[*k]] = true;
            whole = whole ? std::min(*whole, closed[*k]) : closed[*k];
          }
      const Polygon &source =
          polygons.polygons[whole ? *whole : longest_part(face)];
      if (face.has_hole)
        with_hole.push_back(faces.size());
      Polygon cell = source;
      cell.ring = face.ring;
      cell.is_open = false;
      faces.push_back(cell);
    }
    for (unsigned int c = 0; c < polygons.polygons.size(); ++c)
      if (!is_open(c) && !is_divided[c])
        cells.push_back(polygons.polygons[c]);
    n_kept = cells.size();
    cells.insert(cells.end(), faces.begin(), faces.end());
  }

  /** The open line that is the longest part of a cell's boundary, the first of
   * those as long. */
  unsigned int longest_part(const LineFace &face) const
  {
    std::map<unsigned int, double> lengths;
    for (std::size_t i = 0; i < face.ring.size(); ++i)
      for (const unsigned int source : face.sources[i])
        if (is_open(source))
          lengths[source] +=
              face.ring[i].distance(face.ring[(i + 1) % face.ring.size()]);
    return std::max_element(lengths.begin(), lengths.end(),
                            [&](const auto &a, const auto &b) {
                              return a.second < b.second * (1. - tie);
                            })
        ->first;
  }

  void refuse_holes()
  {
    for (const std::size_t k : with_hole)
      polygons.polygons[n_kept + k].is_broken = !polygons.passes([&] {
        polygons.refuse(DrawingFault::Kind::hole, n_kept + k,
                        "encloses others that its lines do not meet; a "
                        "cell is one loop, so cut it by lines into cells "
                        "without holes.");
      });
  }

  /** What rounding may change of a length, relative. */
  static constexpr double tie = 1e-9;

  PolygonList &polygons;
  const double tolerance;
  const std::vector<LinePiece> pieces;
  const LineFaces found;
  std::vector<bool> is_divided;
  std::vector<Polygon> cells;
  std::size_t n_kept = 0;
  /** The faces that have one, by their numbers among cells. */
  std::vector<std::size_t> with_hole;
};
} // namespace

void join_lines(PolygonList &polygons, const double tolerance)
{
  const std::vector<Polygon> &all = polygons.polygons;
  if (std::none_of(all.begin(), all.end(),
                   [](const Polygon &polygon) { return polygon.is_open; }))
    return;
  polygons.refuse_faults();
  LineJoiner(polygons, tolerance).join();
}
} // namespace Voussoir
