// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_problem_discrete_problem_h
#define voussoir_statics_problem_discrete_problem_h

#include <voussoir/algebra/structure.h>

#include <deal.II/base/types.h>

#include <array>
#include <optional>
#include <vector>

namespace Voussoir
{
/** The normal forces that a joint admits beside pressure; nondimensional. */
struct NormalLimits
{
  /** f_t |e|, the largest tension. */
  double tension;
  /** f_c |e|, the largest compression, possibly infinite. */
  double crushing;
};

/**
 * A Link among the joints: a contact without friction, which a tie presses
 * where its ends draw apart. Nondimensional.
 */
struct LinkContact
{
  /** Link::rest(), which is one of the loads. */
  double rest = 0.;
  /** What the force of the contact is multiplied with beside it; 1 or -1. */
  double sign = 1.;
  /** Its joint; invalid_unsigned_int where all of the force is a load. */
  unsigned int joint = dealii::numbers::invalid_unsigned_int;

  /** True if it has one. */
  bool has_joint() const
  {
    return joint != dealii::numbers::invalid_unsigned_int;
  }
};

/**
 * The proof that a motion opens every joint, or that none does. By the theorem
 * of the alternative of Gordan exactly one of these exists:
 *
 *     u with [u]_e . n_e > 0 for every e,
 *     p >= 0, not all zero, with sum_e p_e n_e = 0 on every cell (the sign of
 *     n_e outwards).
 *
 * Both are empty where the digits of the coordinates, from which n_e comes, do
 * not tell which one it is.
 */
struct Opening
{
  /** u, n_dofs() numbers; see opening_of(). */
  std::vector<double> displacement;
  /**
   * Of each row of each joint, of any size: normal forces p that balance by
   * themselves.
   */
  std::vector<double> self_stress;
};

/**
 * The displacement problem of a scene in nondimensional variables.
 *
 * It is all that a formulation sees:
 *
 *     minimise    sum_e s_e |e| |[u]_e . t_e|  -  sum_c F_c . u_c
 *     subject to  [u]_e . n_e >= 0 for every e
 *
 * with [u]_e = u_{c+} - u_{c-} (paper, eq. 10; the forces that a formulation
 * looks for are the solutions of its dual problem, eq. 13). Lengths are divided
 * by length_scale(), the root of the mean area of a cell, stresses by
 * stress_scale(), the sum of the sizes of all loads on the cells over the root
 * of the area of the packing, and coordinates start at the centroid, so that
 * the forces come out of order one whatever the user's units. Displacements
 * have no scale of their own, the energy being homogeneous; a formulation
 * chooses one.
 *
 * The ground, where there are supports, is one more body behind the cells. The
 * load on it is minus all others in its connected group, so that in every group
 * the loads add up to zero and a rigid motion does no work.
 */
class DiscreteProblem : public Structure
{
public:
  /** What a problem is made from; see discretise(). */
  struct Data
  {
    /** All bodies and joints, the ground as the last body if there is one. */
    Part part;
    /** The result of n_cells(). */
    unsigned int n_cells = 0;
    /** The result of normal_limits(). */
    std::vector<NormalLimits> limits;
    /** The result of links(). */
    std::vector<LinkContact> links;
    /** The result of open_ends(). */
    std::vector<std::array<bool, 2>> open_ends;
    /** The result of is_loaded(). */
    bool is_loaded = false;
    /** The result of length_scale(). */
    double length_unit = 1.;
    /** The result of stress_scale(). */
    double stress_unit = 1.;
    /** The result of rounding_of_coordinates(). */
    double coordinate_rounding = 0.;
  };

  /** Balance the loads, see above. */
  explicit DiscreteProblem(Data data);

  /** The bodies but for the ground, which is there if there are supports. */
  unsigned int n_cells() const { return n_moving_cells; }
  /** True if there are supports, and the ground is the last body. */
  bool has_ground() const { return n_bodies() > n_moving_cells; }
  /** True if there is any load at all. */
  bool is_loaded() const { return has_load; }
  /**
   * True if @p body stands for its connected group where one displacement of
   * each must be held: the ground, or else the lowest cell.
   */
  bool is_held(const unsigned int body) const
  {
    const bool with_ground =
        has_ground() && group_of_body[body] == group_of_body.back();
    return with_ground ? body == n_cells() : body == group_of_body[body];
  }

  /** Of each joint; empty where joints carry pressure alone, of any size. */
  const std::vector<NormalLimits> &normal_limits() const
  {
    return limits_of_joints;
  }
  /** Scene::open_ends of the interfaces here: an open end has no contact. */
  const std::vector<std::array<bool, 2>> &open_ends() const
  {
    return ends_that_are_open;
  }
  /** Those of the scene, whose joints come last. */
  const std::vector<LinkContact> &links() const { return links_of_scene; }
  /** The number of joints that are interfaces, the first ones. */
  unsigned int n_interfaces() const { return interface_count; }
  /** NormalLimits::tension of joint @p e. */
  double tension(const unsigned int e) const
  {
    return limits_of_joints.empty() ? 0. : limits_of_joints[e].tension;
  }

  /**
   * Call @p f for each row of joint @p e that bears pressure, counted from its
   * first, with its share of what the joint has: in the plane the contacts,
   * which share equally, and in space the sets that begin with a pressure.
   */
  template <typename F>
  void for_each_pressure(const unsigned int e, const F &f) const
  {
    if (is_plane())
    {
      for (unsigned int r = 0; r < n_contacts(e); ++r)
        f(r, 1. / n_contacts(e));
      return;
    }
    for_each_face_set(e, [&](const FaceSet &set) {
      if (set.size != 2)
        f(set.row, set.share);
    });
  }

  /**
   * Subtract from @p u (n_dofs() numbers) in each connected group the rigid
   * motion of the ground, or else the mean one.
   */
  void remove_rigid_motions(std::vector<double> &u) const;

  /**
   * Subtract from @p u (n_dofs() numbers) in each connected group the rigid
   * motion of the body that is_held().
   */
  void hold_bodies(std::vector<double> &u) const;

  /**
   * This problem with Tresca's friction, |f_e^t| at most @p limits,
   * nondimensional: one for each joint; in space one for each set with
   * friction, which a set of three rows then leaves to a disc of its own.
   */
  DiscreteProblem with_tresca(const std::vector<double> &limits) const;

  /**
   * This problem with all strengths s_e above @p strength, nondimensional,
   * lowered to it.
   */
  DiscreteProblem with_strengths_up_to(double strength) const;

  /**
   * In the plane: this problem without limits s_e and f_c above @p strength,
   * nondimensional; none if there are no such limits.
   */
  std::optional<DiscreteProblem> without_strengths_above(double strength) const;

  /** This problem with other loads, those of discretise_loads(). */
  DiscreteProblem with_loads(const std::vector<double> &loads) const;

  /**
   * The largest force that a joint bears without pressure, or crushes under,
   * nondimensional; zero if there is none.
   */
  double largest_limit() const;

  /** This problem with a unit of stress so many times as large. */
  DiscreteProblem in_units_of(double factor) const;

  /** This problem without any load. */
  DiscreteProblem without_loads() const;

  /** The unit of length, in the user's; L. */
  double length_scale() const { return length_unit; }
  /** The unit of stress, in the user's; S. One if there is no load. */
  double stress_scale() const { return stress_unit; }
  /** The rounding of the largest of the user's coordinates; nondimensional. */
  double rounding_of_coordinates() const { return coordinate_rounding; }

private:
  DiscreteProblem with_discs(const std::vector<double> &strengths) const;
  void balance_loads();
  /** The rigid motion of a connected group. */
  struct RigidMotion
  {
    /** The place about which it turns. */
    dealii::Tensor<1, 3> about;
    /** The size of each rigid motion of Kinematics. */
    std::array<double, Kinematics::most_unknowns> size = {};
  };
  void subtract(const std::vector<RigidMotion> &motion_of_group,
                std::vector<double> &u) const;

  double length_unit = 1.;
  double stress_unit = 1.;
  bool has_load = false;
  double coordinate_rounding = 0.;
  unsigned int n_moving_cells = 0;
  unsigned int interface_count = 0;
  std::vector<NormalLimits> limits_of_joints;
  std::vector<LinkContact> links_of_scene;
  std::vector<std::array<bool, 2>> ends_that_are_open;
  /** For each body the lowest body of its connected group. */
  std::vector<unsigned int> group_of_body;
  friend const Opening &opening_of(const DiscreteProblem &problem);
  /** What opening_of() has found. */
  mutable std::optional<Opening> found_opening;
};
} // namespace Voussoir

#endif
