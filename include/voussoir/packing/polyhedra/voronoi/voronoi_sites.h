// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_voronoi_voronoi_sites_h
#define voussoir_packing_polyhedra_voronoi_voronoi_sites_h

#include <voussoir/packing/polyhedra/voronoi/convex_polyhedron.h>

#include <array>
#include <vector>

namespace Voussoir
{
/**
 * The four sites that meet in a vertex, ascending, a generator first: three
 * planes, between the first site and each of the others, go through it.
 */
using VertexName = std::array<unsigned int, 4>;

/**
 * What a face of a Voronoi cell has on its other side, numbered in this order:
 * the generators; four guards, points so far away that they change no cell in
 * the domain but make all cells finite; the planes of the domain.
 *
 * Where a vertex is, and on which side of a plane, follows from its name and
 * the coordinates of generators and corners alone, the side exactly: whoever
 * asks gets the same answer.
 */
class VoronoiSites
{
public:
  /**
   * @param generators inside @p domain; lengths.
   * @param domain it must outlive this object.
   */
  VoronoiSites(const std::vector<dealii::Point<3>> &generators,
               const ConvexPolyhedron &domain);

  /** The number of generators, and of the first guard. */
  unsigned int n_generators() const { return points.size() - n_guards; }
  /** The number of generators and guards, and of the first plane. */
  unsigned int n_points() const { return points.size(); }
  /** A generator or guard; lengths. */
  const dealii::Point<3> &point(const unsigned int site) const
  {
    return points[site];
  }
  /** The site that is plane @p k of the domain. */
  unsigned int plane_site(const unsigned int k) const { return n_points() + k; }
  /** True if a site is a plane of the domain. */
  bool is_plane(const unsigned int site) const { return site >= n_points(); }
  /**
   * The unit vector across the face between a generator and another site, out
   * of the cell of the generator, which is the first.
   */
  dealii::Tensor<1, 3>
  direction(const std::array<unsigned int, 2> &sides) const;
  /** The number of planes in which a vertex lies. */
  unsigned int n_planes(const VertexName &name) const
  {
    return is_plane(name[1]) + is_plane(name[2]) + is_plane(name[3]);
  }

  /**
   * A vertex, right to rounding of the size of the domain; exactly in planes
   * that are axis-parallel; a corner of the domain exactly. Lengths.
   */
  dealii::Point<3> place(const VertexName &name) const;

  /**
   * True if a vertex is strictly beyond plane @p k of the domain, without
   * rounding.
   *
   * @param name of the vertex, in which the plane is not.
   * @param place where it is, from place(); lengths.
   */
  bool is_beyond(const VertexName &name,
                 const dealii::Point<3> &place,
                 unsigned int k) const;

  /** True if is_beyond() is false at @p place for every plane. */
  bool is_surely_inside(const dealii::Point<3> &place) const
  {
    return domain.contains(place, 4. * doubtful_distance);
  }

private:
  static constexpr unsigned int n_guards = 4;

  const ConvexPolyhedron &domain;
  std::vector<dealii::Point<3>> points;
  /**
   * The distance from a plane, a length, within which the side is found in
   * rational numbers, for points not farther away than the domain is long.
   */
  double doubtful_distance;
};
} // namespace Voussoir

#endif
