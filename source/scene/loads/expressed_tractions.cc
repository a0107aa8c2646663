// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/formula/integrals/edge_integral.h>
#include <voussoir/formula/integrals/inaccuracies.h>
#include <voussoir/formula/place_variables.h>
#include <voussoir/formula/vector_expression.h>
#include <voussoir/scene/loads/expressed_tractions.h>

#include <utility>

namespace Voussoir
{
using dealii::Point;

void set_expressed_tractions(const Packing<2> &packing,
                             const std::string &expression,
                             const std::string &parameter,
                             const std::vector<bool> &chosen,
                             EdgeTractions &tractions,
                             Resultant &requested,
                             std::vector<std::string> &warnings)
{
  const VectorExpression g(expression, variables_on_sides<2>(), parameter);
  Discontinuities jumps[2] = {{{g.formula(0)}, {0., 0.}},
                              {{g.formula(1)}, {0., 0.}}};
  Inaccuracies inaccuracies(parameter);
  for (unsigned int b = 0; b < chosen.size(); ++b)
  {
    if (!chosen[b])
      continue;
    const Packing<2>::BoundaryEdge &edge = packing.boundary_edges()[b];
    const auto where = [&] {
      return text(", on the boundary of cell ", edge.cell,
                  "; a traction must be finite.");
    };
    for (unsigned int i = 0; i < 2; ++i)
    {
      jumps[i].set_constants({edge.normal[0], edge.normal[1]});
      const EdgeIntegral integral = edge_integral(
          edge.start, edge.end,
          [&](const Point<2> &p) {
            return g.component(i, {p[0], p[1], edge.normal[0], edge.normal[1]},
                               where);
          },
          jumps[i]);
      tractions.mean[b][i] = integral.mean;
      tractions.first_moment[b][i] =
          edge.length * edge.length * integral.moment;
      inaccuracies.look_at(integral.error, integral.size, integral.uncertain,
                           [&] { return along_edge(edge.start, edge.end); });
    }
    requested.add(edge, tractions.mean[b], tractions.first_moment[b]);
  }
  for (std::string &warning : inaccuracies.warnings())
    warnings.push_back(std::move(warning));
}
} // namespace Voussoir
