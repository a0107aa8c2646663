// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_proofs_utilisation_h
#define voussoir_scene_proofs_utilisation_h

#include <voussoir/scene/scene.h>

namespace Voussoir
{
/**
 * The share of the friction of each interface that a state uses,
 * |f_e^t| over JointLimits::shear_strength(). A tangential force that is
 * rounding beside the largest force of the state counts as none: the ratio of
 * two such forces says nothing.
 */
class Utilisation
{
public:
  /** Of @p forces, which must outlive the object, as the @p scene must. */
  Utilisation(const Scene &scene, const InterfaceForces &forces);

  /** The utilisation of interface @p e, 1 at its limit. */
  double operator()(unsigned int e) const;

private:
  const Scene &scene;
  const InterfaceForces &forces;
  double rounding = 0.;
};
} // namespace Voussoir

#endif
