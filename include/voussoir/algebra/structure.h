// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_structure_h
#define voussoir_algebra_structure_h

#include <voussoir/algebra/joint_rows.h>
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
 * Newton's method sees of a problem, in the plane and in space. All of it, or
 * the part of one process: its own bodies, the joints that touch them, and
 * behind its own the ghosts, bodies of other processes at the far ends of these
 * joints.
 *
 * Vectors of unknowns are ordered body by body, see dof(); what has a number
 * for each contact row, as jumps and forces have, joint by joint, n_rows(e) of
 * joint e from first_row(e) on. Sums over the joints of a body are complete for
 * own bodies only.
 *
 * The rows of a joint come in sets, of one row, or of several whose forces
 * limit one another: a disc of friction has two. What has a number for each
 * pair of rows in a set, as second derivatives have, is ordered set by set, the
 * rows of a set's block one behind the other; those of joint e begin with
 * first_coefficient(e). In the plane each set is one row.
 */
class Structure
{
public:
  /** An interface e; nondimensional. */
  using Joint = Voussoir::Joint;
  /** A set of rows of a joint in space. */
  using FaceSet = Voussoir::FaceSet;

  /** The part that one process gets of a structure that several share. */
  struct Part
  {
    /** The motions of its bodies. */
    Kinematics kinematics = translations();
    /**
     * The number of its first own body; those of a process follow each other,
     * in the order of the processes.
     */
    unsigned int first = 0;
    /** The numbers of its ghosts, ascending. */
    std::vector<unsigned int> ghosts;
    /** Between own bodies 0, 1, ... and ghosts behind them. */
    JointRows joints;
    /** The result of loads(). */
    std::vector<double> loads;
    /** The result of centre(), of each own body. */
    std::vector<dealii::Tensor<1, 3>> centres;
    /** The number of own unknowns behind n_judged_dofs(). */
    unsigned int n_not_judged = 0;
  };

  /** The part of this process of what @p processes share. */
  Structure(const ProcessGroup &processes, Part part);

  /** The processes that share the structure. */
  const ProcessGroup &processes() const { return group; }
  /** The motions of the bodies. */
  const Kinematics &kinematics() const { return own.kinematics; }
  /** The largest tangential force of joint @p e without compression. */
  double limit(const unsigned int e) const
  {
    return own.joints.list[e].strength;
  }
  /** Kinematics::n_translations(). */
  unsigned int n_translations() const
  {
    return own.kinematics.n_translations();
  }
  /** Kinematics::n_unknowns(). */
  unsigned int n_unknowns() const { return unknowns_per_body; }
  /**
   * True if bodies have two translations. Then, and without blocks, the rows of
   * a joint are a list of contacts and one of sliding.
   */
  bool is_plane() const { return n_translations() == 2; }
  /** The number of bodies of this process, with the ground if it has it. */
  unsigned int n_own_bodies() const
  {
    return own.loads.size() / unknowns_per_body;
  }
  /** The number of own bodies and ghosts. */
  unsigned int n_bodies() const { return n_own_bodies() + own.ghosts.size(); }
  /** The number of unknowns of own bodies. */
  unsigned int n_own_dofs() const { return own.loads.size(); }
  /**
   * The number of own unknowns whose balance is judged: all but the rotations
   * of the ground, which come last. The torque on it has long arms, whose
   * rounding would hide the rest, and is balanced where all others are.
   */
  unsigned int n_judged_dofs() const { return n_own_dofs() - own.n_not_judged; }
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
  /** The load on each own unknown: F_c for the displacement. */
  const std::vector<double> &loads() const { return own.loads; }
  /**
   * x_c of an own body, in the plane without a third component; that of the
   * ground is zero.
   */
  const dealii::Tensor<1, 3> &centre(const unsigned int body) const
  {
    return own.centres[body];
  }
  /** Unknown @p i of @p body. */
  unsigned int dof(const unsigned int body, const unsigned int i) const
  {
    return unknowns_per_body * body + i;
  }
  /** Let the ghosts in @p u (n_dofs() numbers) have what their owners have. */
  void update_ghosts(std::vector<double> &u) const;
  /**
   * The work of the loads along @p u (n_dofs() numbers); collective.
   *
   * It is the sum of F_c . u_c over the bodies of all processes.
   */
  double work(const double *u) const;

  // ------------------------------------------------------ joints and rows

  /** All joints that touch an own body. */
  const std::vector<Joint> &joints() const { return own.joints.list; }
  /** True if this process counts the joint; the others that have it do not. */
  bool is_own(const Joint &joint) const
  {
    return joint.cell_minus < n_own_bodies();
  }
  /** The number of all their rows. */
  std::size_t n_all_rows() const { return own.joints.first_row.back(); }
  /** The first row of joint @p e among all; of their number behind the last. */
  std::size_t first_row(const unsigned int e) const
  {
    return own.joints.first_row[e];
  }
  /** The number of rows of joint @p e. */
  unsigned int n_rows(const unsigned int e) const
  {
    return own.joints.first_row[e + 1] - own.joints.first_row[e];
  }
  /** The joint that has row @p k among all. */
  unsigned int joint_of_row(std::size_t k) const;
  /** n_e, the direction of the first row of joint @p e. */
  dealii::Tensor<1, 3> normal(unsigned int e) const;
  /** Row @p k among all. */
  ContactRow row(std::size_t k) const;
  /** Row @p r of joint @p e. */
  ContactRow row(const unsigned int e, const unsigned int r) const
  {
    return row(first_row(e) + r);
  }
  /** @{ */
  /** The members of ContactRow, of row @p k among all. */
  const double *direction(const std::size_t k) const
  {
    return own.joints.direction.data() + n_translations() * k;
  }
  const double *turn_minus(const std::size_t k) const
  {
    return own.joints.turn_minus.data() + own.kinematics.n_rotations() * k;
  }
  const double *turn_plus(const std::size_t k) const
  {
    return own.joints.turn_plus.data() + own.kinematics.n_rotations() * k;
  }
  /** @} */

  /** The number of coefficients of all joints. */
  std::size_t n_all_coefficients() const
  {
    return has_blocks() ? own.joints.first_coefficient.back() : n_all_rows();
  }
  /** The first coefficient of joint @p e among all. */
  std::size_t first_coefficient(const unsigned int e) const
  {
    return has_blocks() ? own.joints.first_coefficient[e] : first_row(e);
  }
  /** The numbers of rows of the sets of joint @p e; empty without blocks. */
  std::vector<unsigned int> sets(unsigned int e) const;
  /** All rows of joint @p e. */
  std::vector<ContactRow> rows(unsigned int e) const;
  /** Call @p f for each FaceSet of joint @p e. */
  template <typename F>
  void for_each_face_set(unsigned int e, const F &f) const;
  /** True if some set has more rows than one. */
  bool has_blocks() const { return !own.joints.set_sizes.empty(); }
  /**
   * Call @p f for each set of joint @p e, with its number of rows and, counted
   * from the first of the joint, its first row and its first coefficient.
   */
  template <typename F>
  void for_each_set(unsigned int e, const F &f) const;
  /**
   * Multiply what each row of each joint has in @p f by the blocks of the
   * @p coefficients of its set.
   */
  void multiply_by_blocks(const std::vector<double> &coefficients,
                          std::vector<double> &f) const;

  /**
   * The jump of @p u (n_dofs() numbers) in row @p r of joint @p e: the
   * displacement of c+ relative to c-.
   */
  double jump(unsigned int e, unsigned int r, const double *u) const;
  /** The jump in row @p k among all, with the digits that it is summed with. */
  long double exact_jump(std::size_t k, const double *u) const;
  /** Find the jumps in all rows of joint @p e. */
  void find_jumps(unsigned int e, const double *u, double *jumps) const;
  /** Find the @p jumps in all rows of all joints. */
  void find_all_jumps(const double *u, double *jumps) const;
  /** Add the jumps in all rows to what these have, rounded once: where a sum
   * is small beside its jump it has more digits. */
  void add_exact_jumps(const std::vector<double> &u,
                       std::vector<double> &to) const;
  /** The jumps in all rows of all joints. */
  std::vector<double> jumps(const std::vector<double> &u) const;
  /**
   * Add to @p gradient (n_dofs() numbers) the derivative of the jumps of joint
   * @p e times its forces @p f, n_rows(e) numbers.
   */
  void
  add_jump_gradient(unsigned int e, const double *f, double *gradient) const;
  /**
   * Add to @p gradient (n_dofs() numbers) @p factor times the forces @p f, of
   * each row of each joint, on the bodies.
   */
  void add_all_jump_gradients(double factor,
                              const double *f,
                              double *gradient) const;
  /** add_all_jump_gradients(). */
  void add_jump_gradients(const double factor,
                          const std::vector<double> &f,
                          std::vector<double> &gradient) const
  {
    add_all_jump_gradients(factor, f.data(), gradient.data());
  }

  // ------------------------------------ in the plane: contacts and sliding

  /** The number of contacts of joint @p e, the rows before its last. */
  unsigned int n_contacts(const unsigned int e) const { return n_rows(e) - 1; }
  /** The number of all contacts. */
  std::size_t n_all_contacts() const { return first_contact(joints().size()); }
  /** The first contact of joint @p e among all. */
  std::size_t first_contact(const unsigned int e) const
  {
    return first_row(e) - e;
  }
  /** The share of one contact in the stiffness of joint @p e. */
  double contact_stiffness(const unsigned int e) const
  {
    return own.joints.list[e].stiffness() / n_contacts(e);
  }
  /**
   * The jump of the contact of joint @p e that opens least: negative where
   * bodies interpenetrate.
   */
  double opening(unsigned int e, const double *u) const;
  /** The jump of the tangential row of joint @p e. */
  double sliding(unsigned int e, const double *u) const
  {
    return jump(e, n_contacts(e), u);
  }

protected:
  /** A whole structure, to be filled by a derived class. */
  explicit Structure(const Kinematics &kinematics);

  /** The structure itself. */
  Part own;

private:
  template <typename F>
  void for_each_jump(const double *u, const F &f) const;
  template <unsigned int T, unsigned int R>
  long double
  jump_in_row(std::size_t k, const double *plus, const double *minus) const;
  template <unsigned int T, unsigned int R>
  void add_gradient(unsigned int e,
                    double factor,
                    const double *f,
                    double *gradient) const;

  ProcessGroup group;
  unsigned int unknowns_per_body;
  /** The exchange of the unknowns of ghosts; null if there are none. */
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> exchange;
};

// ------------------------------------------------------------------- inline

template <typename F>
void Structure::for_each_set(const unsigned int e, const F &f) const
{
  if (!has_blocks())
  {
    for (unsigned int r = 0; r < n_rows(e); ++r)
      f(1U, r, r);
    return;
  }
  unsigned int row = 0, coefficient = 0;
  for (unsigned int s = own.joints.first_set[e]; row < n_rows(e); ++s)
  {
    const unsigned int size = own.joints.set_sizes[s];
    f(size, row, coefficient);
    row += size;
    coefficient += size * size;
  }
}

template <typename F>
void Structure::for_each_face_set(const unsigned int e, const F &f) const
{
  std::size_t k = has_blocks() ? own.joints.first_set[e] : first_row(e);
  for_each_set(e, [&](const unsigned int size, const unsigned int row,
                      const unsigned int coefficient) {
    const double share = own.joints.shares[k];
    f(FaceSet{size, row, coefficient, share,
              own.joints.set_strengths.empty() ? joints()[e].strength * share
                                               : own.joints.set_strengths[k]});
    ++k;
  });
}

template <unsigned int T, unsigned int R>
inline long double Structure::jump_in_row(const std::size_t k,
                                          const double *plus,
                                          const double *minus) const
{
  // The products may cancel all but the last digits, and in a stiff joint
  // these are forces.
  const double *direction = &own.joints.direction[T * k];
  const auto along = [&](const unsigned int i) {
    return (static_cast<long double>(plus[i]) - minus[i]) * direction[i];
  };
  long double jump = along(0);
  for (unsigned int i = 1; i < T; ++i)
    jump += along(i);
  for (unsigned int i = 0; i < R; ++i)
    jump += static_cast<long double>(own.joints.turn_plus[R * k + i]) *
                plus[T + i] -
            static_cast<long double>(own.joints.turn_minus[R * k + i]) *
                minus[T + i];
  return jump;
}

inline double Structure::jump(const unsigned int e,
                              const unsigned int r,
                              const double *u) const
{
  const double *plus = u + dof(own.joints.list[e].cell_plus, 0);
  const double *minus = u + dof(own.joints.list[e].cell_minus, 0);
  return own.kinematics.dispatch([&](const auto T, const auto R) {
    return static_cast<double>(
        jump_in_row<T, R>(first_row(e) + r, plus, minus));
  });
}

inline void Structure::find_jumps(const unsigned int e,
                                  const double *u,
                                  double *jumps) const
{
  for (unsigned int r = 0; r < n_rows(e); ++r)
    jumps[r] = jump(e, r, u);
}

inline double Structure::opening(const unsigned int e, const double *u) const
{
  double least = jump(e, 0, u);
  for (unsigned int r = 1; r < n_contacts(e); ++r)
    least = std::min(least, jump(e, r, u));
  return least;
}

} // namespace Voussoir

#endif
