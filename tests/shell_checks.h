// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_tests_shell_checks_h
#define voussoir_tests_shell_checks_h

#include <voussoir/packing/polyhedra/cell_overlaps.h>
#include <voussoir/packing/polyhedra/face_contacts.h>

#include "block_checks.h"

// What the tests of vaults and domes share, whose blocks need not be convex.

/** The largest coordinate. */
inline double extent_of(const Voussoir::CellFaces &cells)
{
  double extent = 0.;
  for (const auto &p : cells.vertices)
    for (unsigned int d = 0; d < 3; ++d)
      extent = std::max(extent, std::abs(p[d]));
  return extent;
}

/** Area, centroid and normal of a face. */
inline Voussoir::PolygonMoments face_of(const Voussoir::CellFaces &cells,
                                        const unsigned int face)
{
  const auto polygon = cells.polygon(face);
  return Voussoir::moments_of(dealii::make_array_view(polygon));
}

/** The cells that have an edge which is less than 180 degrees outside. */
inline unsigned int n_bent_cells(const Voussoir::CellFaces &cells)
{
  const double tolerance = 1e-9 * extent_of(cells);
  unsigned int n = 0;
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
  {
    bool convex = true;
    for (unsigned int f = cells.first_face[c]; f < cells.first_face[c + 1]; ++f)
    {
      const auto face = face_of(cells, f);
      for (unsigned int k = cells.first_corner[cells.first_face[c]];
           k < cells.first_corner[cells.first_face[c + 1]]; ++k)
        convex &=
            face.normal() * (cells.vertices[cells.loops[k]] - face.centroid) <=
            tolerance;
    }
    n += !convex;
  }
  return n;
}

/** The number of edges at which two faces of a cell lie in one plane. */
inline unsigned int n_flat_edges(const Voussoir::CellFaces &cells)
{
  unsigned int n = 0;
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
  {
    using Edge = std::array<unsigned int, 2>;
    std::map<Edge, unsigned int> face_at;
    for (unsigned int f = cells.first_face[c]; f < cells.first_face[c + 1]; ++f)
      for (unsigned int i = 0; i < cells.n_corners(f); ++i)
        face_at[Edge{{cells.corners(f)[i],
                      cells.corners(f)[(i + 1) % cells.n_corners(f)]}}] = f;
    for (const auto &[edge, f] : face_at)
    {
      const auto back = face_at.find(Edge{{edge[1], edge[0]}});
      n += back != face_at.end() &&
           (face_of(cells, f).normal() - face_of(cells, back->second).normal())
                   .norm() < 1e-6;
    }
  }
  return n;
}

/** Check the shapes of all cells; @p n_bent of them are not convex. */
inline void check_shell(const Voussoir::CellFaces &cells,
                        const double volume,
                        const unsigned int n_bent)
{
  bool closed = true, positive = true;
  double off_plane = 0.;
  const double extent = extent_of(cells);
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
  {
    closed &= open_edges(cells, c).empty();
    positive &= moments_of(cells, c).volume > 0.;
  }
  for (unsigned int f = 0; f < cells.n_faces(); ++f)
  {
    const auto face = face_of(cells, f);
    for (const auto &p : cells.polygon(f))
      off_plane =
          std::max(off_plane, std::abs(face.normal() * (p - face.centroid)));
  }
  check("  closed", closed);
  check("  volumes positive", positive);
  check_error("  faces plane, over the size", off_plane / extent, 1e-14);
  check("  no face in two parts", n_flat_edges(cells) == 0);
  check("  blocks that are not convex", n_bent_cells(cells) == n_bent);
  check("  none in another", overlaps(cells, 1e-9 * extent).empty());
  check_error("  volume", std::abs(volume_of(cells) / volume - 1.), 1e-12);
}

/** Areas in which cells touch. */
struct ContactAreas
{
  double heads = 0.;        /**< of head joints, see contact_areas(); L^2 */
  double beds = 0.;         /**< of all others; L^2 */
  unsigned int n_pairs = 0; /**< of cells that touch */
};

/**
 * The areas in which cells touch. All other faces are free, which is checked.
 *
 * @param is_head tells whether a joint is a head joint from its centroid and
 *   its normal.
 */
inline ContactAreas
contact_areas(const Voussoir::CellFaces &cells,
              const std::function<bool(const dealii::Point<3> &,
                                       const dealii::Tensor<1, 3> &)> &is_head)
{
  const Voussoir::ContactTolerance tolerance = {1e-9 * extent_of(cells)};
  const auto contacts = face_contacts(cells, tolerance);
  ContactAreas areas;
  areas.n_pairs = count_contacts(cells, tolerance).pairs_of_cells;
  for (unsigned int k = 0; k < contacts.patches.size(); ++k)
  {
    const auto patch = Voussoir::moments_of(contacts.patches[k]);
    (is_head(patch.centroid, patch.normal()) ? areas.heads : areas.beds) +=
        patch.area();
  }
  double free = 0., all = 0.;
  for (unsigned int k = 0; k < contacts.free_parts.size(); ++k)
    free += Voussoir::moments_of(contacts.free_parts[k]).area();
  for (unsigned int f = 0; f < cells.n_faces(); ++f)
    all += face_of(cells, f).area();
  check_error("  faces touch or are free",
              std::abs(2. * (areas.heads + areas.beds) + free - all) / all,
              1e-8);
  return areas;
}

/** Check an area against its closed form. */
inline void
check_area(const std::string &what, const double area, const double exact)
{
  check_error(what, std::abs(area - exact) / std::max(exact, 1.), 1e-12);
}

/** The area of all faces whose vertices have the height 0. */
inline double area_on_ground(const Voussoir::CellFaces &cells)
{
  double area = 0.;
  for (unsigned int f = 0; f < cells.n_faces(); ++f)
  {
    const auto polygon = cells.polygon(f);
    if (std::all_of(polygon.begin(), polygon.end(),
                    [](const auto &p) { return p[2] == 0.; }))
      area += face_of(cells, f).area();
  }
  return area;
}

#endif
