// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/formula/expression.h>
#include <voussoir/scene/links/fill.h>
#include <voussoir/scene/loads/expressed_tractions.h>
#include <voussoir/scene/supports.h>

#include <deal.II/base/patterns.h>

#include <cmath>
#include <memory>
#include <utility>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/** All digits of a number, for an expression. */
std::string digits_of(const double x)
{
  std::ostringstream out;
  out.precision(17);
  out << x;
  return '(' + out.str() + ')';
}

/** The tractions of an expression of the fill @p path on edges. */
Loads tractions_of(const std::string &expression,
                   const std::string &path,
                   const Packing<2> &packing,
                   const std::vector<bool> &chosen)
{
  EdgeTractions tractions(chosen.size());
  Loads loads = no_loads(packing);
  set_expressed_tractions(packing, expression, path + "/Top", chosen, tractions,
                          *loads.requested, loads.warnings);
  loads.traction = std::move(tractions.mean);
  loads.traction_moment = std::move(tractions.first_moment);
  return loads;
}

/** Add what stands on edges that face upwards. */
void add_columns(const Packing<2> &packing,
                 const std::vector<bool> &chosen,
                 const Spreading::Height &top,
                 std::vector<std::array<Point<2>, 4>> &columns)
{
  for (unsigned int b = 0; b < chosen.size(); ++b)
  {
    const Packing<2>::BoundaryEdge &edge = packing.boundary_edges()[b];
    if (!chosen[b] || !(edge.normal[1] > 0.))
      continue;
    const Point<2> start(edge.start[0], top(edge.start[0]));
    const Point<2> end(edge.end[0], top(edge.end[0]));
    if (start[1] >= edge.start[1] && end[1] >= edge.end[1])
      columns.push_back({{edge.start, start, end, edge.end}});
  }
}
} // namespace

void Fill::add_parameters(dealii::ParameterHandler &prm,
                          const std::set<std::string> &names)
{
  using namespace dealii::Patterns;
  if (names.empty())
    return;
  prm.enter_subsection(fill_section);
  for (const std::string &name : names)
  {
    check_link_name(fill_section, name);
    Entries &soil = of_name[name];
    prm.enter_subsection(name);
    prm.add_parameter("Where", soil.where,
                      "The boundary edges that the soil lies on or against: "
                      "those at whose midpoint x, y, with the outward unit "
                      "normal nx, ny, this expression is not zero.",
                      Anything());
    prm.add_parameter("Top", soil.top,
                      "The height y of its surface, an expression in x; edges "
                      "above it are not touched. A length.",
                      Anything());
    prm.add_parameter("Unit weight", soil.unit_weight,
                      "Its weight, over area and thickness; a stress over a "
                      "length, not negative.",
                      Double(0.));
    prm.add_parameter("Surcharge", soil.surcharge,
                      "The vertical stress on its surface; not negative.",
                      Double(0.));
    prm.add_parameter("Active coefficient", soil.active,
                      "K_a, the least horizontal pressure over the vertical "
                      "stress, where blocks yield to the soil. By Rankine that "
                      "is tan(pi/4 - phi/2)^2 with the angle of friction phi, "
                      "which 'Variables' can be asked for.",
                      Double(0.));
    prm.add_parameter("Passive coefficient", soil.passive,
                      "K_p, the greatest, where blocks push the soil: by "
                      "Rankine 1 / K_a, of which often a part is counted on. "
                      "0: the soil does not push sidewards.",
                      Double(0.));
    add_choice<Spreading::Law>(
        prm, "Spreading", soil.law,
        {{Spreading::Law::none, "none", "they stand on the blocks."},
         {Spreading::Law::uniform, "uniform",
          "along rays within 'Spreading angle', evenly on level ground."},
         {Spreading::Law::elastic, "elastic",
          "along these, as in the elastic half plane of Boussinesq."}},
        "How the axles of a 'Vehicle' on its surface come to the blocks.");
    prm.add_parameter("Spreading angle", soil.angle,
                      "The largest angle of a ray from the vertical, in "
                      "degrees; 26.565 is one to two.",
                      Double(0.01, 89.));
    prm.leave_subsection();
  }
  prm.leave_subsection();
}

FillOnBlocks Fill::on(const Packing<2> &packing) const
{
  FillOnBlocks all = {no_loads(packing), {}, {}, {}};
  for (const auto &[name, soil] : of_name)
    add(name, soil, packing, all);
  return all;
}

/** sigma, an expression in x and y. */
std::string Fill::Entries::vertical_stress() const
{
  const std::string depth = "((" + top + ") - y)";
  return '(' + depth + " > 0 ? " + digits_of(unit_weight) + " * " + depth +
         " + " + digits_of(surcharge) + " : 0)";
}

void Fill::add(const std::string &name,
               const Entries &soil,
               const Packing<2> &packing,
               FillOnBlocks &all) const
{
  const std::string path = fill_section + "/" + name;
  if (soil.passive < soil.active)
    throw InputError(text("The fill '", path, "' has the active coefficient ",
                          soil.active, " and the passive one ", soil.passive,
                          "; the first must not be larger."));
  // For its own message, before it stands in others.
  const auto surface = std::make_shared<const Expression>(
      soil.top, std::vector<std::string>{"x"}, path + "/Top");
  const Spreading::Height top = [surface](const double x) {
    return (*surface)({x});
  };
  const std::vector<bool> chosen =
      boundary_edges_where(packing, soil.where, path + "/Where");
  const std::string sigma = soil.vertical_stress();
  all.loads.add(
      1., tractions_of("0; -max(ny, 0) * " + sigma, path, packing, chosen));
  add_columns(packing, chosen, top, all.columns);
  if (soil.law != Spreading::Law::none)
    all.spreading.push_back(
        {soil.law, soil.angle * dealii::numbers::PI / 180., chosen, top});
  if (soil.passive > 0.)
    add_sides(name, soil,
              tractions_of("abs(nx) * " + sigma + "; 0", path, packing, chosen),
              packing, all.links);
}

/** @param sidewards has the integrals of sigma |n_x| on edges. */
void Fill::add_sides(const std::string &name,
                     const Entries &soil,
                     const Loads &sidewards,
                     const Packing<2> &packing,
                     std::vector<Link> &links)
{
  for (unsigned int b = 0; b < sidewards.traction.size(); ++b)
  {
    const Packing<2>::BoundaryEdge &edge = packing.boundary_edges()[b];
    const double force = edge.length * sidewards.traction[b][0];
    if (!(force > 0.))
      continue;
    const Tensor<1, 2> along = (edge.end - edge.start) / edge.length;
    const Point<2> place =
        edge.midpoint() + sidewards.traction_moment[b][0] / force * along;
    const Tensor<1, 2> outwards({std::copysign(1., edge.normal[0]), 0.});
    links.push_back({name, edge.cell, packing.ground(), place,
                     place + edge.length * outwards, outwards,
                     -soil.passive * force, 0. - soil.active * force, true});
  }
}
} // namespace Voussoir
