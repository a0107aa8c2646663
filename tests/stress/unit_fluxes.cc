// SPDX-License-Identifier: LGPL-2.1-or-later

// The fields of Raviart and Thomas on random tetrahedra, with their integrals
// of products, and those of Intrepid2, Trilinos' library of elements.

#include <voussoir/base/random.h>
#include <voussoir/stress/unit_fluxes.h>

#include "tests.h"
#include <Intrepid2_CellTools.hpp>
#include <Intrepid2_DefaultCubatureFactory.hpp>
#include <Intrepid2_FunctionSpaceTools.hpp>
#include <Intrepid2_HDIV_TET_I1_FEM.hpp>
#include <Shards_CellTopology.hpp>
#include <array>
#include <vector>

namespace test_unit_fluxes
{
using namespace Voussoir;
using dealii::Point;

using Device = Kokkos::HostSpace::device_type;
using View = Kokkos::DynRankView<double, Device>;
using Cells = Intrepid2::CellTools<Device>;
using Functions = Intrepid2::FunctionSpaceTools<Device>;

constexpr unsigned int n_tetrahedra = 1000;
/** Flat ones have fewer digits in either library. */
constexpr double least_volume = 0.01;
/**
 * The corners of Intrepid2's tetrahedron in the order of UnitFluxes, where the
 * first three run counterclockwise; and the corner there that is opposite to
 * facet k of Intrepid2, of which the field has the flux one half.
 */
constexpr std::array<unsigned int, 4> corner = {{1, 0, 2, 3}},
                                      opposite = {{2, 1, 0, 3}};
constexpr double flux = 0.5;

/** Random corners. */
UnitFluxes random_tetrahedron(Random &random, std::array<Point<3>, 4> &x)
{
  while (true)
  {
    for (Point<3> &point : x)
      for (unsigned int d = 0; d < 3; ++d)
        point[d] = random();
    const UnitFluxes fields(x);
    if (fields.volume > least_volume)
      return fields;
  }
}

void compare()
{
  const shards::CellTopology topology(
      shards::getCellTopologyData<shards::Tetrahedron<4>>());
  Intrepid2::Basis_HDIV_TET_I1_FEM<Device, double, double> basis;
  const auto rule =
      Intrepid2::DefaultCubatureFactory::create<Device>(topology, 2);
  const unsigned int n_points = rule->getNumPoints();
  View points("points", n_points, 3), weights("weights", n_points);
  rule->getCubature(points, weights);

  Random random(1);
  View corners("corners", n_tetrahedra, 4, 3);
  std::vector<UnitFluxes> fields;
  for (unsigned int c = 0; c < n_tetrahedra; ++c)
  {
    std::array<Point<3>, 4> x;
    fields.push_back(random_tetrahedron(random, x));
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int d = 0; d < 3; ++d)
        corners(c, i, d) = x[corner[i]][d];
  }

  View jacobian("jacobian", n_tetrahedra, n_points, 3, 3),
      determinant("determinant", n_tetrahedra, n_points),
      measure("measure", n_tetrahedra, n_points),
      places("places", n_tetrahedra, n_points, 3),
      reference("reference", 4, n_points, 3),
      values("values", n_tetrahedra, 4, n_points, 3),
      weighted("weighted", n_tetrahedra, 4, n_points, 3),
      products("products", n_tetrahedra, 4, 4);
  Cells::setJacobian(jacobian, points, corners, topology);
  Cells::setJacobianDet(determinant, jacobian);
  Cells::mapToPhysicalFrame(places, points, corners, topology);
  basis.getValues(reference, points, Intrepid2::OPERATOR_VALUE);
  Functions::HDIVtransformVALUE(values, jacobian, determinant, reference);
  Functions::computeCellMeasure(measure, determinant, weights);
  Functions::multiplyMeasure(weighted, measure, values);
  Functions::integrate(products, values, weighted);

  double of_values = 0., of_products = 0.;
  for (unsigned int c = 0; c < n_tetrahedra; ++c)
  {
    // Relative to the largest.
    double value_error = 0., product_error = 0., largest = 0.,
           largest_product = 0.;
    for (unsigned int k = 0; k < 4; ++k)
    {
      const unsigned int i = opposite[k];
      for (unsigned int p = 0; p < n_points; ++p)
      {
        Point<3> place;
        for (unsigned int d = 0; d < 3; ++d)
          place[d] = places(c, p, d);
        const auto value = fields[c].value(i, place);
        largest = std::max(largest, value.norm());
        for (unsigned int d = 0; d < 3; ++d)
          value_error = std::max(
              value_error, std::abs(values(c, k, p, d) - flux * value[d]));
      }
      for (unsigned int l = 0; l < 4; ++l)
      {
        const double product = fields[c].product(i, opposite[l]);
        largest_product = std::max(largest_product, std::abs(product));
        product_error = std::max(
            product_error, std::abs(products(c, k, l) - flux * flux * product));
      }
    }
    of_values = std::max(of_values, value_error / largest);
    of_products = std::max(of_products, product_error / largest_product);
  }
  check_error("values", of_values, 1e-13);
  check_error("products", of_products, 1e-13);
}

void run()
{
  // Later versions of deal.II have begun it.
  const bool begins = !Kokkos::is_initialized();
  if (begins)
    Kokkos::initialize();
  compare();
  if (begins)
    Kokkos::finalize();
}

const RoomTest test("unit_fluxes", run);
} // namespace test_unit_fluxes
