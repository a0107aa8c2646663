// SPDX-License-Identifier: LGPL-2.1-or-later

// Which displacements prove that a load is not carried. In the shear wall of
// strength s, sliding of the courses does 1/s times the work that friction can
// dissipate; pulling a packing apart dissipates nothing.

#include <voussoir/statics/problem/mechanism.h>

#include "tests.h"

namespace test_mechanism_proofs
{
using namespace Voussoir;

/** u_c = G x_c, cell by cell. */
std::vector<double> affine(const Packing<2> &packing,
                           const dealii::Tensor<2, 2> &G)
{
  std::vector<double> u;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    for (unsigned int i = 0; i < 2; ++i)
      u.push_back(G[i] * packing.centre(c));
  return u;
}

void try_proof(const std::string &what,
               const Scene &scene,
               const dealii::Tensor<2, 2> &G)
{
  const auto mechanism =
      find_mechanism(discretise(scene), affine(scene.packing, G));
  std::cout << what << ": ";
  if (!mechanism)
  {
    std::cout << "no proof" << std::endl;
    return;
  }
  const MechanismCertificate proof = certify_mechanism(
      scene, dimensional_motion(discretise(scene), *mechanism));
  std::cout << "proof, ratio ";
  if (proof.work_over_dissipation < 1e12)
    std::cout << proof.work_over_dissipation;
  else
    std::cout << "without bound";
  std::cout << ", closing "
            << (proof.closing_violation <= 1e-14 ? "none" : "FAILED")
            << std::endl;
}

void run()
{
  const auto shear = tensor(0, 1, 0, 0);
  try_proof("sliding, s = 0.5", shear_wall(0.5), shear);
  try_proof("sliding, s = 0.999", shear_wall(0.999), shear);
  try_proof("sliding, s = 1.001", shear_wall(1.001), shear);
  try_proof("sliding backwards", shear_wall(0.5), -shear);
  try_proof("no motion", shear_wall(0.5), tensor(0, 0, 0, 0));
  try_proof("a translation", shear_wall(0.5), tensor(0, 0, 0, 0) * 1e300);

  // A closing motion is opened by a dilation, which pressure resists.
  const auto pressure = tensor(-1, 0, 0, -1), tension = tensor(1, 0, 0, 1);
  const Scene pressed = scene_under_stress(random_packing(30, 1), 1, pressure);
  const Scene pulled = scene_under_stress(random_packing(30, 1), 1, tension);
  try_proof("pressing, closing", pressed, pressure);
  try_proof("pressing, opening", pressed, tension);
  try_proof("pulling, opening", pulled, tension);

  // A closing motion of two cells is a translation once it has been opened;
  // what rounding leaves of it proves nothing.
  for (const double strength : {0., 1.})
    try_proof("closing of two cells",
              scene_under_stress(random_packing(2, 1), strength, pressure),
              pressure);
}

const RoomTest test("mechanism_proofs", run);
} // namespace test_mechanism_proofs
