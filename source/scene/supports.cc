// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/formula/vector_expression.h>
#include <voussoir/packing/cell_groups.h>
#include <voussoir/packing/group_names.h>
#include <voussoir/scene/supports.h>

#include <deal.II/base/patterns.h>

#include <algorithm>

namespace Voussoir
{
namespace
{
const std::vector<std::string> boundary_variables = {"x", "y", "nx", "ny"};

/** The supports under the cells of a name, which have had no motion yet. */
std::vector<unsigned int> supports_of(const Packing<2> &packing,
                                      const std::string &name,
                                      const std::string &parameter,
                                      std::vector<bool> &has_own)
{
  const std::vector<unsigned int> cells =
      cells_of_name(packing, name, parameter);
  const auto &interfaces = packing.interfaces();
  const std::size_t first = interfaces.size() - packing.n_supports();
  std::vector<unsigned int> supports;
  for (unsigned int k = 0; k < packing.n_supports(); ++k)
  {
    const unsigned int c = interfaces[first + k].cell_minus;
    if (!std::binary_search(cells.begin(), cells.end(), c))
      continue;
    if (has_own[k])
      throw InputError(
          text("The parameter '", parameter, "' moves the support of cell ", c,
               " twice, the second time as '", name, "'; give it once."));
    has_own[k] = true;
    supports.push_back(k);
  }
  if (supports.empty())
    throw InputError("The parameter '" + parameter +
                     "' moves the supports of '" + name +
                     "', which has none; choose them by 'Supports/Where'.");
  return supports;
}

/** Let supports move by "u_x; u_y" or "u_x; u_y; angle". */
void move(const Packing<2> &packing,
          const std::vector<unsigned int> &supports,
          const std::string &value,
          const std::string &parameter,
          std::vector<SupportMotion> &motion)
{
  const VectorExpression u(value, boundary_variables, parameter);
  if (u.size() < 2 || u.size() > 3)
    throw InputError("'" + parameter + "' = '" + value +
                     "' must be \"u_x; u_y\" or \"u_x; u_y; angle\".");
  const std::size_t first = packing.interfaces().size() - packing.n_supports();
  for (const unsigned int k : supports)
  {
    const Packing<2>::Interface &i = packing.interfaces()[first + k];
    const dealii::Point<2> x = i.midpoint();
    const auto component = [&](const unsigned int j) {
      return u.component(j, {x[0], x[1], i.normal[0], i.normal[1]}, [&] {
        return text(", below cell ", i.cell_minus,
                    "; a displacement must be finite.");
      });
    };
    motion[k] = {dealii::Tensor<1, 2>({component(0), component(1)}),
                 u.size() > 2 ? component(2) : 0.};
  }
}
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
  prm.add_parameter(
      "Group displacements", displacement_of_groups,
      "The same for the supports of groups of cells, or of cells by number, in "
      "place of 'Displacement': \"name: u_x; u_y | name: u_x; u_y\".",
      dealii::Patterns::Anything());
  prm.leave_subsection();
}

void SupportParameters::support(Packing<2> &packing) const
{
  const std::string parameter = "Supports/Where";
  if (!Condition(where, boundary_variables, parameter).is_never())
    packing.support(boundary_edges_where(packing, where, parameter));
}

std::vector<SupportMotion>
SupportParameters::motion(const Packing<2> &packing) const
{
  const std::string parameter = "Supports/Displacement";
  const std::string of_groups = "Supports/Group displacements";
  if (displacement.empty() && displacement_of_groups.empty())
    return {};
  const std::string &given = displacement.empty() ? of_groups : parameter;
  if (packing.n_supports() == 0)
    throw InputError("'" + given +
                     "' is given, and there are no supports to move: "
                     "'Supports/Where' gives them.");
  std::vector<SupportMotion> motion(packing.n_supports());
  std::vector<bool> has_own(packing.n_supports(), false);
  for (const auto &[name, value] :
       split_named_list(displacement_of_groups, of_groups, true))
    move(packing, supports_of(packing, name, of_groups, has_own), value,
         of_groups, motion);
  std::vector<unsigned int> others;
  for (unsigned int k = 0; k < packing.n_supports(); ++k)
    if (!has_own[k])
      others.push_back(k);
  if (!displacement.empty())
    move(packing, others, displacement, parameter, motion);
  if (std::all_of(motion.begin(), motion.end(), [](const SupportMotion &of) {
        return of.displacement.norm() == 0. && of.rotation == 0.;
      }))
    throw InputError(
        "'" + given + "' = '" +
        (displacement.empty() ? displacement_of_groups : displacement) +
        "' is zero at every support; leave it empty, or move "
        "one of them.");
  return motion;
}

std::vector<bool> boundary_edges_where(const Packing<2> &packing,
                                       const std::string &condition,
                                       const std::string &parameter)
{
  const Condition holds(condition, boundary_variables, parameter);
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
