// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_structure_h
#define voussoir_algebra_structure_h

#include <voussoir/parallel/team.h>

#include <deal.II/base/partitioner.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <vector>

namespace Voussoir
{
/**
 * Bodies, the loads on them and the joints between them, nondimensional: what
 * Newton's method sees of a problem. All of it, or the part of one process: its
 * own bodies, the joints that touch them, and behind its own the ghosts, bodies
 * of other processes at the far ends of these joints.
 *
 * Vectors of unknowns are ordered body by body, component by component; see
 * dof(). Sums over the joints of a body are complete for own bodies only.
 */
class Structure
{
public:
  /** An interface e; nondimensional. */
  struct Joint
  {
    /** c-, the number of a body here. */
    unsigned int cell_minus;
    /** c+, the number of a body here; possibly the ground. */
    unsigned int cell_plus;
    /** n_e, from c- to c+. */
    dealii::Tensor<1, 2> normal;
    /** t_e = R(pi/2) n_e. */
    dealii::Tensor<1, 2> tangent;
    /** The length |e|. */
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

  /**
   * The jump [u]_e in the frame of its joint; or a pair of this kind, the
   * forces f_e^n and f_e^t.
   */
  struct Jump
  {
    /** Along n_e: the opening, negative where bodies interpenetrate. */
    double normal;
    /** Along t_e: the sliding. */
    double tangential;
  };

  /** The part that one process gets of a structure that several share. */
  struct Part
  {
    /**
     * The number of its first own body; those of a process follow each other,
     * in the order of the processes.
     */
    unsigned int first = 0;
    /** The numbers of its ghosts, ascending. */
    std::vector<unsigned int> ghosts;
    /** Between own bodies 0, 1, ... and ghosts behind them. */
    std::vector<Joint> joints;
    /** F_c on its own bodies. */
    std::vector<dealii::Tensor<1, 2>> loads;
  };

  /** The part of this process of what @p team shares. */
  Structure(const Team &team, Part part);

  /** The processes that share the structure. */
  const Team &team() const;

  /** The number of bodies of this process, with the ground if it has it. */
  unsigned int n_own_bodies() const;

  /** The number of own bodies and ghosts. */
  unsigned int n_bodies() const;

  /** Twice n_own_bodies(). */
  unsigned int n_own_dofs() const;

  /** Twice n_bodies(): the size of a vector of unknowns. */
  unsigned int n_dofs() const;
  /** The number of the first own body among those of all processes. */
  unsigned int first_body() const;
  /** The numbers of the ghosts, ascending. */
  const std::vector<unsigned int> &ghosts() const;

  /** All joints that touch an own body. */
  const std::vector<Joint> &joints() const;
  /** True if this process counts the joint; the others that have it do not. */
  bool is_own(const Joint &joint) const;
  /** F_c of each own body. */
  const std::vector<dealii::Tensor<1, 2>> &loads() const;

  /** Let the ghosts in @p u (n_dofs() numbers) have what their owners have. */
  void update_ghosts(std::vector<double> &u) const;

  /** The unknown of component @p i of the displacement of @p body. */
  static unsigned int dof(unsigned int body, unsigned int i);

  /** The jump of the displacement @p u (n_dofs() numbers) across a joint. */
  static Jump jump(const Joint &joint, const double *u);

  /** Add f times the derivative of jump() to @p gradient (n_dofs() numbers). */
  static void
  add_jump_gradient(const Joint &joint, const Jump &f, double *gradient);

  /**
   * The work of the loads along @p u (n_dofs() numbers); collective.
   *
   * It is the sum of F_c . u_c over the bodies of all processes.
   */
  double work(const double *u) const;

protected:
  /** A whole structure, to be filled by a derived class. */
  Structure() = default;

  /** The result of joints(). */
  std::vector<Joint> joint_list;
  /** The result of loads(); it has an element for each own body. */
  std::vector<dealii::Tensor<1, 2>> load;

private:
  Team processes;
  unsigned int first = 0;
  std::vector<unsigned int> ghost_list;
  /** The exchange of the unknowns of ghosts; null if there are none. */
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> exchange;
};

// ------------------------------------------------------------------- inline

inline unsigned int Structure::dof(const unsigned int body,
                                   const unsigned int i)
{
  return 2 * body + i;
}

inline bool Structure::is_own(const Joint &joint) const
{
  return joint.cell_minus < load.size();
}

inline Structure::Jump Structure::jump(const Joint &joint, const double *u)
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

inline void Structure::add_jump_gradient(const Joint &joint,
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
