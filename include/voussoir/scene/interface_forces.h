// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_interface_forces_h
#define voussoir_scene_interface_forces_h

#include <voussoir/packing/packing.h>

#include <array>
#include <vector>

namespace Voussoir
{
/**
 * The forces of the interfaces, in the order of Packing::interfaces(): f_e^n,
 * negative in compression, and f_e^t. Per unit thickness, S L, unless they are
 * said to be nondimensional, as those of a Solution are. The force on cell c+
 * is minus that on cell c-, which is f_e^n n_e + f_e^t t_e.
 */
struct InterfaceForces
{
  /** f_e^n of each interface, <= 0 in compression. */
  std::vector<double> normal;
  /**
   * What of it acts at the start and at the end of each interface, <= 0; empty
   * where blocks do not turn, and it acts at the midpoint.
   */
  std::vector<std::array<double, 2>> at_ends;
  /** f_e^t of each interface, |f_e^t| <= s_e |e|. */
  std::vector<double> tangential;
  /** The force of each of Scene::links, positive in tension. */
  std::vector<double> in_links = {};

  /** True if there are none. */
  bool empty() const { return normal.empty(); }
  /** The normal force at the ends of interface @p e; halves without at_ends. */
  std::array<double, 2> ends(const unsigned int e) const
  {
    return at_ends.empty()
               ? std::array<double, 2>{{0.5 * normal[e], 0.5 * normal[e]}}
               : at_ends[e];
  }

  /**
   * The force on cell c- of interface @p e, f_e^n n_e + f_e^t t_e.
   *
   * @param interface that of the number @p e.
   */
  dealii::Tensor<1, 2> on_cell_minus(const Packing<2>::Interface &interface,
                                     unsigned int e) const;
  /**
   * The torque about @p centre of the force on cell c- of interface @p e,
   * positive counterclockwise.
   */
  double torque_on_cell_minus(const Packing<2>::Interface &interface,
                              unsigned int e,
                              const dealii::Point<2> &centre) const;
  /**
   * The place of the resultant on an interface, over its length: -1/2 at its
   * start, 0 at its midpoint, 1/2 at its end; zero without normal force.
   */
  double eccentricity(const Packing<2>::Interface &interface,
                      const unsigned int e) const
  {
    return normal[e] < 0.
               ? -couple(interface, e) / (interface.length * normal[e])
               : 0.;
  }
  /** The moment about the midpoint: the couple of the forces at the ends. */
  double couple(const Packing<2>::Interface &interface, unsigned int e) const
  {
    return at_ends.empty()
               ? 0.
               : 0.5 * interface.length * (at_ends[e][0] - at_ends[e][1]);
  }
};
} // namespace Voussoir

#endif
