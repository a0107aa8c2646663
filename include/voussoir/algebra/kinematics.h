// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_kinematics_h
#define voussoir_algebra_kinematics_h

#include <deal.II/base/exceptions.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <string>
#include <type_traits>
#include <utility>

namespace Voussoir
{

/**
 * A contact row: the displacement of c+ relative to c-, at one point of a joint
 * and in one direction, as a linear form on the unknowns of the two bodies,
 *
 *     direction . (u_{c+} - u_{c-}) + turn_plus . w_{c+} - turn_minus . w_{c-},
 *
 * with u_c the translations of body c, and w_c its rotations if it has any. Of
 * each array as many numbers count as there are of these.
 */
struct ContactRow
{
  /** The direction, of length one; of a combination() of any. */
  std::array<double, 3> direction = {};
  /** @{ */
  /** The factors of the rotations of c-, of c+. */
  std::array<double, 3> turn_minus = {};
  std::array<double, 3> turn_plus = {};
  /** @}*/
};

/** The row that is @p a times a factor and @p b times another. */
ContactRow combination(double factor_of_a,
                       const ContactRow &a,
                       double factor_of_b,
                       const ContactRow &b);

/**
 * The unknowns of a body: in the plane two translations and possibly a
 * rotation, in space three of each or no rotations. A rotation is the angle
 * about x_c, positive counterclockwise, times the unit of length; in space the
 * three are the components of the vector of the angle.
 */
class Kinematics
{
public:
  /** The largest number of unknowns of a body. */
  static constexpr unsigned int most_unknowns = 6;

  /** The @p name is how messages call it; two or three translations. */
  Kinematics(std::string name,
             const unsigned int n_translations,
             const unsigned int n_rotations)
      : its_name(std::move(name)), translations(n_translations),
        rotations(n_rotations)
  {
    Assert(n_rotations == 0 || (n_translations == 2 && n_rotations == 1) ||
               (n_translations == 3 && n_rotations == 3),
           dealii::ExcInternalError());
    Assert(n_translations == 2 || n_translations == 3,
           dealii::ExcInternalError());
  }

  /** The name. */
  const std::string &name() const { return its_name; }
  /** The number of components of the displacement of a body. */
  unsigned int n_translations() const { return translations; }
  /** The number of rotations of a body. */
  unsigned int n_rotations() const { return rotations; }
  /** The number of unknowns of a body, and of rigid motions of all as one. */
  unsigned int n_unknowns() const { return translations + rotations; }
  /** True if bodies turn, so that moments are balanced. */
  bool turns() const { return rotations > 0; }
  /**
   * Find the @p unknowns of a body at @p x in rigid motion @p k of all bodies:
   * in that a body at the origin has unknown k equal to one and no other.
   */
  void find_rigid_motion(unsigned int k,
                         const dealii::Tensor<1, 3> &x,
                         double *unknowns) const;

  /**
   * Call @p f with the numbers of translations and rotations as constants that
   * its loops are unrolled for.
   */
  template <typename F>
  decltype(auto) dispatch(const F &f) const
  {
    using std::integral_constant;
    using Two = integral_constant<unsigned int, 2>;
    using Three = integral_constant<unsigned int, 3>;
    if (translations == 2 && rotations == 0)
      return f(Two(), integral_constant<unsigned int, 0>());
    if (translations == 2 && rotations == 1)
      return f(Two(), integral_constant<unsigned int, 1>());
    if (rotations == 0)
      return f(Three(), integral_constant<unsigned int, 0>());
    return f(Three(), Three());
  }

private:
  std::string its_name;
  unsigned int translations;
  unsigned int rotations;
};

/** Bodies in the plane that do not turn. */
const Kinematics &translations();
/** Bodies in the plane that also turn. */
const Kinematics &rotations();
/** Bodies in space that do not turn. */
const Kinematics &translations_in_space();
/** Bodies in space that also turn. */
const Kinematics &rotations_in_space();

} // namespace Voussoir

#endif
