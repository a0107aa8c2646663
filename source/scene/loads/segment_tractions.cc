// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/geometry.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/group_names.h>
#include <voussoir/scene/loads/segment_tractions.h>

#include <deal.II/base/utilities.h>

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/lexical_cast/try_lexical_convert.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/**
 * The distance of an edge from the line, where they run side by side and over
 * the longer one, up to which the line runs along it: coordinates are often
 * written with few digits.
 */
constexpr double largest_distance_from_line = 1e-6;
/** The share of the line that its parts may leave out, or cover twice. */
constexpr double largest_gap = 1e-6;

/** The two sides of "a to b", or more between the words "to". */
std::vector<std::string> sides_of_to(const std::string &text)
{
  std::vector<std::string> words, sides(1);
  boost::algorithm::split(words, text, boost::algorithm::is_space(),
                          boost::algorithm::token_compress_on);
  for (const std::string &word : words)
    if (word == "to")
      sides.emplace_back();
    else
      sides.back() += word + ' ';
  return sides;
}

/** The part of a line that a boundary edge covers. */
struct Overlap
{
  /** The number of the edge. */
  unsigned int edge;
  /** In the coordinate from 0 to 1 along the line. */
  double begin, end;
};

std::optional<Overlap> overlap(const SegmentTraction &segment,
                               const Packing<2> &packing,
                               const unsigned int b)
{
  const Packing<2>::BoundaryEdge &edge = packing.boundary_edges()[b];
  const Tensor<1, 2> line = segment.end - segment.start;
  const double square = line.norm_square();
  const double s = (edge.start - segment.start) * line / square;
  const double t = (edge.end - segment.start) * line / square;
  const Overlap part = {b, std::max(std::min(s, t), 0.),
                        std::min(std::max(s, t), 1.)};
  if (!(part.end > part.begin))
    return {};
  const Tensor<1, 2> along = (edge.end - edge.start) / edge.length;
  for (const double at : {part.begin, part.end})
    if (std::abs(cross(along, segment.start + at * line - edge.start)) >
        largest_distance_from_line * std::max(edge.length, line.norm()))
      return {};
  return part;
}

/** True if parts, ascending, cover the line once. */
bool cover_all(const std::vector<Overlap> &parts)
{
  double end = 0.;
  for (const Overlap &part : parts)
  {
    if (std::abs(part.begin - end) > largest_gap)
      return false;
    end = part.end;
  }
  return std::abs(end - 1.) <= largest_gap;
}

/** Add the traction on a part of the line, times @p factor, to its edge. */
void add_part(const Packing<2> &packing,
              const SegmentTraction &segment,
              const Overlap &part,
              const double factor,
              EdgeTractions &tractions)
{
  const Packing<2>::BoundaryEdge &edge = packing.boundary_edges()[part.edge];
  const Tensor<1, 2> line = segment.end - segment.start;
  const Tensor<1, 2> along = (edge.end - edge.start) / edge.length;
  const auto traction = [&](const double t) {
    return segment.at_start + t * (segment.at_end - segment.at_start);
  };
  const auto place = [&](const double t) {
    return (segment.start + t * line - edge.midpoint()) * along;
  };
  // Simpson's rule, exact for the product of two linear functions.
  const double length = factor * (part.end - part.begin) * line.norm();
  const double middle = 0.5 * (part.begin + part.end);
  const double nodes[3] = {part.begin, middle, part.end};
  const double weights[3] = {1. / 6., 4. / 6., 1. / 6.};
  for (unsigned int k = 0; k < 3; ++k)
    tractions.first_moment[part.edge] +=
        weights[k] * length * place(nodes[k]) * traction(nodes[k]);
  tractions.mean[part.edge] += length / edge.length * traction(middle);
}
} // namespace

std::array<SegmentTraction::Part, 2> SegmentTraction::resultants() const
{
  const Tensor<1, 2> line = end - start;
  const double half = 0.5 * line.norm();
  return {
      {{start + line / 3., half * at_start}, {end - line / 3., half * at_end}}};
}

std::optional<Point<2>> pair_of_text(const std::string &text)
{
  const auto words = dealii::Utilities::split_string_list(text, ',');
  Point<2> pair;
  bool is_valid = words.size() == 2;
  for (unsigned int i = 0; is_valid && i < 2; ++i)
    is_valid = boost::conversion::try_lexical_convert(words[i], pair[i]) &&
               std::isfinite(pair[i]);
  return is_valid ? std::optional<Point<2>>(pair) : std::nullopt;
}

std::vector<SegmentTraction>
segment_tractions_of_text(const std::string &list, const std::string &parameter)
{
  std::vector<SegmentTraction> segments;
  for (const auto &[line, value] : split_named_list(list, parameter))
  {
    const auto ends = sides_of_to(line), tractions = sides_of_to(value);
    std::vector<std::optional<Point<2>>> numbers;
    for (const auto &words : {ends, tractions})
      for (const std::string &word : words)
        numbers.push_back(pair_of_text(word));
    const bool is_valid =
        ends.size() == 2 && tractions.size() <= 2 &&
        std::all_of(numbers.begin(), numbers.end(),
                    [](const auto &pair) { return pair.has_value(); });
    if (!is_valid)
      throw InputError("The parameter '" + parameter + "' has the element '" +
                       line + ": " + value +
                       "'; write \"x, y to x, y: g_x, g_y\" with finite "
                       "numbers, as in 0, 1 to 0.5, 1: 0, -10, or \"g_x, g_y "
                       "to g_x, g_y\" after the colon.");
    const SegmentTraction segment = {*numbers[0], *numbers[1], *numbers[2],
                                     *numbers.back()};
    if (segment.start == segment.end)
      throw InputError("The parameter '" + parameter + "' has the line '" +
                       line + "', which has no length; give two points.");
    segments.push_back(segment);
  }
  return segments;
}

void add_segment_traction(const Packing<2> &packing,
                          const SegmentTraction &segment,
                          const std::string &parameter,
                          EdgeTractions &tractions)
{
  std::vector<Overlap> parts;
  double covered = 0.;
  for (unsigned int b = 0; b < packing.boundary_edges().size(); ++b)
    if (const auto part = overlap(segment, packing, b))
    {
      parts.push_back(*part);
      covered += part->end - part->begin;
    }
  std::sort(parts.begin(), parts.end(), [](const Overlap &a, const Overlap &b) {
    return a.begin < b.begin;
  });
  if (cover_all(parts))
  {
    // The whole load acts, also if the last digits of its ends are missing.
    for (const Overlap &part : parts)
      add_part(packing, segment, part, 1. / covered, tractions);
    return;
  }
  const std::string line = "The parameter '" + parameter +
                           "' has the line from " +
                           text_of_point(segment.start) + " to " +
                           text_of_point(segment.end) + ", of which ";
  if (covered > 1. - largest_gap)
    throw InputError(text(line, "parts run along two edges of the boundary, as "
                                "at an open joint; take 'Loads/Traction', "
                                "which can ask for the normal nx, ny."));
  throw InputError(
      text(line,
           covered == 0. ? std::string("nothing")
                         : text(100. * covered, " per cent"),
           " runs along the boundary that is not supported; the traction "
           "would be lost. Correct the points."));
}
} // namespace Voussoir
