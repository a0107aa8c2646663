// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/scene/loads/body_force_formulas.h>
#include <voussoir/scene/loads/expressed_tractions.h>
#include <voussoir/scene/loads/loads.h>
#include <voussoir/scene/supports.h>

#include <deal.II/base/patterns.h>

#include <cmath>
#include <utility>

namespace Voussoir
{
using dealii::Tensor;

Loads no_loads(const Packing<2> &packing)
{
  Loads loads;
  loads.traction.resize(packing.boundary_edges().size());
  loads.requested.emplace(reference_point(packing));
  return loads;
}

void Loads::add(const double factor, const Loads &other)
{
  for (std::size_t b = 0; b < traction.size(); ++b)
    traction[b] += factor * other.traction[b];
  if (traction_moment.empty())
    traction_moment.resize(other.traction_moment.size());
  for (std::size_t b = 0; b < other.traction_moment.size(); ++b)
    traction_moment[b] += factor * other.traction_moment[b];
  body.add(factor, other.body);
  for (CellForce force : other.on_cells)
  {
    force.force *= factor;
    on_cells.push_back(std::move(force));
  }
  warnings.insert(warnings.end(), other.warnings.begin(), other.warnings.end());
  if (requested && other.requested)
    requested->add(factor, *other.requested);
  else
    requested.reset();
}

void LoadParameters::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  prm.enter_subsection(name);
  add_choice<Kind>(prm, "Boundary load", kind,
                   {{Kind::traction, "traction",
                     "the expressions in 'Traction'.", "Traction"},
                    {Kind::uniform_stress, "uniform stress",
                     "g = S n with the tensor S in 'Stress'.", "Stress"}},
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
  prm.add_parameter("Where", loaded_where,
                    "The boundary edges that the load acts on: those at whose "
                    "midpoint x, y, with the outward unit normal nx, ny, this "
                    "expression is not zero. 1: all that are not supported.",
                    Anything());
  prm.add_parameter(
      "Segment tractions", on_segments,
      "Further tractions on straight lines along the boundary, from point to "
      "point: \"x, y to x, y: g_x, g_y | ...\", as in 0.27, 1 to 0.43, 1: 0, "
      "-10 for a strip load; or \"x, y to x, y: g_x, g_y to g_x, g_y\" for "
      "one that varies linearly, as a pressure of water does. Stresses; lines "
      "may begin and end anywhere on edges that are not supported.",
      Anything());
  prm.add_parameter("Body force", body,
                    "The components \"b_x; b_y\" of a force per unit area and "
                    "thickness, such as weight: 0; -20 in kN/m^3. Expressions "
                    "in x and y; or lists with a number for each cell, in "
                    "their order, as in list 0, 0; list -20, -18.",
                    List(Anything(), 2, 2, ";"));
  prm.add_parameter("Group body forces", body_of_groups,
                    "The same for groups of cells, or cells by number, in "
                    "place of 'Body force': \"name: b_x; b_y | name: b_x; "
                    "b_y\", as in stone: 0; -24 | fill: 0; -18.",
                    Anything());
  prm.add_parameter("Cell forces", cell_forces,
                    "Point loads: \"at x, y: F_x, F_y | at x, y: F_x, F_y\" "
                    "for forces on the cells at these places; or by name, as "
                    "in keystone: 0, -10, on each cell of the group of that "
                    "name, or on the cell with a number, as in cell 12: 0, "
                    "-5, spread evenly over it or acting at a place, as in "
                    "cell 12: 0, -5 at 0.3, 1; or lists as for 'Body force'. "
                    "Per unit thickness.",
                    Anything());
  vehicle.add_parameters(prm);
  prm.leave_subsection();
}

Loads LoadParameters::loads(const Packing<2> &packing,
                            const std::vector<Spreading> &soil) const
{
  Loads loads;
  loads.requested.emplace(reference_point(packing));
  add_tractions(packing, loads);
  loads.body =
      body_force_of_formulas(packing, {section + "/Body force", body},
                             {section + "/Group body forces", body_of_groups},
                             loads.warnings, *loads.requested);
  loads.on_cells =
      cell_forces_of_text(packing, cell_forces, section + "/Cell forces");
  for (CellForce &axle : vehicle.forces(packing, soil, section, loads.warnings))
    loads.on_cells.push_back(std::move(axle));
  for (const CellForce &f : loads.on_cells)
    for (const unsigned int c : f.cells)
      loads.requested->add(f.place_in(packing, c), f.force);
  return loads;
}

void LoadParameters::add_tractions(const Packing<2> &packing,
                                   Loads &loads) const
{
  const unsigned int n_edges = packing.boundary_edges().size();
  const std::vector<bool> chosen =
      loaded_where == "1"
          ? std::vector<bool>(n_edges, true)
          : boundary_edges_where(packing, loaded_where, section + "/Where");
  EdgeTractions tractions(n_edges);
  if (kind == Kind::traction)
    set_expressed_tractions(packing, traction, section + "/Traction", chosen,
                            tractions, *loads.requested, loads.warnings);
  else
    add_uniform_stress(packing, chosen, tractions, loads);
  const std::string parameter = section + "/Segment tractions";
  for (const SegmentTraction &segment :
       segment_tractions_of_text(on_segments, parameter))
  {
    add_segment_traction(packing, segment, parameter, tractions);
    for (const auto &[place, force] : segment.resultants())
      loads.requested->add(place, force);
  }
  loads.traction = std::move(tractions.mean);
  loads.traction_moment = std::move(tractions.first_moment);
}

void LoadParameters::add_uniform_stress(const Packing<2> &packing,
                                        const std::vector<bool> &chosen,
                                        EdgeTractions &tractions,
                                        Loads &loads) const
{
  Tensor<2, 2> S;
  dealii::Patterns::Tools::to_value(stress, S);
  if (S[0][1] != S[1][0] || !std::isfinite(S.norm()))
    throw InputError("'" + section + "/Stress' = '" + stress +
                     "' must be finite and symmetric: S_xy = S_yx.");
  for (unsigned int b = 0; b < chosen.size(); ++b)
  {
    if (!chosen[b])
      continue;
    const Packing<2>::BoundaryEdge &edge = packing.boundary_edges()[b];
    tractions.mean[b] += S * edge.normal;
    const Tensor<1, 2> side = edge.end - edge.start;
    loads.requested->add(edge.midpoint(),
                         S * Tensor<1, 2>({side[1], -side[0]}));
  }
}
} // namespace Voussoir
