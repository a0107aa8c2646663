// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_structure_h
#define voussoir_algebra_structure_h

#include <voussoir/algebra/friction_law.h>
#include <voussoir/algebra/kinematics.h>
#include <voussoir/parallel/process_group.h>

#include <deal.II/base/partitioner.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cstddef>
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
 * Vectors of unknowns are ordered body by body, see dof(); what has a number
 * for each contact row, as jumps and forces have, joint by joint, n_rows() for
 * each: first the normal ones, n_contacts() of them, at last the tangential
 * one. Sums over the joints of a body are complete for own bodies only.
 */
class Structure
{
public:
  /** The largest number of rows of a joint. */
  static constexpr unsigned int most_rows = 17;

  /** An interface e; nondimensional. */
  struct Joint
  {
    /** c-, the number of a body here. */
    unsigned int cell_minus;
    /** c+, the number of a body here; possibly the ground. */
    unsigned int cell_plus;
    /** The length |e|. */
    double length;
    /** d_e, which is positive; see Packing::distance(). */
    double distance;
    /** s_e |e|, the strength; see FrictionLaw. With Coulomb's friction c_e |e|.
     */
    double strength;
    /** mu_e, which Coulomb's friction adds times the compression. */
    double coefficient = 0.;
    /** k_e = |e| / d_e, of a joint with modulus one. */
    double stiffness() const { return length / distance; }
  };

  /** All joints with their rows; see ContactRow. */
  struct Joints
  {
    /** The joints. */
    std::vector<Joint> list;
    /** ContactRow::direction of each row. */
    std::vector<dealii::Tensor<1, 2>> direction;
    /** @{ */
    /** Of each row; empty where bodies have two unknowns. */
    std::vector<double> turn_minus, turn_plus;
    /** @} */
    /** Add a joint with its @p n_rows rows, in which bodies turn if so said. */
    void add(const Joint &joint,
             const ContactRow *rows,
             unsigned int n_rows,
             bool with_turns);
  };

  /** The part that one process gets of a structure that several share. */
  struct Part
  {
    /** The motions of its bodies. */
    const Kinematics *kinematics = &translations();
    /** The law of friction of its joints. */
    const FrictionLaw *friction = &tresca();
    /**
     * The number of its first own body; those of a process follow each other,
     * in the order of the processes.
     */
    unsigned int first = 0;
    /** The numbers of its ghosts, ascending. */
    std::vector<unsigned int> ghosts;
    /** Between own bodies 0, 1, ... and ghosts behind them. */
    Joints joints;
    /** The result of loads(). */
    std::vector<double> loads;
    /** The result of centres(). */
    std::vector<dealii::Tensor<1, 2>> centres;
  };

  /** The part of this process of what @p processes share. */
  Structure(const ProcessGroup &processes, Part part);

  /** The processes that share the structure. */
  const ProcessGroup &processes() const { return group; }
  /** The motions of the bodies. */
  const Kinematics &kinematics() const { return *own.kinematics; }
  /** The law of friction of the joints. */
  const FrictionLaw &friction() const { return *own.friction; }
  /** The largest tangential force of joint @p e without compression. */
  double limit(const unsigned int e) const
  {
    return own.friction->limit(own.joints.list[e].strength, 0.);
  }
  /** The share of one contact in the stiffness of joint @p e. */
  double contact_stiffness(const unsigned int e) const
  {
    return own.joints.list[e].stiffness() / n_contacts();
  }
  /** Kinematics::n_unknowns(). */
  unsigned int n_unknowns() const { return unknowns_per_body; }
  /** Kinematics::n_contacts(). */
  unsigned int n_contacts() const { return rows_per_joint - 1; }
  /** Kinematics::n_rows(). */
  unsigned int n_rows() const { return rows_per_joint; }
  /** The number of bodies of this process, with the ground if it has it. */
  unsigned int n_own_bodies() const
  {
    return own.loads.size() / unknowns_per_body;
  }
  /** The number of own bodies and ghosts. */
  unsigned int n_bodies() const { return n_own_bodies() + own.ghosts.size(); }
  /** The number of unknowns of own bodies. */
  unsigned int n_own_dofs() const { return own.loads.size(); }
  /** The number of unknowns of all bodies: the size of a vector of them. */
  unsigned int n_dofs() const { return unknowns_per_body * n_bodies(); }
  /** The number of the first own body among those of all processes. */
  unsigned int first_body() const { return own.first; }
  /** The numbers of the ghosts, ascending. */
  const std::vector<unsigned int> &ghosts() const { return own.ghosts; }
  /** The number of @p body among those of all processes. */
  unsigned int number_of(const unsigned int body) const
  {
    return body < n_own_bodies() ? own.first + body
                                 : own.ghosts[body - n_own_bodies()];
  }
  /** All joints that touch an own body. */
  const std::vector<Joint> &joints() const { return own.joints.list; }
  /** The number of all their rows. */
  std::size_t n_all_rows() const { return own.joints.direction.size(); }
  /** Row @p r of joint @p e. */
  ContactRow row(unsigned int e, unsigned int r) const;
  /** n_e, the direction of the first row of joint @p e. */
  const dealii::Tensor<1, 2> &normal(const unsigned int e) const
  {
    return own.joints.direction[std::size_t(e) * rows_per_joint];
  }
  /** True if this process counts the joint; the others that have it do not. */
  bool is_own(const Joint &joint) const
  {
    return joint.cell_minus < n_own_bodies();
  }
  /** The load on each own unknown: F_c for the displacement. */
  const std::vector<double> &loads() const { return own.loads; }
  /** x_c of each own body; that of the ground is zero. */
  const std::vector<dealii::Tensor<1, 2>> &centres() const
  {
    return own.centres;
  }
  /** Let the ghosts in @p u (n_dofs() numbers) have what their owners have. */
  void update_ghosts(std::vector<double> &u) const;
  /** Unknown @p i of @p body. */
  unsigned int dof(const unsigned int body, const unsigned int i) const
  {
    return unknowns_per_body * body + i;
  }
  /**
   * The jump of @p u (n_dofs() numbers) in row @p r of joint @p e: the opening,
   * negative where bodies interpenetrate, or in the last row the sliding.
   */
  double jump(unsigned int e, unsigned int r, const double *u) const;
  /** The jump of the contact of joint @p e that opens least. */
  double opening(unsigned int e, const double *u) const;
  /** The jump of the tangential row of joint @p e. */
  double sliding(unsigned int e, const double *u) const;
  /** Find the jumps in all rows of joint @p e. */
  void find_jumps(unsigned int e, const double *u, double *jumps) const
  {
    for (unsigned int r = 0; r < rows_per_joint; ++r)
      jumps[r] = jump(e, r, u);
  }
  /** The jumps in all rows of all joints. */
  std::vector<double> jumps(const std::vector<double> &u) const;
  /**
   * Add to @p gradient (n_dofs() numbers) the derivative of the jumps of joint
   * @p e times its forces @p f, n_rows() numbers.
   */
  void
  add_jump_gradient(unsigned int e, const double *f, double *gradient) const;
  /**
   * The same of all joints: add @p factor times the forces @p f, of each row of
   * each joint, on the bodies.
   */
  void add_jump_gradients(double factor,
                          const std::vector<double> &f,
                          std::vector<double> &gradient) const;
  /**
   * The work of the loads along @p u (n_dofs() numbers); collective.
   *
   * It is the sum of F_c . u_c over the bodies of all processes.
   */
  double work(const double *u) const;

protected:
  /** A whole structure, to be filled by a derived class. */
  Structure(const Kinematics &kinematics, const FrictionLaw &friction);
  /** Add a joint with its rows. */
  void add_joint(const Joint &joint, const JointFrame &frame);

  /** The structure itself. */
  Part own;

private:
  ProcessGroup group;
  unsigned int unknowns_per_body;
  unsigned int rows_per_joint;
  /** The exchange of the unknowns of ghosts; null if there are none. */
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> exchange;
};

// ------------------------------------------------------------------- inline

inline ContactRow Structure::row(const unsigned int e,
                                 const unsigned int r) const
{
  const std::size_t k = std::size_t(e) * rows_per_joint + r;
  const Joints &joints = own.joints;
  if (joints.turn_plus.empty())
    return {joints.direction[k], 0., 0.};
  return {joints.direction[k], joints.turn_minus[k], joints.turn_plus[k]};
}

inline double Structure::jump(const unsigned int e,
                              const unsigned int r,
                              const double *u) const
{
  // The products may cancel all but the last digits, and in a stiff joint
  // these are forces.
  const double *plus = u + dof(own.joints.list[e].cell_plus, 0);
  const double *minus = u + dof(own.joints.list[e].cell_minus, 0);
  const long double x = static_cast<long double>(plus[0]) - minus[0];
  const long double y = static_cast<long double>(plus[1]) - minus[1];
  const std::size_t k = std::size_t(e) * rows_per_joint + r;
  const dealii::Tensor<1, 2> &direction = own.joints.direction[k];
  long double jump = x * direction[0] + y * direction[1];
  if (!own.joints.turn_plus.empty())
    jump += static_cast<long double>(own.joints.turn_plus[k]) * plus[2] -
            static_cast<long double>(own.joints.turn_minus[k]) * minus[2];
  return static_cast<double>(jump);
}

inline double Structure::opening(const unsigned int e, const double *u) const
{
  double least = jump(e, 0, u);
  for (unsigned int r = 1; r < n_contacts(); ++r)
    least = std::min(least, jump(e, r, u));
  return least;
}

inline double Structure::sliding(const unsigned int e, const double *u) const
{
  return jump(e, n_contacts(), u);
}

inline void Structure::add_jump_gradient(const unsigned int e,
                                         const double *f,
                                         double *gradient) const
{
  double *plus = gradient + dof(own.joints.list[e].cell_plus, 0);
  double *minus = gradient + dof(own.joints.list[e].cell_minus, 0);
  const std::size_t first = std::size_t(e) * rows_per_joint;
  for (unsigned int i = 0; i < 2; ++i)
  {
    double component = 0.;
    for (unsigned int r = 0; r < rows_per_joint; ++r)
      component += f[r] * own.joints.direction[first + r][i];
    plus[i] += component;
    minus[i] -= component;
  }
  if (own.joints.turn_plus.empty())
    return;
  for (unsigned int r = 0; r < rows_per_joint; ++r)
  {
    plus[2] += f[r] * own.joints.turn_plus[first + r];
    minus[2] -= f[r] * own.joints.turn_minus[first + r];
  }
}

} // namespace Voussoir

#endif
