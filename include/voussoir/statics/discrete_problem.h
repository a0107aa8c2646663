// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_discrete_problem_h
#define voussoir_statics_discrete_problem_h

#include <voussoir/statics/scene.h>

#include <deal.II/base/array_view.h>

#include <optional>
#include <vector>

namespace Voussoir
{
/**
 * The displacement problem of a scene in nondimensional variables; all that a
 * formulation sees:
 *
 *   minimise    sum_e s_e |e| |[u]_e . t_e|  -  sum_c F_c . u_c
 *   subject to  [u]_e . n_e >= 0 for every e
 *
 * with [u]_e = u_{c+} - u_{c-} (Marazzato and Venkataramani, the primal
 * problem). Lengths are divided by the mean size of a cell, stresses by that of
 * the loads, and coordinates start at the centroid, so that the forces come
 * out of order one whatever the user's units. Displacements have no scale of
 * their own, the energy being homogeneous; a formulation chooses one.
 *
 * The ground, where there are supports, is one more body behind the cells. The
 * load on it is minus all others in its connected group, so that in every group
 * the loads add up to zero and a translation does no work.
 *
 * Unknowns are ordered body by body, component by component; see dof().
 */
class DiscreteProblem
{
public:
  /** An interface e; nondimensional. */
  struct Joint
  {
    unsigned int cell_minus;
    /** Possibly the ground. */
    unsigned int cell_plus;
    /** n_e, from c- to c+. */
    dealii::Tensor<1, 2> normal;
    /** t_e = R(pi/2) n_e. */
    dealii::Tensor<1, 2> tangent;
    /** |e| */
    double length;
    /** d_e, which is positive; see Packing::distance(). */
    double distance;
    /** s_e |e|, the largest tangential force. */
    double strength;

    /** k_e = |e| / d_e, of a joint with modulus one. */
    double stiffness() const
    {
      return length / distance;
    }
  };

  /** The jump [u]_e in the frame of its joint. */
  struct Jump
  {
    double normal;
    double tangential;
  };

  explicit DiscreteProblem(const Scene &scene);

  unsigned int n_cells() const;
  /** The cells, and the ground if there are supports. */
  unsigned int n_bodies() const;
  unsigned int n_dofs() const;
  const std::vector<Joint> &joints() const;
  /** F_c of each body; nondimensional. In each group they sum to zero. */
  const std::vector<dealii::Tensor<1, 2>> &loads() const;
  /** Whether there is any load at all. */
  bool is_loaded() const;
  /** x_c of each cell; nondimensional, from the centroid of the packing. */
  const std::vector<dealii::Tensor<1, 2>> &centres() const;
  /**
   * A displacement that opens every joint, n_dofs() numbers: the strict
   * interior of the contact constraints. Without supports it is the uniform
   * dilation u = x_c, from the centroid of the packing, for which [u]_e . n_e =
   * d_e. Empty if there is none, as for a block clamped between two walls: then
   * there are normal forces that balance by themselves, and no bound to them.
   */
  const std::vector<double> &opening() const;
  /**
   * Whether @p body stands for its connected group where one displacement of
   * each must be held: the ground, or else the lowest cell.
   */
  bool is_held(unsigned int body) const;

  /** The unknown of component @p i of the displacement of @p body. */
  static unsigned int dof(unsigned int body, unsigned int i);

  /** The jump of the displacement @p u (n_dofs() numbers) across a joint. */
  static Jump jump(const Joint &joint, const double *u);

  /** Add f times the derivative of jump() to @p gradient (n_dofs() numbers). */
  static void
  add_jump_gradient(const Joint &joint, const Jump &f, double *gradient);

  /**
   * Subtract from @p u (n_dofs() numbers) in each connected group the
   * displacement of the ground, or else the mean.
   */
  void remove_translations(std::vector<double> &u) const;

  /** Subtract from @p u in each connected group what is_held() moves by. */
  void hold_bodies(std::vector<double> &u) const;

  /** The displacements of the cells among @p u, times @p unit. */
  std::vector<dealii::Tensor<1, 2>>
  displacement_of_cells(const std::vector<double> &u, double unit) const;

  /**
   * The same problem with all strengths s_e above @p strength, nondimensional,
   * lowered to it.
   */
  DiscreteProblem with_strengths_up_to(double strength) const;

  /** The same problem without any load. */
  DiscreteProblem without_loads() const;

  /** sum_c F_c . u_c */
  double work(const double *u) const;

  /** The unit of length, in the user's. */
  double length_scale() const;
  /** The unit of stress, in the user's. */
  double stress_scale() const;

private:
  void choose_scales(const Scene &scene);
  void balance_loads();

  double length_unit = 1.;
  double stress_unit = 1.;
  bool has_load = false;
  std::vector<Joint> joint_list;
  std::vector<dealii::Tensor<1, 2>> load;
  std::vector<dealii::Tensor<1, 2>> centre;
  /** For each body the lowest body of its connected group. */
  std::vector<unsigned int> group;
  /** Found when it is first asked for. */
  mutable std::optional<std::vector<double>> opening_displacement;
};

// ------------------------------------------------------------------- inline

inline unsigned int DiscreteProblem::dof(const unsigned int body,
                                         const unsigned int i)
{
  return 2 * body + i;
}

inline DiscreteProblem::Jump DiscreteProblem::jump(const Joint &joint,
                                                   const double *u)
{
  // The two products may cancel all but the last digits, and in a stiff joint
  // these are forces.
  const long double x = static_cast<long double>(u[dof(joint.cell_plus, 0)]) -
                        u[dof(joint.cell_minus, 0)];
  const long double y = static_cast<long double>(u[dof(joint.cell_plus, 1)]) -
                        u[dof(joint.cell_minus, 1)];
  return {static_cast<double>(x * joint.normal[0] + y * joint.normal[1]),
          static_cast<double>(x * joint.tangent[0] + y * joint.tangent[1])};
}

inline void DiscreteProblem::add_jump_gradient(const Joint &joint,
                                               const Jump &f,
                                               double *gradient)
{
  for (unsigned int i = 0; i < 2; ++i)
  {
    const double component =
        f.normal * joint.normal[i] + f.tangential * joint.tangent[i];
    gradient[dof(joint.cell_plus, i)] += component;
    gradient[dof(joint.cell_minus, i)] -= component;
  }
}
} // namespace Voussoir

#endif
