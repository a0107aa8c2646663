// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/formula/place_variables.h>
#include <voussoir/formula/vector_expression.h>
#include <voussoir/packing/cell_groups.h>
#include <voussoir/packing/group_names.h>
#include <voussoir/scene/support_displacements.h>

#include <deal.II/base/patterns.h>

#include <algorithm>

namespace Voussoir
{
namespace
{
const std::string parameter_of_all = "Supports/Displacement",
                  parameter_of_groups = "Supports/Group displacements";

/** What the entries say of the dimension. */
template <int dim>
struct SupportWords
{
  static const std::string forms, angle, places;
};
template <>
const std::string SupportWords<2>::forms =
    "\"u_x; u_y\" or \"u_x; u_y; angle\"";
template <>
const std::string SupportWords<2>::angle =
    "the angle by which an edge turns about its midpoint, counterclockwise in "
    "radians";
template <>
const std::string SupportWords<2>::places =
    "the midpoint x, y of each supported edge and its outward unit normal nx, "
    "ny";
template <>
const std::string SupportWords<3>::forms =
    "\"u_x; u_y; u_z\" or \"u_x; u_y; u_z; a_x; a_y; a_z\"";
template <>
const std::string SupportWords<3>::angle =
    "the vector a of the small angle, in radians, by which a face turns about "
    "its centroid";
template <>
const std::string SupportWords<3>::places =
    "the centroid x, y, z of each supported face and its outward unit normal "
    "nx, ny, nz";

/** The supports under the cells of a name, which have had no motion yet. */
template <int dim>
std::vector<unsigned int> supports_of(const Packing<dim> &packing,
                                      const std::string &name,
                                      std::vector<bool> &has_own)
{
  const std::vector<unsigned int> cells =
      cells_of_name(packing, name, parameter_of_groups);
  const auto &interfaces = packing.interfaces();
  const std::size_t first = interfaces.size() - packing.n_supports();
  std::vector<unsigned int> supports;
  for (unsigned int k = 0; k < packing.n_supports(); ++k)
  {
    const unsigned int c = interfaces[first + k].cell_minus;
    if (!std::binary_search(cells.begin(), cells.end(), c))
      continue;
    if (has_own[k])
      throw InputError(text("The parameter '", parameter_of_groups,
                            "' moves the support of cell ", c,
                            " twice, the second time as '", name,
                            "'; give it once."));
    has_own[k] = true;
    supports.push_back(k);
  }
  if (supports.empty())
    throw InputError("The parameter '" + parameter_of_groups +
                     "' moves the supports of '" + name +
                     "', which has none; choose them by 'Supports/Where'.");
  return supports;
}

/** @{ */
/** What the components of an expression are at a support. */
SupportMotion motion_at(const VectorExpression &u,
                        const Packing<2>::Interface &i)
{
  const dealii::Point<2> x = i.midpoint();
  const auto component = [&](const unsigned int j) {
    return u.component(j, {x[0], x[1], i.normal[0], i.normal[1]}, [&] {
      return text(", below cell ", i.cell_minus,
                  "; a displacement must be finite.");
    });
  };
  return {dealii::Tensor<1, 2>({component(0), component(1)}),
          u.size() > 2 ? component(2) : 0.};
}
SpaceSupportMotion motion_at(const VectorExpression &u,
                             const Packing<3>::Interface &i)
{
  const dealii::Point<3> &x = i.centroid;
  SpaceSupportMotion motion;
  for (unsigned int j = 0; j < u.size(); ++j)
    (j < 3 ? motion.displacement : motion.rotation)[j % 3] = u.component(
        j, {x[0], x[1], x[2], i.normal[0], i.normal[1], i.normal[2]}, x,
        text(", below cell ", i.cell_minus,
             "; a displacement must be finite."));
  return motion;
}
/** @} */

/** @{ */
/** True if a support is at rest. */
bool is_at_rest(const SupportMotion &of)
{
  return of.displacement.norm() == 0. && of.rotation == 0.;
}
bool is_at_rest(const SpaceSupportMotion &of)
{
  return of.displacement.norm() == 0. && of.rotation.norm() == 0.;
}
/** @} */

/** Let supports move by the expression @p value. */
template <int dim>
void move(const Packing<dim> &packing,
          const std::vector<unsigned int> &supports,
          const std::string &value,
          const std::string &parameter,
          std::vector<SupportMotionIn<dim>> &motion)
{
  const VectorExpression u(value, variables_on_sides<dim>(), parameter);
  if (u.size() != dim && u.size() != (dim == 2 ? 3 : 6))
    throw InputError("'" + parameter + "' = '" + value + "' must be " +
                     SupportWords<dim>::forms + ".");
  const std::size_t first = packing.interfaces().size() - packing.n_supports();
  for (const unsigned int k : supports)
    motion[k] = motion_at(u, packing.interfaces()[first + k]);
}
} // namespace

template <int dim>
void SupportDisplacements<dim>::add_entries(dealii::ParameterHandler &prm)
{
  prm.add_parameter(
      "Displacement", of_all,
      "How the supports move, " + SupportWords<dim>::forms +
          ": a length each, and " + SupportWords<dim>::angle +
          "; expressions in " + SupportWords<dim>::places +
          ". The blocks follow in a motion of least energy, and the forces are "
          "those that go with it. Empty: they do not move, and 'Formulation' "
          "selects the forces.",
      dealii::Patterns::Anything());
  prm.add_parameter(
      "Group displacements", of_groups,
      "The same for the supports of groups of cells, or of cells by number, in "
      "place of 'Displacement': " +
          std::string(dim == 2
                          ? "\"name: u_x; u_y | name: u_x; u_y\"."
                          : "\"name: u_x; u_y; u_z | name: u_x; u_y; u_z\"."),
      dealii::Patterns::Anything());
}

template <int dim>
std::vector<SupportMotionIn<dim>>
SupportDisplacements<dim>::motion(const Packing<dim> &packing) const
{
  if (of_all.empty() && of_groups.empty())
    return {};
  const std::string &given =
      of_all.empty() ? parameter_of_groups : parameter_of_all;
  if (packing.n_supports() == 0)
    throw InputError("'" + given +
                     "' is given, and there are no supports to move: "
                     "'Supports/Where' gives them.");
  std::vector<SupportMotionIn<dim>> motion(packing.n_supports());
  std::vector<bool> has_own(packing.n_supports(), false);
  for (const auto &[name, value] :
       split_named_list(of_groups, parameter_of_groups, true))
    move(packing, supports_of(packing, name, has_own), value,
         parameter_of_groups, motion);
  std::vector<unsigned int> others;
  for (unsigned int k = 0; k < packing.n_supports(); ++k)
    if (!has_own[k])
      others.push_back(k);
  if (!of_all.empty())
    move(packing, others, of_all, parameter_of_all, motion);
  if (std::all_of(motion.begin(), motion.end(),
                  [](const auto &of) { return is_at_rest(of); }))
    throw InputError("'" + given + "' = '" +
                     (of_all.empty() ? of_groups : of_all) +
                     "' is zero at every support; leave it empty, or move "
                     "one of them.");
  return motion;
}

template class SupportDisplacements<2>;
template class SupportDisplacements<3>;
} // namespace Voussoir
