// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/formula/vector_expression.h>
#include <voussoir/scene/supports.h>

#include <deal.II/base/patterns.h>

#include <algorithm>

namespace Voussoir
{
namespace
{
const std::vector<std::string> boundary_variables = {"x", "y", "nx", "ny"};
} // namespace

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
  prm.add_parameter(
      "Displacement", displacement,
      "How the supports move, \"u_x; u_y\" or \"u_x; u_y; angle\": a length "
      "each, and the angle by which an edge turns about its midpoint, "
      "counterclockwise in radians; expressions in the midpoint x, y of each "
      "supported edge and its outward unit normal nx, ny. The blocks follow in "
      "a motion of least energy, and the forces are those that go with it. "
      "Empty: they do not move, and 'Formulation' selects the forces.",
      dealii::Patterns::Anything());
  prm.leave_subsection();
}

void SupportParameters::support(Packing &packing) const
{
  const std::string parameter = "Supports/Where";
  if (!Condition(where, boundary_variables, parameter).is_never())
    packing.support(boundary_edges_where(packing, where, parameter));
}

std::vector<SupportMotion>
SupportParameters::motion(const Packing &packing) const
{
  const std::string parameter = "Supports/Displacement";
  if (displacement.empty())
    return {};
  if (packing.n_supports() == 0)
    throw InputError("'" + parameter +
                     "' is given, and there are no supports to move: "
                     "'Supports/Where' gives them.");
  const VectorExpression u(displacement, boundary_variables, parameter);
  if (u.size() < 2 || u.size() > 3)
    throw InputError("'" + parameter + "' = '" + displacement +
                     "' must be \"u_x; u_y\" or \"u_x; u_y; angle\".");
  std::vector<SupportMotion> motion;
  const auto &interfaces = packing.interfaces();
  for (std::size_t e = interfaces.size() - packing.n_supports();
       e < interfaces.size(); ++e)
  {
    const Packing::Interface &i = interfaces[e];
    const dealii::Point<2> x = i.midpoint();
    const auto component = [&](const unsigned int k) {
      return u.component(k, {x[0], x[1], i.normal[0], i.normal[1]}, [&] {
        return text(", below cell ", i.cell_minus,
                    "; a displacement must be finite.");
      });
    };
    motion.push_back({dealii::Tensor<1, 2>({component(0), component(1)}),
                      u.size() > 2 ? component(2) : 0.});
  }
  if (std::all_of(motion.begin(), motion.end(), [](const SupportMotion &of) {
        return of.displacement.norm() == 0. && of.rotation == 0.;
      }))
    throw InputError("'" + parameter + "' = '" + displacement +
                     "' is zero at every support; leave it empty, or move "
                     "one of them.");
  return motion;
}

std::vector<bool> boundary_edges_where(const Packing &packing,
                                       const std::string &condition,
                                       const std::string &parameter)
{
  const Condition holds(condition, boundary_variables, parameter);
  std::vector<bool> chosen;
  chosen.reserve(packing.boundary_edges().size());
  for (const Packing::BoundaryEdge &edge : packing.boundary_edges())
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
