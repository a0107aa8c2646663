// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/certificate.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
using dealii::Tensor;

Certificate certify(const Scene &scene, const InterfaceForces &forces)
{
  const Packing &packing = scene.packing;
  Certificate certificate;

  // A NaN would slip through every comparison below.
  for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
    if (!std::isfinite(forces.normal[e]) ||
        !std::isfinite(forces.tangential[e]))
    {
      const double infinity = std::numeric_limits<double>::infinity();
      return {infinity, infinity, infinity, infinity};
    }

  double reference = 0.;
  for (const Tensor<1, 2> &F : scene.load)
    reference = std::max(reference, F.norm());
  if (!(reference > 0.))
    for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
      reference = std::max({reference, std::abs(forces.normal[e]),
                            std::abs(forces.tangential[e])});
  if (!(reference > 0.))
    return certificate; // neither loads nor forces

  std::vector<Tensor<1, 2>> sum = scene.load;
  sum.emplace_back(); // of the ground, which takes any force
  double violation = 0.;
  for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
  {
    const Packing::Interface &i = packing.interfaces()[e];
    const Tensor<1, 2> f = forces.on_cell_minus(i, e);
    sum[i.cell_minus] += f;
    sum[i.cell_plus] -= f;
    violation = std::max(
        {violation, forces.normal[e],
         std::abs(forces.tangential[e]) - scene.strength[e] * i.length});
    certificate.max_utilisation =
        std::max(certificate.max_utilisation, utilisation(scene, forces, e));
  }
  certificate.admissibility_violation = violation / reference;

  const std::vector<double> torques = residual_torques(scene, forces);
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    certificate.equilibrium_residual =
        std::max(certificate.equilibrium_residual, sum[c].norm() / reference);
    certificate.max_torque = std::max(
        certificate.max_torque,
        std::abs(torques[c]) / (reference * std::sqrt(packing.area(c))));
  }
  return certificate;
}

MechanismCertificate certify_mechanism(const Scene &scene,
                                       std::vector<Tensor<1, 2>> displacement)
{
  double largest = 0., closing = 0., work = 0., dissipation = 0.;
  for (unsigned int c = 0; c < displacement.size(); ++c)
  {
    largest = std::max(largest, displacement[c].norm());
    work += scene.load[c] * displacement[c];
  }
  displacement.emplace_back(); // the ground does not move
  for (unsigned int e = 0; e < scene.packing.interfaces().size(); ++e)
  {
    const Packing::Interface &i = scene.packing.interfaces()[e];
    const Tensor<1, 2> jump =
        displacement[i.cell_plus] - displacement[i.cell_minus];
    closing = std::max(closing, -(jump * i.normal));
    dissipation += scene.strength[e] * i.length * std::abs(jump * i.tangent());
  }

  MechanismCertificate certificate;
  if (largest > 0.)
    certificate.closing_violation = closing / largest;
  if (work > 0.)
    certificate.work_over_dissipation =
        dissipation > 0. ? work / dissipation
                         : std::numeric_limits<double>::infinity();
  return certificate;
}
} // namespace Voussoir
