// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_loads_h
#define voussoir_statics_loads_h

#include <voussoir/packing/packing.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace Voussoir
{
/** The section `Loads`: the traction g on the boundary of the packing. */
class LoadParameters
{
public:
  void add_parameters(dealii::ParameterHandler &prm);

  /**
   * The traction g_e on each boundary edge, a stress: the mean of g over the
   * edge, by Gauss quadrature.
   *
   * @throws InputError naming the place if a value is not a finite number, or
   *   if the uniform stress is not symmetric.
   */
  std::vector<dealii::Tensor<1, 2>> tractions(const Packing &packing) const;

private:
  enum class Kind
  {
    traction,
    uniform_stress
  };

  std::vector<dealii::Tensor<1, 2>>
  tractions_of_expression(const Packing &packing) const;
  std::vector<dealii::Tensor<1, 2>>
  tractions_of_uniform_stress(const Packing &packing) const;

  Kind kind = Kind::traction;
  std::string traction = "0; 0";
  std::string stress = "0, 0; 0, 0";
  unsigned int n_quadrature_points = 5;
};
} // namespace Voussoir

#endif
