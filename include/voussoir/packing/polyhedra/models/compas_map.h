// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_models_compas_map_h
#define voussoir_packing_polyhedra_models_compas_map_h

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <nlohmann/json.hpp>

#include <optional>

namespace Voussoir
{
/** A map of places in space, x -> A x + b. */
struct AffineMap
{
  /** The matrix; a number. */
  dealii::Tensor<2, 3> A = dealii::unit_symmetric_tensor<3>();
  /** The place of the origin; a length. */
  dealii::Tensor<1, 3> b;

  /** The image of a place; lengths. */
  dealii::Point<3> operator()(const dealii::Point<3> &x) const
  {
    return dealii::Point<3>(A * x + b);
  }
  /** This map, after @p inner. */
  AffineMap after(const AffineMap &inner) const
  {
    AffineMap map;
    map.A = A * inner.A;
    map.b = A * inner.b + b;
    return map;
  }
};

/**
 * The map that a transformation of COMPAS is; none if it is not there.
 *
 * @throws CompasFault if it is no matrix of 4 by 4 numbers of such a map, or
 *   one without an inverse.
 */
std::optional<AffineMap> compas_map(const nlohmann::ordered_json *tree);
} // namespace Voussoir

#endif
