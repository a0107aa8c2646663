// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_scene_h
#define voussoir_scene_scene_h

#include <voussoir/algebra/kinematics.h>
#include <voussoir/contact/joint_limits.h>
#include <voussoir/packing/packing.h>
#include <voussoir/scene/interface_forces.h>
#include <voussoir/scene/links/link.h>
#include <voussoir/scene/loads/loads.h>
#include <voussoir/scene/motion.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace Voussoir
{
struct ForceFunction;

/**
 * A packing, what its interfaces can carry and what it has to carry, in the
 * user's units.
 */
struct Scene
{
  /** @{ */
  /** What is found for it, and may be asked of that. */
  using Forces = InterfaceForces;
  using MotionOfBlocks = Motion;
  using Function = ForceFunction;
  /** @} */
  /**
   * Add up the loads on each cell.
   *
   * @param packing with its supports.
   * @param strength s_e of each of its interfaces, not negative; S.
   * @param loads on its boundary edges and cells.
   * @param kinematics of the blocks.
   * @param links between them, and to the ground.
   * @throws InputError if the total force on a connected group of cells without
   *   support, or where they turn its moment, is not zero, since nothing holds
   *   it, or if a load is too large or too small to compute with.
   */
  Scene(Packing<2> packing,
        std::vector<double> strength,
        Loads loads,
        const Kinematics &kinematics = translations(),
        std::vector<Link> links = {});

  /** The blocks, with their supports. */
  Packing<2> packing;
  /** s_e of each interface, not negative; S. With Coulomb's friction c_e. */
  std::vector<double> strength;
  /** mu_e of each interface, not negative; empty if all are zero. */
  std::vector<double> coefficient;
  /**
   * False if blocks do not lift off as Coulomb's friction lets them slide, so
   * that no theorem of limit analysis holds.
   */
  bool dilates = true;
  /** The name of the law of friction, for the user. */
  std::string friction_law = {};
  /** f_t of each interface, not negative; S. Empty if all are zero. */
  std::vector<double> tensile_strength;
  /** f_c of each interface, positive; S. Empty if no interface crushes. */
  std::vector<double> compressive_strength;
  /** The motions of the blocks. */
  const Kinematics *kinematics;
  /** Forces between cells that need not touch. */
  std::vector<Link> links;
  /** The names of these. */
  std::vector<std::string> link_names;
  /**
   * Whether the start and the end of each interface is open, and bears nothing;
   * empty if none is. An interface with an open end has no strength but by
   * friction.
   */
  std::vector<std::array<bool, 2>> open_ends;
  /** The soil that stands on edges, for pictures; lengths. */
  std::vector<std::array<dealii::Point<2>, 4>> fill_columns;
  /** The forces that interface @p e admits. */
  JointLimits limits(const unsigned int e) const
  {
    const double length = packing.interfaces()[e].length;
    JointLimits of = {strength[e] * length};
    if (!coefficient.empty())
      of.coefficient = coefficient[e];
    if (!open_ends.empty() && (open_ends[e][0] || open_ends[e][1]))
    {
      of.strength = 0.;
      of.open = open_ends[e];
      return of;
    }
    if (!tensile_strength.empty())
      of.tension = tensile_strength[e] * length;
    if (!compressive_strength.empty())
      of.crushing = compressive_strength[e] * length;
    return of;
  }
  /** True if interfaces bear tension, or crush. */
  bool has_normal_limits() const
  {
    return !tensile_strength.empty() || !compressive_strength.empty();
  }
  /** True if more than pressure and friction acts between cells. */
  bool has_more_than_friction() const
  {
    return has_normal_limits() || !links.empty();
  }
  /** True if any load acts on a cell, or a link is stressed. */
  bool is_loaded() const
  {
    return std::any_of(load_size.begin(), load_size.end(),
                       [](const double size) { return size > 0.; }) ||
           std::any_of(links.begin(), links.end(),
                       [](const Link &link) { return link.rest() != 0.; });
  }
  /** True if they turn, so that moments are balanced. */
  bool turns() const { return kinematics->turns(); }
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
  /** The torque about x_c of the loads on each cell; S L^2, see turns(). */
  std::vector<double> load_torque;
  /** The sum of the sizes of all forces that F_c is the sum of; S L. */
  std::vector<double> load_size;
  /**
   * How far the loads that act differ from Loads::requested: the sums of the
   * forces on edges and in cells, and of F_c and its torques, less that of the
   * request, over the sum of the sizes of the loads; and those of the moments,
   * over that times the diagonal of the packing, whichever is most. Zero where
   * nothing is known of what was asked for.
   */
  double load_residual = 0.;
  /** linked_groups() of the packing, n_cells + 1 numbers. */
  std::vector<unsigned int> group;

private:
  void add_up_loads();
  void check_balance() const;
  void check_moments() const;
  void clear_single_cells();
  double residual_of_loads(const Resultant &requested) const;
};

/**
 * A scene with the forces of its links as loads inside the cells, spread over
 * these, in the place of the links: what the stress is found of.
 */
Scene loaded_by_links(Scene scene, const InterfaceForces &forces);

/** The forces zero in all interfaces and links of @p scene. */
InterfaceForces no_forces(const Scene &scene);

/**
 * The size of F_c of each cell, or of what stresses a link on it if that is
 * more; S L.
 */
std::vector<double> largest_loads(const Scene &scene);

/**
 * The torque about x_c of all forces on each cell, positive counterclockwise;
 * S L^2. Only blocks that turn balance it.
 */
std::vector<double> residual_torques(const Scene &scene,
                                     const InterfaceForces &forces);
} // namespace Voussoir

#endif
