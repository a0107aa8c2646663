// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/fields/polyhedra.h>
#include <voussoir/output/fields/space_clamping.h>
#include <voussoir/output/fields/space_forces.h>
#include <voussoir/output/fields/space_ranges.h>
#include <voussoir/output/fields/space_stress.h>

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

/**
 * Centroid, unit normal and area of what @p list(packing) lists.
 *
 * @param prefix of the attributes of Python.
 */
template <typename Surface>
Fields<InSpace>
places_and_normals(const std::vector<Surface> &(InSpace::*const list)() const,
                   const std::string &prefix,
                   const std::string &what,
                   const std::string &normal)
{
  const auto member = [list](const auto of) {
    return [list, of](const InSpace &p) { return Stored((p.*list)(), of); };
  };
  return {
      vector_in_columns(
          {"centroid", "L", "the centroid " + what, member(&Surface::centroid)},
          place_columns, prefix + "centroids")
          .only_in_table(),
      vector_in_columns({"normal", "", normal, member(&Surface::normal)},
                        normal_columns, prefix + "normals"),
      Field<InSpace>("area", "L^2", "the area " + what, member(&Surface::area))
          .with_attribute(prefix + "areas")};
}

int number_of(const InSpace &, const unsigned int c)
{
  return int(c);
}

const dealii::Point<3> &centre_of(const InSpace &p, const unsigned int c)
{
  return p.centre(c);
}

double volume_of(const InSpace &p, const unsigned int c)
{
  return p.volume(c);
}

int n_faces_of(const InSpace &p, const unsigned int c)
{
  const auto &first = p.polyhedra().first_face;
  return int(first[c + 1] - first[c]);
}

bool is_fixed(const InSpace &p, const unsigned int c)
{
  return c >= p.ground();
}

int group_of(const InSpace &p, const unsigned int c)
{
  return int(p.group(c));
}

const std::vector<std::string> &names_of_groups(const InSpace &p)
{
  return p.group_names();
}

int cell_minus_of(const InSpace &p, const unsigned int e)
{
  return int(p.interfaces()[e].cell_minus);
}

int cell_plus_of(const InSpace &p, const unsigned int e)
{
  const InSpace::Interface &i = p.interfaces()[e];
  return i.cell_plus != p.ground()       ? int(i.cell_plus)
         : i.fixed_cell != invalid_index ? int(i.fixed_cell)
                                         : -1;
}

bool is_support(const InSpace &p, const unsigned int e)
{
  return p.interfaces()[e].cell_plus == p.ground();
}

double distance_of(const InSpace &p, const unsigned int e)
{
  return p.distance(p.interfaces()[e]);
}

/** What the polyhedra of a packing have. */
Fields<InSpace> polyhedra()
{
  return {Field<InSpace>("cell", "", "the number of the cell", number_of)
              .with_columns({"id"})
              .with_attribute(""),
          vector_in_columns({"centre", "L", "its centre", centre_of},
                            place_columns, "centres")
              .only_in_table(),
          Field<InSpace>("volume", "L^3", "its volume", volume_of)
              .with_attribute("volumes"),
          Field<InSpace>("faces", "", "the number of its faces", n_faces_of),
          Field<InSpace>("fixed", "",
                         "1 if it does not move, as a part of the ground",
                         is_fixed),
          Field<InSpace>("group", "", "the name of the cell's group", group_of)
              .numbering(names_of_groups)
              .with_attribute("groups")
              .saying_in_grid(
                  "its number in the list in `summary.json`, from 0; that of "
                  "the ground is the next")};
}

/** What the interfaces of a packing have. */
Fields<InSpace> face_interfaces()
{
  const std::string cells =
      "the cells c- and c+; -1 is the ground without a shape";
  return together<InSpace>(
      {{{"cell_minus", "", cells, cell_minus_of},
        {"cell_plus", "", cells, cell_plus_of},
        {"support", "", "1 if it is a support", is_support}},
       places_and_normals(&InSpace::interfaces, "", "x_e of the polygon",
                          "n_e, from c- to c+"),
       {{"distance", "L", "d_e, of the centres along n_e", distance_of}}});
}
} // namespace

const FieldTable<SpaceResults> &polyhedron_fields()
{
  static const FieldTable<SpaceResults> table(
      "cell group volume faces fixed", polyhedra(), polyhedron_loads(),
      polyhedron_motion(), polyhedron_stress(), opening_motion(),
      polyhedron_live_loads());
  return table;
}

const FieldTable<SpaceResults> &face_interface_fields()
{
  static const FieldTable<SpaceResults> table(
      "normal_force shear_force normal_stress utilisation cell_minus "
      "cell_plus area distance normal",
      face_interfaces(), face_forces(), face_ranges(), face_jumps(),
      face_self_stress(), face_strengths());
  return table;
}

const FieldTable<Packing<3>> &packing_polyhedron_fields()
{
  static const FieldTable<InSpace> table("", polyhedra());
  return table;
}

const FieldTable<Packing<3>> &packing_face_fields()
{
  static const FieldTable<InSpace> table("", face_interfaces());
  return table;
}

const FieldTable<SpaceResults> &boundary_face_fields()
{
  static const FieldTable<SpaceResults> table(
      "cell",
      Fields<InSpace>{
          Field<InSpace>("cell", "", "the cell that has the face",
                         [](const InSpace &p, const unsigned int b) {
                           return int(p.boundary_faces()[b].cell);
                         })
              .with_attribute("boundary_cells")},
      places_and_normals(&InSpace::boundary_faces, "boundary_",
                         "of what is free of the face",
                         "the unit normal out of the cell"),
      loads_on_faces());
  return table;
}
} // namespace Voussoir
