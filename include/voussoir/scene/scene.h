// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_scene_h
#define voussoir_scene_scene_h

#include <voussoir/algebra/friction_law.h>
#include <voussoir/algebra/kinematics.h>
#include <voussoir/packing/packing.h>
#include <voussoir/scene/loads.h>

#include <vector>

namespace Voussoir
{
/**
 * A packing, what its interfaces can carry and what it has to carry, in the
 * user's units.
 */
struct Scene
{
  /**
   * Add up the loads on each cell.
   *
   * @param packing with its supports.
   * @param strength s_e of each of its interfaces, not negative; S.
   * @param loads on its boundary edges and cells.
   * @throws InputError if the total force on a connected group of cells without
   *   support is not zero, since nothing holds it, or if a load is too large or
   *   too small to compute with.
   */
  Scene(Packing packing, std::vector<double> strength, Loads loads);

  /** The blocks, with their supports. */
  Packing packing;
  /** s_e of each interface, not negative; S. */
  std::vector<double> strength;
  /** The forces that interfaces of a strength admit. */
  const FrictionLaw *friction = &tresca();
  /** The motions of the blocks. */
  const Kinematics *kinematics = &translations();
  /** g_e on each boundary edge, tension positive; S. */
  std::vector<dealii::Tensor<1, 2>> traction;
  /** EdgeTractions::first_moment of it on each boundary edge; S L^2. */
  std::vector<dealii::Tensor<1, 2>> traction_moment;
  /** The forces on the cells, per unit thickness, by name; see body. */
  std::vector<CellForce> on_cells;
  /** The body force, with on_cells in it. */
  BodyForce body;
  /** True if there is more in it than on_cells. */
  bool has_body_force;
  /** F_c on each cell, the sum of all these, without reactions; S L. */
  std::vector<dealii::Tensor<1, 2>> load;
  /** The sum of the sizes of all forces that F_c is the sum of; S L. */
  std::vector<double> load_size;
  /** connected_groups() of the packing, n_cells + 1 numbers. */
  std::vector<unsigned int> group;

private:
  void add_up_loads();
  void check_balance() const;
  void clear_single_cells();
};

/**
 * The forces of the interfaces, in the order of Packing::interfaces(): f_e^n,
 * negative in compression, and f_e^t. Per unit thickness, S L, unless they are
 * said to be nondimensional, as those of a Solution are. The force on cell c+
 * is minus that on cell c-, which is f_e^n n_e + f_e^t t_e.
 */
struct InterfaceForces
{
  /** f_e^n of each interface, <= 0: compression. */
  std::vector<double> normal;
  /** f_e^t of each interface, |f_e^t| <= s_e |e|. */
  std::vector<double> tangential;

  /**
   * The force on cell c- of interface @p e, f_e^n n_e + f_e^t t_e.
   *
   * @param interface that of the number @p e.
   */
  dealii::Tensor<1, 2> on_cell_minus(const Packing::Interface &interface,
                                     unsigned int e) const;
};

/** FrictionLaw::utilisation() of an interface. */
double
utilisation(const Scene &scene, const InterfaceForces &forces, unsigned int e);

/**
 * The torque about x_c of all forces on each cell, positive counterclockwise;
 * S L^2. Translations alone do not balance it.
 */
std::vector<double> residual_torques(const Scene &scene,
                                     const InterfaceForces &forces);
} // namespace Voussoir

#endif
