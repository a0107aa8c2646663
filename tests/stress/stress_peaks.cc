// SPDX-License-Identifier: LGPL-2.1-or-later

// The stress on the tetrahedra of random cells under pressure, shear and
// weight: how much larger than the mean stress it is in the root of the mean
// square.

#include <voussoir/stress/linear_stress.h>
#include <voussoir/stress/tetrahedral_stress.h>

#include "../statics/space_scenes.h"

namespace test_stress_peaks
{
using namespace Voussoir;

void run()
{
  // Among these are cells with 24 times their mean stress if slender
  // tetrahedra are kept, eleven with more than 2.5 times, and faces too small
  // for tetrahedra.
  SpaceCase of{cells_in_box(1000, {1., 1., 1.}, 3)};
  of.mu = 0.5;
  dealii::Tensor<2, 3> S;
  S[0][0] = S[1][1] = -3.;
  S[2][2] = -5.;
  S[0][1] = S[1][0] = 0.5;
  const SpaceScene scene(
      of.blocks(), together(tractions(of.packing, S), 1.,
                            body_force(of.packing, vector(0.5, 0.3, -4.))));
  const FaceForces forces = elastic_forces(scene);
  const auto means = cell_mean_stresses(scene, forces);
  const TetrahedralStress found = tetrahedral_stress(scene, forces, means);
  check("All cells have it", found.undetermined.empty());
  unsigned int n_large = 0;
  double worst = 0.;
  for (unsigned int c = 0; c < of.packing.n_cells(); ++c)
  {
    double square = 0.;
    for (std::size_t t = found.first[c]; t < found.first[c + 1]; ++t)
    {
      const auto &x = found.list[t].corners;
      square += cross_product_3d(x[1] - x[0], x[2] - x[0]) * (x[3] - x[0]) /
                6. * found.list[t].stress.norm_square();
    }
    const double ratio =
        std::sqrt(square / of.packing.volume(c)) / means[c].norm();
    n_large += ratio > 2.5;
    worst = std::max(worst, ratio);
  }
  check("Three in a thousand have more than 2.5 times the mean", n_large <= 3);
  check("None has 4.2 times it", worst < 4.2);
}

const RoomTest test("stress_peaks", run);
} // namespace test_stress_peaks
