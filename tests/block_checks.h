// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_tests_block_checks_h
#define voussoir_tests_block_checks_h

#include <voussoir/packing/polyhedra/cell_moments.h>
#include <voussoir/packing/polyhedra/cell_overlaps.h>
#include <voussoir/packing/polyhedra/face_contacts.h>
#include <voussoir/packing/polyhedra/space_polygons.h>

#include <deal.II/base/bounding_box.h>

#include "tests.h"
#include "volumes.h"
#include <map>

// What the tests of generators in space share.

using Box3 = dealii::BoundingBox<3>;

/** The cells of a generator with the settings "set Entry = value". */
template <typename Generator>
Voussoir::CellFaces generated(const std::string &settings)
{
  Generator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.parse_input_from_string(settings);
  return generator.generate("", Voussoir::Terminal::silent());
}

/** The boxes around the cells. */
inline std::vector<Box3> boxes_of(const Voussoir::CellFaces &cells)
{
  std::vector<Box3> boxes;
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
  {
    std::vector<dealii::Point<3>> corners;
    for (unsigned int f = cells.first_face[c]; f < cells.first_face[c + 1]; ++f)
      for (const unsigned int v : cells.corners(f))
        corners.push_back(cells.vertices[v]);
    boxes.emplace_back(corners);
  }
  return boxes;
}

/** The extent of a box along an axis; negative if it is none. */
inline double common_extent(const Box3 &a, const Box3 &b, const unsigned int d)
{
  return std::min(a.upper_bound(d), b.upper_bound(d)) -
         std::max(a.lower_bound(d), b.lower_bound(d));
}

/** The number of pairs of boxes that have a volume in common. */
inline unsigned int n_overlapping(const std::vector<Box3> &boxes)
{
  unsigned int n = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      n += common_extent(boxes[i], boxes[j], 0) > 0. &&
           common_extent(boxes[i], boxes[j], 1) > 0. &&
           common_extent(boxes[i], boxes[j], 2) > 0.;
  return n;
}

/** The area in which boxes touch at faces normal to an axis. */
inline double area_between(const std::vector<Box3> &boxes,
                           const unsigned int axis)
{
  double area = 0.;
  for (const Box3 &a : boxes)
    for (const Box3 &b : boxes)
      if (a.upper_bound(axis) == b.lower_bound(axis))
      {
        const double u = common_extent(a, b, (axis + 1) % 3);
        const double v = common_extent(a, b, (axis + 2) % 3);
        if (u > 0. && v > 0.)
          area += u * v;
      }
  return area;
}

/** The number of cells of each group that has any. */
inline std::map<std::string, unsigned int>
group_sizes(const Voussoir::CellFaces &cells)
{
  std::map<std::string, unsigned int> sizes;
  for (const unsigned int group : cells.group)
    ++sizes[cells.group_names[group]];
  return sizes;
}

/**
 * The area in which cells touch, times the sizes of the components of its
 * normal; L^2. All faces touch or are free, which is checked.
 */
inline dealii::Tensor<1, 3> areas_of_contacts(const Voussoir::CellFaces &cells)
{
  const auto contacts = face_contacts(cells, {cells.tolerance});
  dealii::Tensor<1, 3> areas;
  double free = 0., touching = 0., all = 0.;
  for (unsigned int k = 0; k < contacts.patches.size(); ++k)
  {
    const auto patch = Voussoir::moments_of(contacts.patches[k]);
    touching += patch.area();
    for (unsigned int d = 0; d < 3; ++d)
      areas[d] += std::abs(patch.vector_area[d]);
  }
  for (unsigned int k = 0; k < contacts.free_parts.size(); ++k)
    free += Voussoir::moments_of(contacts.free_parts[k]).area();
  for (unsigned int f = 0; f < cells.n_faces(); ++f)
  {
    const auto polygon = cells.polygon(f);
    all += Voussoir::moments_of(dealii::make_array_view(polygon)).area();
  }
  check_error("  faces touch or are free",
              std::abs(2. * touching + free - all) / all, 1e-12);
  return areas;
}

/**
 * Check the contacts of boxes against the areas of the pairs that touch.
 *
 * @return areas_of_contacts().
 */
inline dealii::Tensor<1, 3> check_contacts(const Voussoir::CellFaces &cells)
{
  const std::vector<Box3> boxes = boxes_of(cells);
  check("  no overlaps",
        n_overlapping(boxes) == 0 && overlaps(cells, cells.tolerance).empty());
  const dealii::Tensor<1, 3> areas = areas_of_contacts(cells);
  double error = 0.;
  for (unsigned int d = 0; d < 3; ++d)
  {
    const double area = area_between(boxes, d);
    error = std::max(error, std::abs(areas[d] - area) / std::max(area, 1e-3));
  }
  check_error("  areas of contacts", error, 1e-12);
  return areas;
}

/** Check that all cells are closed, convex, turned outwards and plane-faced. */
inline void check_blocks(const Voussoir::CellFaces &cells, const double volume)
{
  bool closed = true, positive = true;
  double off_plane = 0., outside = 0.;
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
  {
    const Voussoir::CellMoments moments = moments_of(cells, c);
    closed &= open_edges(cells, c).empty();
    positive &= moments.volume > 0.;
    const double size = std::cbrt(moments.volume);
    for (unsigned int f = cells.first_face[c]; f < cells.first_face[c + 1]; ++f)
    {
      const auto polygon = cells.polygon(f);
      const auto face = Voussoir::moments_of(dealii::make_array_view(polygon));
      for (unsigned int g = cells.first_face[c]; g < cells.first_face[c + 1];
           ++g)
        for (const unsigned int v : cells.corners(g))
        {
          const double above =
              face.normal() * (cells.vertices[v] - face.centroid) / size;
          outside = std::max(outside, above);
          if (g == f)
            off_plane = std::max(off_plane, std::abs(above));
        }
    }
  }
  check("  closed", closed);
  check("  volumes positive", positive);
  check_error("  faces plane", off_plane, 1e-13);
  check_error("  convex", outside, 1e-13);
  check("  a group for each cell", cells.group.size() == cells.n_cells());
  check_error("  volume", std::abs(volume_of(cells) / volume - 1.), 1e-12);
}

#endif
