// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/models/mend_surface.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Voussoir
{
using DefectKind = ModelDefect::Kind;

namespace
{
/**
 * The volume over the area and the size of a block below which it has none:
 * what is left of it is the rounding of a flat one.
 */
constexpr double least_relative_thickness = 1e-12;

/** Two faces with a common edge, which they may run along the same way. */
struct AdjacentFaces
{
  unsigned int face, neighbour;
  bool disagree;
};

/** What is wrong with the edges of a surface; empty if it is closed. */
std::vector<ModelDefect> faults_of_edges(const Surface &surface,
                                         const std::vector<FaceSide> &sides)
{
  ModelDefect open = {DefectKind::open}, branching = {DefectKind::branching},
              bridged = {DefectKind::bridged_face};
  for (ModelDefect *const defect : {&open, &branching, &bridged})
    defect->count = 0;
  for (std::size_t k = 0; k < sides.size();)
  {
    const std::size_t end = end_of_edge(sides, k);
    const bool is_twice = end == k + 2 && sides[k].face == sides[k + 1].face;
    ModelDefect *const defect = is_twice       ? &bridged
                                : end == k + 1 ? &open
                                : end > k + 2  ? &branching
                                               : nullptr;
    if (defect != nullptr && defect->count++ == 0)
    {
      const dealii::Point<3> &a = surface.vertices[sides[k].low];
      const dealii::Point<3> &b = surface.vertices[sides[k].high];
      defect->face = surface.source[sides[k].face];
      defect->place = a + 0.5 * (b - a);
    }
    k = end;
  }
  std::vector<ModelDefect> faults;
  for (const ModelDefect &defect : {open, branching, bridged})
    if (defect.count > 0)
      faults.push_back(defect);
  return faults;
}

/** The pairs of faces of a closed surface, in both orders, by faces. */
std::vector<AdjacentFaces> pairs_of(const std::vector<FaceSide> &sides)
{
  std::vector<AdjacentFaces> pairs;
  pairs.reserve(sides.size());
  for (std::size_t k = 0; k + 1 < sides.size(); k += 2)
  {
    const bool disagree = sides[k].is_forward == sides[k + 1].is_forward;
    pairs.push_back({sides[k].face, sides[k + 1].face, disagree});
    pairs.push_back({sides[k + 1].face, sides[k].face, disagree});
  }
  std::sort(pairs.begin(), pairs.end(),
            [](const AdjacentFaces &a, const AdjacentFaces &b) {
              return a.face < b.face ||
                     (a.face == b.face && a.neighbour < b.neighbour);
            });
  return pairs;
}

/** How faces have to be turned to agree with each other. */
struct Agreement
{
  std::vector<bool> is_turned;
  /** The connected part of each face, by the first face of it. */
  std::vector<unsigned int> part;
  /** A face that cannot agree with its neighbours; or the number of faces. */
  unsigned int contradiction;
};

Agreement agreement_of(const unsigned int n_faces,
                       const std::vector<AdjacentFaces> &pairs)
{
  Agreement agreement = {std::vector<bool>(n_faces, false),
                         std::vector<unsigned int>(n_faces, n_faces), n_faces};
  std::vector<unsigned int> queue;
  for (unsigned int seed = 0; seed < n_faces; ++seed)
  {
    if (agreement.part[seed] != n_faces)
      continue;
    queue = {seed};
    agreement.part[seed] = seed;
    for (std::size_t k = 0; k < queue.size(); ++k)
    {
      const unsigned int f = queue[k];
      auto pair =
          std::lower_bound(pairs.begin(), pairs.end(), f,
                           [](const AdjacentFaces &p, const unsigned int face) {
                             return p.face < face;
                           });
      for (; pair != pairs.end() && pair->face == f; ++pair)
      {
        const unsigned int g = pair->neighbour;
        const bool is_turned = agreement.is_turned[f] != pair->disagree;
        if (agreement.part[g] == n_faces)
        {
          agreement.part[g] = seed;
          agreement.is_turned[g] = is_turned;
          queue.push_back(g);
        }
        else if (agreement.is_turned[g] != is_turned)
          agreement.contradiction = std::min(agreement.contradiction, g);
      }
    }
  }
  return agreement;
}

/** Turn whole parts of a surface whose volume would be negative. */
void turn_inside_in(const Surface &surface, Agreement &agreement)
{
  const unsigned int n = surface.faces.size();
  std::vector<double> volume(n, 0.); // of the part that begins with a face
  for (unsigned int f = 0; f < n; ++f)
  {
    const unsigned int part = agreement.part[f];
    const dealii::Point<3> &origin = surface.vertices[surface.faces[part][0]];
    const auto loop = surface.faces[f];
    const dealii::Tensor<1, 3> a = surface.vertices[loop[0]] - origin;
    for (unsigned int i = 1; i + 1 < loop.size(); ++i)
      volume[part] += (agreement.is_turned[f] ? -1. : 1.) * a *
                      cross_product_3d(surface.vertices[loop[i]] - origin,
                                       surface.vertices[loop[i + 1]] - origin);
  }
  for (unsigned int f = 0; f < n; ++f)
    if (volume[agreement.part[f]] < 0.)
      agreement.is_turned[f] = !agreement.is_turned[f];
}
} // namespace

void orient(MendedSurface &mended)
{
  Surface &surface = mended.surface;
  if (surface.faces.size() < least_faces_of_polyhedron)
  {
    mended.defects.push_back({DefectKind::no_volume, 0, 1,
                              dealii::numbers::invalid_unsigned_int, 0.,
                              surface.vertices[surface.faces.corners[0]]});
    return;
  }
  const std::vector<FaceSide> sides = sides_of(surface.faces);
  const std::vector<ModelDefect> faults = faults_of_edges(surface, sides);
  mended.defects.insert(mended.defects.end(), faults.begin(), faults.end());
  if (!faults.empty())
    return;
  Agreement agreement = agreement_of(surface.faces.size(), pairs_of(sides));
  if (const unsigned int f = agreement.contradiction; f < surface.faces.size())
  {
    mended.defects.push_back({DefectKind::one_sided, 0, 1, surface.source[f],
                              0., surface.vertices[surface.faces[f][0]]});
    return;
  }
  turn_inside_in(surface, agreement);
  ModelDefect turned = {DefectKind::turned_face};
  turned.count = 0;
  for (unsigned int f = 0; f < surface.faces.size(); ++f)
    if (agreement.is_turned[f])
    {
      const auto begin = surface.faces.corners.begin() + surface.faces.first[f];
      std::reverse(begin + 1,
                   surface.faces.corners.begin() + surface.faces.first[f + 1]);
      if (turned.count++ == 0)
      {
        turned.face = surface.source[f];
        turned.place = surface.vertices[*begin];
      }
    }
  if (turned.count > 0)
    mended.defects.push_back(turned);
  const SurfaceSums sums = sums_of(surface);
  if (!(sums.volume >
        least_relative_thickness * sums.area * diagonal_of(surface.vertices)))
    mended.defects.push_back({DefectKind::no_volume, 0, 1,
                              dealii::numbers::invalid_unsigned_int,
                              sums.area > 0. ? sums.volume / sums.area : 0.,
                              surface.vertices[surface.faces.corners[0]]});
}
} // namespace Voussoir
