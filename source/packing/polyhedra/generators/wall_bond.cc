// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/generators/wall_bond.h>

#include <cmath>

namespace Voussoir
{
namespace
{
// In quarters of a stretcher, and in brick widths.
constexpr unsigned int stretcher_length = quarters_of_brick;
constexpr unsigned int header_width = stretcher_length / 2;
constexpr unsigned int header_depth = 2;
/** The end of a header and a closer, with which a row begins. */
constexpr unsigned int end_of_closer = header_width + 1;

/** Stretchers, @p n_across of them side by side, with a joint at @p shift. */
RowPattern stretchers(const unsigned int shift, const unsigned int n_across)
{
  return {stretcher_length, {{shift, n_across}}};
}

/**
 * Headers that begin at the end of the wall, or behind a closer; also at the
 * right end if the courses of stretchers end with a whole one there.
 */
RowPattern headers(const bool has_closers)
{
  if (has_closers)
    return {header_width, {{1, 1}}, RowPattern::Closers{0, stretcher_length}};
  return {header_width, {{0, 1}}};
}

RowPattern flemish_row(const bool odd)
{
  const unsigned int period = stretcher_length + header_width;
  if (odd)
    return {period,
            {{1, 1}, {end_of_closer, 2}},
            RowPattern::Closers{stretcher_length, period}};
  return {period, {{0, 2}, {stretcher_length, 1}}};
}

/**
 * In odd courses all joints are at odd positions, but for that of the header
 * beside a closer; in even courses they are at even ones.
 */
std::vector<BondRow> english_rows(const bool odd, const unsigned int n_widths)
{
  std::vector<BondRow> rows;
  unsigned int depth = 0;
  const auto add = [&](const unsigned int thickness, RowPattern pattern) {
    rows.push_back({depth, depth + thickness, std::move(pattern)});
    depth += thickness;
  };
  const RowPattern row_of_stretchers =
      stretchers(odd ? stretcher_length - 1 : 0, 1);
  if (!odd)
    add(1, row_of_stretchers);
  while (depth + header_depth <= n_widths)
    add(header_depth, headers(odd));
  if (depth < n_widths)
    add(1, row_of_stretchers);
  return rows;
}
} // namespace

bool RowPattern::is_regular_joint(const unsigned int quarter) const
{
  for (const Joint &joint : joints)
    if (quarter % period == joint.at)
      return true;
  return false;
}

bool RowPattern::ends_with_closer(
    const std::optional<unsigned int> length) const
{
  return closers && length && *length % closers->modulo == closers->remainder;
}

bool RowPattern::is_joint(const unsigned int quarter,
                          const std::optional<unsigned int> length) const
{
  if (!closers)
    return is_regular_joint(quarter);
  const bool ends_so = ends_with_closer(length);
  if (quarter == header_width || (ends_so && quarter + header_width == *length))
    return true;
  return quarter >= end_of_closer &&
         (!ends_so || quarter + end_of_closer <= *length) &&
         is_regular_joint(quarter);
}

unsigned int
RowPattern::n_across(const double quarter,
                     const std::optional<unsigned int> length) const
{
  if (closers &&
      (quarter < end_of_closer ||
       (ends_with_closer(length) && quarter + end_of_closer > *length)))
    return 1;
  const double place = std::fmod(quarter, double(period));
  unsigned int n = joints.back().n_across; // from before the period
  for (const Joint &joint : joints)
    if (joint.at < place)
      n = joint.n_across;
  return n;
}

std::vector<BondRow> rows_of_course(const WallBond bond,
                                    const unsigned int course,
                                    const unsigned int n_widths)
{
  const bool odd = course % 2 == 1;
  switch (bond)
  {
  case WallBond::running:
    return {
        {0, n_widths, stretchers(odd ? stretcher_length / 2 : 0, n_widths)}};
  case WallBond::stack: return {{0, n_widths, stretchers(0, n_widths)}};
  case WallBond::header:
    return {{0,
             n_widths,
             {header_width, {{odd ? 1U : 0U, n_widths / header_depth}}}}};
  case WallBond::English: return english_rows(odd, n_widths);
  case WallBond::Flemish: return {{0, n_widths, flemish_row(odd)}};
  }
  return {};
}
} // namespace Voussoir
