// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_space_integrated_forces_h
#define voussoir_scene_space_integrated_forces_h

#include <voussoir/formula/integrals/inaccuracies.h>
#include <voussoir/formula/integrals/simplex_integral.h>
#include <voussoir/formula/vector_expression.h>
#include <voussoir/scene/space/space_scene.h>

#include <string>
#include <vector>

namespace Voussoir
{
// Integrals of the user's expressions over blocks and their faces in space.

/** A vector f and f (x) (x - x_c), of the centre of a cell: twelve values. */
class ForceDensity
{
public:
  /**
   * @param f it must outlive this object; a force over a volume or an area.
   * @param about x_c; a length.
   * @param more_variables of f behind x, y, z.
   * @param where for messages, at their end.
   */
  ForceDensity(const VectorExpression &f,
               const dealii::Point<3> &about,
               std::vector<double> more_variables,
               std::string where)
      : f(f), about(about), more(std::move(more_variables)),
        where(std::move(where))
  {}

  /** The twelve values at x: f, then f_i (x - x_c)_j with j running first. */
  void operator()(const dealii::Point<3> &x, IntegratedValues &values) const
  {
    std::vector<double> variables(x.begin_raw(), x.end_raw());
    variables.insert(variables.end(), more.begin(), more.end());
    dealii::Tensor<1, 3> force;
    for (unsigned int i = 0; i < 3; ++i)
      force[i] = f.component(i, variables, x, where);
    values.assign(force.begin_raw(), force.end_raw());
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        values.push_back(force[i] * (x[j] - about[j]));
  }

private:
  const VectorExpression &f;
  const dealii::Point<3> about;
  const std::vector<double> more;
  const std::string where;
};

/** An integral of ForceDensity: the force, and its torque and first moment
 * about x_c. */
struct IntegratedForce
{
  /** @param integral of the values of ForceDensity, in their order. */
  explicit IntegratedForce(const SimplexIntegral &integral)
  {
    for (unsigned int i = 0; i < 3; ++i)
    {
      force[i] = integral.values[i];
      for (unsigned int j = 0; j < 3; ++j)
        first_moment[i][j] = integral.values[3 + 3 * i + j];
    }
    for (unsigned int i = 0; i < 3; ++i)
    {
      const unsigned int j = (i + 1) % 3, k = (i + 2) % 3;
      torque[i] = first_moment[k][j] - first_moment[j][k];
    }
  }

  /** Of f. */
  dealii::Tensor<1, 3> force;
  /** Of (x - x_c) x f; turning by the right-hand rule. */
  dealii::Tensor<1, 3> torque;
  /** Of f_i (x - x_c)_j. */
  dealii::Tensor<2, 3> first_moment;
};

/** Add an integral of ForceDensity to the loads on a cell. */
void add_integral(const SimplexIntegral &integral,
                  const unsigned int cell,
                  SpaceLoads &loads);

/** Add what inaccuracies there are to the warnings. */
void add_warnings(std::vector<std::string> &warnings,
                  const Inaccuracies &inaccuracies);

/** Add the body force @p b on some cells, with warnings of what is not exact.*/
void add_body_force(const Packing<3> &packing,
                    const std::vector<unsigned int> &cells,
                    const VectorExpression &b,
                    const std::string &parameter,
                    SpaceLoads &loads,
                    std::vector<std::string> &warnings);
} // namespace Voussoir

#endif
