// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/fields/edges.h>

namespace Voussoir
{
namespace
{
/**
 * What interfaces and boundary edges have, as @p edges(data) lists them.
 *
 * @param prefix of the attributes of Python.
 */
template <typename Data, typename Edge>
Fields<Data> ends_and_normals(const std::vector<Edge> &(*edges)(const Data &),
                              const std::string &prefix,
                              const std::string &ends,
                              const std::string &normal)
{
  const auto member = [edges](const auto of) {
    return [edges, of](const Data &data) { return Stored(edges(data), of); };
  };
  return only_in_table<Data>(
      {Field<Data>("start", "L", ends, member(&Edge::start))
           .with_columns({"x0", "y0"})
           .with_attribute(prefix + "starts"),
       Field<Data>("end", "L", ends, member(&Edge::end))
           .with_columns({"x1", "y1"})
           .with_attribute(prefix + "ends"),
       Field<Data>("normal", "", normal, member(&Edge::normal))
           .with_columns({"nx", "ny"})
           .with_attribute(prefix + "normals"),
       Field<Data>("length", "L", "|e|", member(&Edge::length))
           .with_attribute(prefix + "lengths")});
}

const std::vector<Packing<2>::Interface> &
interfaces_of(const Packing<2> &packing)
{
  return packing.interfaces();
}

const std::vector<Packing<2>::BoundaryEdge> &boundary_of(const Scene &scene)
{
  return scene.packing.boundary_edges();
}
} // namespace

Fields<Packing<2>> interface_edges()
{
  const std::string cells = "the cells c- and c+; -1 is the ground";
  return together<Packing<2>>(
      {{{"cell_minus", "", cells,
         [](const Packing<2> &p, const unsigned int e) {
           return int(p.interfaces()[e].cell_minus);
         }},
        {"cell_plus", "", cells,
         [](const Packing<2> &p, const unsigned int e) {
           const unsigned int plus = p.interfaces()[e].cell_plus;
           return plus == p.ground() ? -1 : int(plus);
         }}},
       ends_and_normals(interfaces_of, "",
                        "the ends; t_e runs from the first to the second",
                        "n_e, from c- to c+")});
}

Fields<Packing<2>> branch_vectors()
{
  return only_in_table<Packing<2>>(
      {{"branch", "L",
        "the branch vector, from the centre of c- to that of c+; of a support "
        "to its midpoint",
        [](const Packing<2> &p, const unsigned int e) -> dealii::Tensor<1, 2> {
          const Packing<2>::Interface &i = p.interfaces()[e];
          return (i.cell_plus == p.ground() ? i.midpoint()
                                            : p.centre(i.cell_plus)) -
                 p.centre(i.cell_minus);
        }}});
}

Fields<Scene> boundary_edges()
{
  return together<Scene>(
      {{Field<Scene>("cell", "", "the block",
                     [](const Scene &s, const unsigned int b) {
                       return int(boundary_of(s)[b].cell);
                     })
            .with_attribute("boundary_cells")},
       ends_and_normals(boundary_of, "boundary_",
                        "the ends, counterclockwise around the block",
                        "the outward normal"),
       {Field<Scene>("force", "S L", "the force of the traction on it",
                     [](const Scene &s, const unsigned int b) {
                       return boundary_of(s)[b].length * s.traction[b];
                     })
            .with_attribute("boundary_forces"),
        Field<Scene>(
            "moment", "S L^2",
            "the integral of the traction times the distance from the "
            "midpoint, positive towards (x1, y1); zero where the traction is "
            "constant",
            [](const Scene &s) { return Stored(s.traction_moment); })
            .with_attribute("boundary_moments"),
        Field<Scene>(
            "branch", "L",
            "the branch vector, from the centre of the block to the midpoint",
            [](const Scene &s, const unsigned int b) -> dealii::Tensor<1, 2> {
              const Packing<2>::BoundaryEdge &edge = boundary_of(s)[b];
              return edge.midpoint() - s.packing.centre(edge.cell);
            })
            .with_attribute("boundary_branches")}});
}
} // namespace Voussoir
