// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_proofs_force_function_h
#define voussoir_scene_proofs_force_function_h

#include <voussoir/packing/straight_runs.h>
#include <voussoir/scene/proofs/certificate_measures.h>
#include <voussoir/scene/scene.h>

#include <array>
#include <vector>

namespace Voussoir
{
/** A linear function of the forces of the interfaces and the links. */
struct ForceFunction
{
  /** What the forces of an interface are multiplied by. */
  struct Term
  {
    /** Its number. */
    unsigned int interface;
    /** For the normal force at its start and at its end. */
    std::array<double, 2> at_ends;
    /** For f_e^t. */
    double tangential;
  };
  /** Each interface has at most one. */
  std::vector<Term> terms;
  /** What the force of a link is multiplied by. */
  struct LinkTerm
  {
    /** Its number. */
    unsigned int link;
    /** That. */
    double factor;
  };
  /** Each link has at most one. */
  std::vector<LinkTerm> links = {};

  /** This function times @p factor. */
  ForceFunction times(double factor) const;
  /** Its value; S L. */
  double operator()(const InterfaceForces &forces) const;
};

/** f_e^n of interface @p e. */
ForceFunction normal_force(unsigned int e);
/**
 * The couple of the normal force of interface @p e about a place on it, the
 * fraction @p at of its length from its midpoint, over its length: positive
 * where the resultant is beyond it, towards the end.
 */
ForceFunction couple_about(unsigned int e, double at);
/** f_e^t of interface @p e. */
ForceFunction tangential_force(unsigned int e);
/** The force of link @p k. */
ForceFunction force_of_link(unsigned int k);
/**
 * The force of the ground on the packing along a straight support in the
 * direction @p direction; see reactions().
 */
ForceFunction reaction(const Packing<2> &packing,
                       const StraightRun &support,
                       const dealii::Tensor<1, 2> &direction);

/**
 * The bound of @p function that @p motion proves: for all forces that are in
 * equilibrium with the loads, work of the motion included,
 *
 *     sum_e a_e . f_e = sum_e f_e . (a_e + [u]_e) - sum_c F_c . u_c,
 *
 * and no admissible forces have more of the first sum than the joints resist
 * the jumps a_e + [u]_e. By code that no solver shares.
 *
 * @param motion of any kind; its unit is that of a force function, one.
 */
ForceBound bound_of(const Scene &scene,
                    const ForceFunction &function,
                    const Motion &motion);
} // namespace Voussoir

#endif
