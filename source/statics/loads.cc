// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/expression.h>
#include <voussoir/base/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/loads.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>

#include <cmath>

namespace Voussoir
{
using dealii::Tensor;

void LoadParameters::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  prm.enter_subsection("Loads");
  add_choice<Kind>(
      prm, "Boundary load", kind,
      {{Kind::traction, "traction", "the expressions in 'Traction'."},
       {Kind::uniform_stress, "uniform stress",
        "g = S n with the tensor S in 'Stress'."}},
      "What acts on the boundary.");
  prm.add_parameter("Traction", traction,
                    "The components \"g_x; g_y\" of the traction on the "
                    "boundary; stresses, tension positive. Expressions in x, "
                    "y and the outward unit normal nx, ny.",
                    List(Anything(), 2, 2, ";"));
  prm.add_parameter("Stress", stress,
                    "The symmetric tensor \"S_xx, S_xy; S_yx, S_yy\" of the "
                    "uniform stress; stresses, tension positive.",
                    List(List(Double(), 2, 2, ","), 2, 2, ";"));
  prm.add_parameter("Quadrature points", n_quadrature_points,
                    "Gauss points per boundary edge for the mean of "
                    "'Traction'; raise it for loads that vary within an edge "
                    "more than a polynomial of a few degrees.",
                    Integer(1, 100));
  prm.leave_subsection();
}

std::vector<Tensor<1, 2>>
LoadParameters::tractions(const Packing &packing) const
{
  return kind == Kind::traction ? tractions_of_expression(packing)
                                : tractions_of_uniform_stress(packing);
}

std::vector<Tensor<1, 2>>
LoadParameters::tractions_of_expression(const Packing &packing) const
{
  const std::string name = "Loads/Traction";
  const std::vector<std::string> components =
      dealii::Utilities::split_string_list(traction, ';');
  std::vector<Expression> g;
  for (const std::string &component : components)
    g.emplace_back(component, std::vector<std::string>{"x", "y", "nx", "ny"},
                   name);

  const dealii::QGauss<1> quadrature(n_quadrature_points);
  std::vector<Tensor<1, 2>> tractions;
  tractions.reserve(packing.boundary_edges().size());
  for (const Packing::BoundaryEdge &edge : packing.boundary_edges())
  {
    Tensor<1, 2> mean;
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      for (unsigned int i = 0; i < 2; ++i)
      {
        const dealii::Point<2> p =
            edge.start + quadrature.point(q)[0] * (edge.end - edge.start);
        const double value = g[i]({p[0], p[1], edge.normal[0], edge.normal[1]});
        if (!std::isfinite(value))
          throw InputError(text("'", name, "' has the component '",
                                components[i], "', which is ",
                                text_of_number(value), " at ", text_of_point(p),
                                ", on the boundary of cell ", edge.cell,
                                "; a traction must be finite."));
        mean[i] += quadrature.weight(q) * value;
      }
    tractions.push_back(mean);
  }
  return tractions;
}

std::vector<Tensor<1, 2>>
LoadParameters::tractions_of_uniform_stress(const Packing &packing) const
{
  Tensor<2, 2> S;
  dealii::Patterns::Tools::to_value(stress, S);
  if (S[0][1] != S[1][0] || !std::isfinite(S.norm()))
    throw InputError("'Loads/Stress' = '" + stress +
                     "' must be finite and symmetric: S_xy = S_yx.");

  std::vector<Tensor<1, 2>> tractions;
  tractions.reserve(packing.boundary_edges().size());
  for (const Packing::BoundaryEdge &edge : packing.boundary_edges())
    tractions.push_back(S * edge.normal);
  return tractions;
}
} // namespace Voussoir
