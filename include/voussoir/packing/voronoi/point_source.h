// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_voronoi_point_source_h
#define voussoir_packing_voronoi_point_source_h

#include <voussoir/base/random.h>
#include <voussoir/packing/voronoi/cell_size.h>

#include <deal.II/base/point.h>

#include <array>
#include <optional>
#include <vector>

namespace Voussoir
{
/** A triangle or a tetrahedron with an upper bound of the density in it. */
template <int dim>
struct Simplex
{
  /** Its corners; lengths. */
  std::array<dealii::Point<dim>, dim + 1> corners;
  /** Area or volume, positive; L^dim. */
  double measure;
  /** The bound, in units of the density at the reference size. */
  double bound;

  /**
   * The point with the barycentric coordinate @p parts[i] for corner i + 1;
   * lengths.
   */
  dealii::Point<dim> at(const std::array<double, dim> &parts) const;
};

/**
 * Draws points with a density proportional to h^-dim, where h is a CellSize.
 *
 * The domain comes in simplices, with a bound of the density in each, from its
 * values at the corners and in the middle. A point is drawn from a simplex in
 * proportion to measure times bound, and kept with the probability density over
 * bound. Where the density is found to be above the bound, the bound is raised
 * and all points are drawn again, so that those returned have obeyed the bounds
 * throughout.
 */
template <int dim>
class PointSource
{
public:
  /**
   * @param size h; it must outlive this object.
   * @param reference a point of the domain, whose density is one; lengths.
   * @throws InputError naming the place if h is not finite and positive.
   */
  PointSource(const CellSize<dim> &size, const dealii::Point<dim> &reference)
      : size(size), reference_size(size(reference))
  {}

  /**
   * Add a part of the domain.
   *
   * @param corners lengths.
   * @param measure area or volume, positive; L^dim.
   * @throws InputError naming the place if h is not finite and positive.
   */
  void add(const std::array<dealii::Point<dim>, dim + 1> &corners,
           double measure);

  /**
   * Draw @p n points; a @p seed gives the same ones.
   *
   * @throws InputError naming the place if h is not finite and positive, or
   *   seems to vanish.
   */
  std::vector<dealii::Point<dim>> draw(unsigned int n, unsigned int seed);

private:
  double density(const dealii::Point<dim> &p) const;
  void raise_bound(Simplex<dim> &simplex, double bound) const;
  std::optional<dealii::Point<dim>>
  try_to_draw(std::vector<dealii::Point<dim>> &points, unsigned int seed);

  const CellSize<dim> &size;
  double reference_size;
  std::vector<Simplex<dim>> simplices;
};
} // namespace Voussoir

#endif
