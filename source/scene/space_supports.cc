// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/formula/expression.h>
#include <voussoir/formula/place_variables.h>
#include <voussoir/packing/cell_groups.h>
#include <voussoir/packing/group_names.h>
#include <voussoir/packing/polyhedra/fixed_cells.h>
#include <voussoir/scene/space_supports.h>

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <utility>

namespace Voussoir
{
namespace
{
/** True for each boundary face on which @p condition holds. */
std::vector<bool> boundary_faces_where(const Packing<3> &packing,
                                       const std::string &condition,
                                       const std::string &parameter)
{
  const Condition holds(condition, variables_on_sides<3>(), parameter);
  std::vector<bool> chosen;
  for (const Packing<3>::BoundaryFace &face : packing.boundary_faces())
  {
    const dealii::Point<3> &x = face.centroid;
    const dealii::Tensor<1, 3> &n = face.normal;
    chosen.push_back(holds({x[0], x[1], x[2], n[0], n[1], n[2]}));
  }
  if (std::find(chosen.begin(), chosen.end(), true) == chosen.end())
    throw InputError("The condition '" + condition + "' of '" + parameter +
                     "' holds on no face of the boundary. It is asked at the "
                     "centroid x, y, z of what is free of each face, with the "
                     "outward normal nx, ny, nz; where rounding matters write "
                     "z < 1e-9 rather than z == 0.");
  return chosen;
}
} // namespace

void SpaceSupports::add_parameters(dealii::ParameterHandler &prm)
{
  prm.enter_subsection("Supports");
  prm.add_parameter(
      "Where", where,
      "The faces of the boundary that rest on the ground: those at whose "
      "centroid x, y, z, with the outward unit normal nx, ny, nz, this "
      "expression is not zero. They are interfaces to an immovable block, with "
      "contact and friction like all others. 0: none.",
      dealii::Patterns::Anything());
  prm.add_parameter(
      "Blocks", blocks,
      "The blocks that do not move, as parts of the ground: groups, or cells "
      "by number, with commas between them, as in \"abutment, cell 12\". They "
      "are numbered behind all others. Empty: those that a file marks.",
      dealii::Patterns::Anything());
  displacements.add_entries(prm);
  prm.leave_subsection();
}

Packing<3> SpaceSupports::support(Packing<3> packing) const
{
  if (!blocks.empty())
  {
    const std::string parameter = "Supports/Blocks";
    std::vector<bool> is_fixed(packing.polyhedra().n_cells(), false);
    for (const std::string &name : split_names(blocks))
      for (const unsigned int c : cells_of_name(packing, name, parameter))
        is_fixed.at(c) = true;
    packing = Packing<3>(with_fixed_cells(packing.polyhedra(), is_fixed));
  }
  const std::string parameter = "Supports/Where";
  if (!Condition(where, variables_on_sides<3>(), parameter).is_never())
    packing.support(boundary_faces_where(packing, where, parameter));
  return packing;
}
} // namespace Voussoir
