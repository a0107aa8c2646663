// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_discrete_problem_h
#define voussoir_statics_discrete_problem_h

#include <voussoir/statics/scene.h>

#include <deal.II/base/array_view.h>

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
 * Unknowns are ordered cell by cell, component by component; see dof().
 */
class DiscreteProblem
{
public:
  /** An interface e; nondimensional. */
  struct Joint
  {
    unsigned int cell_minus;
    unsigned int cell_plus;
    /** n_e, from c- to c+. */
    dealii::Tensor<1, 2> normal;
    /** t_e = R(pi/2) n_e. */
    dealii::Tensor<1, 2> tangent;
    /** |e| */
    double length;
    /** d_e = (x_{c+} - x_{c-}) . n_e, which is positive. */
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
  unsigned int n_dofs() const;
  const std::vector<Joint> &joints() const;
  /** F_c; nondimensional. In each connected group they sum to zero. */
  const std::vector<dealii::Tensor<1, 2>> &loads() const;
  /** Whether there is any load at all. */
  bool is_loaded() const;
  /** x_c; nondimensional, from the centroid of the packing. */
  const std::vector<dealii::Tensor<1, 2>> &centres() const;
  /** For each cell the lowest cell of its connected group. */
  const std::vector<unsigned int> &groups() const;

  /** The unknown of component @p i of the displacement of @p cell. */
  static unsigned int dof(unsigned int cell, unsigned int i);

  /** The jump of the displacement @p u (n_dofs() numbers) across a joint. */
  static Jump jump(const Joint &joint, const double *u);

  /** Add f times the derivative of jump() to @p gradient (n_dofs() numbers). */
  static void
  add_jump_gradient(const Joint &joint, const Jump &f, double *gradient);

  /** Subtract from @p v, cell by cell, its mean over each connected group. */
  void remove_group_means(std::vector<dealii::Tensor<1, 2>> &v) const;

  /** sum_c F_c . u_c */
  double work(const double *u) const;

  /** The unit of length, in the user's. */
  double length_scale() const;
  /** The unit of stress, in the user's. */
  double stress_scale() const;

private:
  void choose_scales(const Scene &scene);

  double length_unit = 1.;
  double stress_unit = 1.;
  bool has_load = false;
  std::vector<Joint> joint_list;
  std::vector<dealii::Tensor<1, 2>> load;
  std::vector<dealii::Tensor<1, 2>> centre;
  std::vector<unsigned int> group;
};

// ------------------------------------------------------------------- inline

inline unsigned int DiscreteProblem::dof(const unsigned int cell,
                                         const unsigned int i)
{
  return 2 * cell + i;
}

inline DiscreteProblem::Jump DiscreteProblem::jump(const Joint &joint,
                                                   const double *u)
{
  const double x = u[dof(joint.cell_plus, 0)] - u[dof(joint.cell_minus, 0)];
  const double y = u[dof(joint.cell_plus, 1)] - u[dof(joint.cell_minus, 1)];
  return {x * joint.normal[0] + y * joint.normal[1],
          x * joint.tangent[0] + y * joint.tangent[1]};
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
