// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_linear_joint_blocks_h
#define voussoir_algebra_linear_joint_blocks_h

#include <voussoir/algebra/structure.h>

#include <array>

namespace Voussoir
{

/**
 * The matrix of JointSystem, sum_e B_e^T A_e B_e with the rows B_e of joint e
 * and their coefficients A_e, block by block. Each block couples two bodies,
 * row by row of n() unknowns each.
 */
class JointBlocks
{
public:
  /** A block; of its numbers the first n()^2 count. */
  using Block =
      std::array<double, Kinematics::most_unknowns * Kinematics::most_unknowns>;
  /** The blocks of one joint. */
  struct Blocks
  {
    /** @{ */
    /** Of c- with itself, and of c+ with itself. */
    Block minus;
    Block plus;
    /** @} */
    /** Of c+ (rows) with c- (columns). */
    Block mixed;
  };

  /**
   * @param structure has the joints; it must outlive this object.
   * @param apart true for the matrix of one component of the translations, by
   *   itself; see Componentwise. Then coefficients are isotropic.
   */
  JointBlocks(const Structure &structure, bool apart)
      : structure(&structure), unknowns(apart ? 1 : structure.n_unknowns())
  {}

  /** The structure. */
  const Structure &of() const { return *structure; }
  /** The number of unknowns of a body. */
  unsigned int n() const { return unknowns; }
  /** Find those of joint @p e for the @p coefficients of all joints. */
  void find(unsigned int e, const double *coefficients, Blocks &blocks) const;
  /** Find those of one row, of any joint, with the coefficient @p a. */
  void find(const ContactRow &row, double a, Blocks &blocks) const;

private:
  void clear(Blocks &blocks) const;

  const Structure *structure;
  unsigned int unknowns;
};

} // namespace Voussoir

#endif
