// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/chunks.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/cell_overlaps.h>
#include <voussoir/packing/polyhedra/contacts/cell_probes.h>
#include <voussoir/packing/polyhedra/contacts/convex_cells.h>
#include <voussoir/packing/polyhedra/models/model_defects.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace Voussoir
{
namespace
{
/** Compares pairs of cells. */
class OverlapSearch
{
public:
  explicit OverlapSearch(const FaceGeometry &geometry)
      : geometry(geometry), convex(geometry), probes(geometry)
  {}

  /** The overlaps of some cells with all cells of higher numbers. */
  std::vector<CellOverlap> find(const unsigned int begin,
                                const unsigned int end) const
  {
    std::vector<CellOverlap> found;
    for (unsigned int cell = begin; cell < end; ++cell)
      for (const unsigned int other :
           geometry.boxes.higher_neighbours(cell, 0.))
        if (common_extent(geometry.boxes.of_cell(cell),
                          geometry.boxes.of_cell(other)) > geometry.tolerance)
          if (const auto overlap = compare(cell, other))
            found.push_back(*overlap);
    return found;
  }

private:
  std::optional<CellOverlap> compare(const unsigned int one,
                                     const unsigned int other) const
  {
    if (convex.is_convex(one) && convex.is_convex(other))
    {
      const double depth = convex.overlap_depth(one, other, geometry.tolerance);
      if (!(depth > geometry.tolerance))
        return {};
      return CellOverlap{
          {{one, other}}, depth, convex.common_place(one, other)};
    }
    const InnerPoint of_one = probes.deepest(one, other);
    const InnerPoint of_other = probes.deepest(other, one);
    const InnerPoint &deepest =
        of_one.depth >= of_other.depth ? of_one : of_other;
    if (!(deepest.depth > geometry.tolerance))
      return {};
    return CellOverlap{{{one, other}}, deepest.depth, deepest.place};
  }

  const FaceGeometry &geometry;
  const ConvexCells convex;
  const CellProbes probes;
};
} // namespace

std::vector<CellOverlap> overlaps(const CellFaces &cells,
                                  const double tolerance)
{
  if (!(std::isfinite(tolerance) && tolerance >= 0.))
    throw InputError(text("The tolerance of overlaps is ",
                          text_of_number(tolerance),
                          "; it must be a finite length, not negative."));
  const FaceGeometry geometry(cells, tolerance);
  const OverlapSearch search(geometry);
  std::vector<CellOverlap> all;
  for (const std::vector<CellOverlap> &found :
       in_chunks(cells.n_cells() - cells.n_fixed,
                 [&](const unsigned int begin, const unsigned int end) {
                   return search.find(begin, end);
                 }))
    all.insert(all.end(), found.begin(), found.end());
  return all;
}

std::vector<CellDefect> defects_of(const CellFaces &cells,
                                   const std::vector<CellOverlap> &overlaps)
{
  std::vector<CellDefect> defects;
  for (const CellOverlap &overlap : overlaps)
  {
    ModelDefect defect = {ModelDefect::Kind::overlap, overlap.cells[0]};
    defect.size = overlap.depth;
    defect.place = overlap.place;
    defect.detail = describe_named(cells, overlap.cells[1]);
    defects.push_back(cell_defect(defect));
  }
  return defects;
}

std::string describe_overlaps(const CellFaces &cells,
                              const std::vector<CellOverlap> &overlaps)
{
  if (overlaps.empty())
    return "";
  const CellOverlap &deepest =
      *std::max_element(overlaps.begin(), overlaps.end(),
                        [](const CellOverlap &a, const CellOverlap &b) {
                          return a.depth < b.depth;
                        });
  const std::size_t n_others = overlaps.size() - 1;
  std::string sentence = cells.describe(deepest.cells[0]);
  sentence[0] = std::toupper(sentence[0]);
  return text(sentence, " and ", cells.describe(deepest.cells[1]),
              " penetrate each other by ", deepest.depth, " at ",
              text_of_point(deepest.place),
              n_others > 0
                  ? text("; ", counted(n_others, "more pair"),
                         n_others == 1 ? " does" : " do", " so less deeply")
                  : "",
              ". Move or cut these blocks, or delete what is there twice.");
}
} // namespace Voussoir
