// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/fields/polyhedra.h>
#include <voussoir/output/fields/space_forces.h>
#include <voussoir/output/fields/space_ranges.h>

#include <utility>

namespace Voussoir
{
namespace
{
using InSpace = Packing<3>;

/** A quantity whose components are the columns "name x", "name y", "name z". */
Field<InSpace> vector_in_columns(Field<InSpace> field,
                                 const std::vector<std::string> &columns,
                                 const std::string &attribute)
{
  return field.with_columns(columns).with_attribute(attribute);
}

const std::vector<std::string> place_columns = {"x", "y", "z"};
const std::vector<std::string> normal_columns = {"nx", "ny", "nz"};

/** Centroid, unit normal and area of what @p list(packing) lists. */
template <typename Surface>
Fields<InSpace>
places_and_normals(const std::vector<Surface> &(InSpace::*const list)() const,
                   const std::string &what,
                   const std::string &normal)
{
  const auto member = [list](const auto of) {
    return [list, of](const InSpace &p) { return Stored((p.*list)(), of); };
  };
  return {
      vector_in_columns(
          {"centroid", "L", "the centroid " + what, member(&Surface::centroid)},
          place_columns, "centroids")
          .only_in_table(),
      vector_in_columns({"normal", "", normal, member(&Surface::normal)},
                        normal_columns, "normals"),
      Field<InSpace>("area", "L^2", "the area " + what, member(&Surface::area))
          .with_attribute("areas")};
}
} // namespace

const FieldTable<SpaceAnswer> &polyhedron_fields()
{
  static const FieldTable<SpaceAnswer> table(
      "cell group volume faces fixed",
      Fields<InSpace>{
          Field<InSpace>(
              "cell", "", "the number of the cell",
              [](const InSpace &, const unsigned int c) {
    return int(c); })
              .with_columns({"id"})
              .with_attribute(""),
          vector_in_columns(
              {"centre", "L", "its centre",
               [](const InSpace &p, const unsigned int c) -> const auto & {
                 return p.centre(c);
               }
},
              place_columns, "centres")
              .only_in_table(),
          Field<InSpace>("volume", "L^3", "its volume",
                         [](const InSpace &p, const unsigned int c) {
  return p.volume(c);
                         })
              .with_attribute("volumes"),
          Field<InSpace>("faces", "", "the number of its faces",
                         [](const InSpace &p, const unsigned int c) {
  const auto &first = p.polyhedra().first_face;
  return int(first[c + 1] - first[c]);
                         }),
          Field<InSpace>("fixed", "",
                         "1 if it does not move, as a part of the ground",
                         [](const InSpace &p, const unsigned int c) {
  return c >= p.ground();
                         }),
          Field<InSpace>("group", "", "the name of the cell's group",
                         [](const InSpace &p, const unsigned int c) {
  return int(p.group(c));
                         })
              .numbering([](const InSpace &p) -> const auto & {
  return p.group_names();
              })
              .with_attribute("groups")
              .saying_in_grid(
                  "its number in the list in `summary.json`, from 0; that of "
                  "the ground is the next")
} // namespace Voussoir
,
polyhedron_loads(), polyhedron_motion());
return table;
}

const FieldTable<SpaceAnswer> &face_interface_fields()
{
  const std::string cells =
      "the cells c- and c+; -1 is the ground without a shape";
  static const FieldTable<SpaceAnswer> table(
      "normal_force shear_force normal_stress utilisation cell_minus "
      "cell_plus area distance normal",
      Fields<InSpace>{{"cell_minus", "", cells,
                       [](const InSpace &p, const unsigned int e) {
                         return int(p.interfaces()[e].cell_minus);
                       }},
                      {"cell_plus", "", cells,
                       [](const InSpace &p, const unsigned int e) {
                         const InSpace::Interface &i = p.interfaces()[e];
                         return i.cell_plus != p.ground() ? int(i.cell_plus)
                                : i.fixed_cell != invalid_index
                                    ? int(i.fixed_cell)
                                    : -1;
                       }},
                      {"support", "", "1 if it is a support",
                       [](const InSpace &p, const unsigned int e) {
                         return p.interfaces()[e].cell_plus == p.ground();
                       }}},
      places_and_normals(&InSpace::interfaces, "x_e of the polygon",
                         "n_e, from c- to c+"),
      Fields<InSpace>{{"distance", "L", "d_e, of the centres along n_e",
                       [](const InSpace &p, const unsigned int e) {
                         return p.distance(p.interfaces()[e]);
                       }}},
      face_forces(), face_ranges(), face_jumps());
  return table;
}

const FieldTable<Packing<3>> &boundary_face_fields()
{
  static const FieldTable<InSpace> table(
      "cell",
      Fields<InSpace>{{"cell", "", "the cell that has the face",
                       [](const InSpace &p, const unsigned int b) {
                         return int(p.boundary_faces()[b].cell);
                       }}},
      places_and_normals(&InSpace::boundary_faces,
                         "of what is free of the face",
                         "the unit normal out of the cell"));
  return table;
}
} // namespace Voussoir
