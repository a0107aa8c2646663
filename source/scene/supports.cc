// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/formula/expression.h>
#include <voussoir/formula/place_variables.h>
#include <voussoir/scene/supports.h>

#include <deal.II/base/patterns.h>

#include <algorithm>

namespace Voussoir
{
void SupportParameters::add_parameters(dealii::ParameterHandler &prm)
{
  prm.enter_subsection("Supports");
  prm.add_parameter("Where", where,
                    "The boundary edges that rest on the ground: those at "
                    "whose midpoint x, y, with the outward unit normal nx, ny, "
                    "this expression is not zero. They are interfaces to an "
                    "immovable block, with contact and friction like all "
                    "others, and no load acts on them. 0: none.",
                    dealii::Patterns::Anything());
  displacements.add_entries(prm);
  prm.leave_subsection();
}

void SupportParameters::support(Packing<2> &packing) const
{
  const std::string parameter = "Supports/Where";
  if (!Condition(where, variables_on_sides<2>(), parameter).is_never())
    packing.support(boundary_edges_where(packing, where, parameter));
}

std::vector<bool> boundary_edges_where(const Packing<2> &packing,
                                       const std::string &condition,
                                       const std::string &parameter)
{
  const Condition holds(condition, variables_on_sides<2>(), parameter);
  std::vector<bool> chosen;
  chosen.reserve(packing.boundary_edges().size());
  for (const Packing<2>::BoundaryEdge &edge : packing.boundary_edges())
  {
    const dealii::Point<2> x = edge.midpoint();
    chosen.push_back(holds({x[0], x[1], edge.normal[0], edge.normal[1]}));
  }
  if (std::find(chosen.begin(), chosen.end(), true) == chosen.end())
    throw InputError("The condition '" + condition + "' of '" + parameter +
                     "' holds on no edge of the boundary. It is asked at the "
                     "midpoint x, y of each edge, with the outward normal nx, "
                     "ny; where rounding matters write y < 1e-9 rather than "
                     "y == 0.");
  return chosen;
}
} // namespace Voussoir
