// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/formula/place_variables.h>
#include <voussoir/formula/value_list.h>
#include <voussoir/packing/group_names.h>
#include <voussoir/scene/loads/loaded_cells.h>
#include <voussoir/scene/space/integrated_forces.h>
#include <voussoir/scene/space/space_loads.h>

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/** The distance of a place from a cell, over its size, that counts as none. */
constexpr double largest_distance_from_block = 1e-6;

const std::vector<std::string> places = {"x", "y", "z"};

/** Three numbers with commas between; none if they are not that. */
std::optional<Tensor<1, 3>> three_numbers(const std::string &list)
{
  std::istringstream in(list);
  Tensor<1, 3> v;
  char comma = ',', more;
  for (unsigned int i = 0; i < 3; ++i)
    if (!(i == 0 || (in >> comma && comma == ',')) || !(in >> v[i]) ||
        !std::isfinite(v[i]))
      return {};
  if (in >> more)
    return {};
  return v;
}

Tensor<1, 3> three_or_refuse(const std::string &list,
                             const std::string &form,
                             const std::string &begin)
{
  const std::optional<Tensor<1, 3>> v = three_numbers(list);
  if (!v)
    throw InputError(begin + " '" + list + "'; three finite numbers \"" + form +
                     "\" are expected, with commas between.");
  return *v;
}

/** An expression with three components. */
VectorExpression vector_in_space(const std::string &formulas,
                                 const std::vector<std::string> &variables,
                                 const std::string &parameter)
{
  VectorExpression expression(formulas, variables, parameter);
  if (expression.size() != 3)
    throw InputError(
        text("The parameter '", parameter, "' = '", formulas, "' has ",
             counted(expression.size(), "component"),
             "; in space three are expected, with semicolons between, and a "
             "bar | before the next name if there is one."));
  return expression;
}

/** The vectors of lists of their components, one for each cell that moves. */
std::vector<Tensor<1, 3>> vectors_on_cells(const Packing<3> &packing,
                                           const std::string &lists,
                                           const std::string &parameter)
{
  const auto of =
      vectors_of_lists(lists, parameter, 3, packing.n_cells(), "cell");
  std::vector<Tensor<1, 3>> vectors(packing.n_cells());
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int c = 0; c < packing.n_cells(); ++c)
      vectors[c][i] = of[i][c];
  return vectors;
}

/** Add a force at the centroid of a cell. */
void add_at_centroid(const Packing<3> &packing,
                     const unsigned int c,
                     const Tensor<1, 3> &force,
                     SpaceLoads &loads)
{
  loads.add(c, force, packing.moments(c).centroid - packing.centre(c));
}

/** The largest distance at which @p x is outside of a face, over the size. */
double distance_outside(const Packing<3> &packing,
                        const unsigned int cell,
                        const Point<3> &x)
{
  const CellFaces &mesh = packing.polyhedra();
  double largest = -std::numeric_limits<double>::infinity();
  for (unsigned int f = mesh.first_face[cell]; f < mesh.first_face[cell + 1];
       ++f)
  {
    const PolygonMoments face = moments_of_face(mesh, f);
    largest = std::max(largest, (x - face.centroid) * face.normal());
  }
  return largest / std::cbrt(packing.volume(cell));
}
} // namespace

void SpaceLoadParameters::add_parameters(dealii::ParameterHandler &prm)
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
                    "The components \"g_x; g_y; g_z\" of the traction on the "
                    "boundary; stresses, tension positive. Expressions in x, "
                    "y, z and the outward unit normal nx, ny, nz.",
                    List(Anything(), 3, 3, ";"));
  prm.add_parameter("Stress", stress,
                    "The symmetric tensor \"S_xx, S_xy, S_xz; S_yx, S_yy, "
                    "S_yz; S_zx, S_zy, S_zz\" of the uniform stress; stresses, "
                    "tension positive.",
                    List(List(Double(), 3, 3, ","), 3, 3, ";"));
  prm.add_parameter("Where", loaded_where,
                    "The boundary faces that the load acts on: those at whose "
                    "centroid x, y, z, with the outward unit normal nx, ny, "
                    "nz, this expression is not zero. 1: all that are not "
                    "supported.",
                    Anything());
  prm.add_parameter("Body force", body,
                    "The components \"b_x; b_y; b_z\" of a force per volume, "
                    "such as weight: 0; 0; -20 in kN/m^3. Expressions in x, y "
                    "and z; or lists with a number for each cell that moves, "
                    "in their order, as in list 0, 0; list 0, 0; list -20, "
                    "-18.",
                    List(Anything(), 3, 3, ";"));
  prm.add_parameter("Group body forces", body_of_groups,
                    "The same for groups of cells, or cells by number, in "
                    "place of 'Body force': \"name: b_x; b_y; b_z | name: b_x; "
                    "b_y; b_z\", as in stone: 0; 0; -24 | fill: 0; 0; -18.",
                    Anything());
  prm.add_parameter("Cell forces", cell_forces,
                    "Point loads: \"at x, y, z: F_x, F_y, F_z | ...\" for "
                    "forces on the cells at these places; or by name, as in "
                    "keystone: 0, 0, -10, on each cell of the group of that "
                    "name, or on the cell with a number, as in cell 12: 0, 0, "
                    "-5, at its centroid or at a place, as in cell 12: 0, 0, "
                    "-5 at 0.3, 0.2, 1; or lists as for 'Body force'.",
                    Anything());
  prm.leave_subsection();
}

SpaceLoads SpaceLoadParameters::loads(const Packing<3> &packing,
                                      std::vector<std::string> &warnings) const
{
  SpaceLoads loads(packing.n_cells());
  add_tractions(packing, loads, warnings);
  add_body_forces(packing, loads, warnings);
  add_cell_forces(packing, loads);
  return loads;
}

void SpaceLoadParameters::add_tractions(
    const Packing<3> &packing,
    SpaceLoads &loads,
    std::vector<std::string> &warnings) const
{
  const std::string parameter = name + "/Traction";
  const VectorExpression g =
      vector_in_space(traction, variables_on_sides<3>(), parameter);
  Tensor<2, 3> S;
  dealii::Patterns::Tools::to_value(stress, S);
  const bool is_uniform = kind == Kind::uniform_stress;
  if (is_uniform &&
      ((S - transpose(S)).norm() > 0. || !std::isfinite(S.norm())))
    throw InputError("'" + name + "/Stress' = '" + stress +
                     "' must be finite and symmetric: S_xy = S_yx, S_xz = "
                     "S_zx and S_yz = S_zy.");
  if (is_uniform ? S.norm() == 0. : g.is_zero())
    return;
  const Condition where(loaded_where, variables_on_sides<3>(), name + "/Where");
  Inaccuracies inaccuracies(parameter, largest_error_in_space);
  bool is_any = false;
  const auto &faces = packing.boundary_faces();
  for (unsigned int b = 0; b < faces.size(); ++b)
  {
    const Packing<3>::BoundaryFace &face = faces[b];
    const Point<3> &x = face.centroid;
    const Tensor<1, 3> &n = face.normal;
    if (!where({x[0], x[1], x[2], n[0], n[1], n[2]}))
      continue;
    is_any = true;
    const Point<3> &centre = packing.centre(face.cell);
    if (is_uniform)
    {
      loads.add(face.cell, face.area * (S * n), x - centre);
      loads.add_on_face(b, faces.size(), face.area * (S * n), {});
      continue;
    }
    const ForceDensity density(g, centre, {n[0], n[1], n[2]},
                               text(", on a boundary face of cell ", face.cell,
                                    "; a traction must be finite."));
    SimplexIntegral sum;
    for (unsigned int p = face.first_part; p < face.first_part + face.n_parts;
         ++p)
    {
      const auto polygon = packing.parts()[p];
      for (unsigned int k = 1; k + 1 < polygon.size(); ++k)
        sum.add(integral_over_simplex({polygon[0], polygon[k], polygon[k + 1]},
                                      density));
    }
    inaccuracies.look_at(sum.error, sum.size, 0., [&] {
      return text("on the face at ", text_of_point(x), " of cell ", face.cell);
    });
    add_integral(sum, face.cell, loads);
    const IntegratedForce of(sum);
    loads.add_on_face(b, faces.size(), of.force,
                      of.torque - cross_product_3d(x - centre, of.force));
  }
  if (!is_any)
    throw InputError("The condition '" + loaded_where + "' of '" + name +
                     "/Where' holds on no face of the boundary that is not "
                     "supported, so that the load acts nowhere. It is asked at "
                     "the centroid x, y, z of what is free of each face; where "
                     "rounding matters write z > 2.999 rather than z == 3.");
  add_warnings(warnings, inaccuracies);
}

void SpaceLoadParameters::add_body_forces(
    const Packing<3> &packing,
    SpaceLoads &loads,
    std::vector<std::string> &warnings) const
{
  std::vector<bool> has_own(packing.n_cells(), false);
  const std::string of_groups = name + "/Group body forces";
  for (const auto &[group, value] :
       split_named_list(body_of_groups, of_groups, true))
  {
    const std::vector<unsigned int> cells =
        new_cells(packing, group, of_groups, has_own);
    add_body_force(packing, cells, vector_in_space(value, places, of_groups),
                   of_groups, loads, warnings);
  }
  std::vector<unsigned int> others;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    if (!has_own[c])
      others.push_back(c);
  const std::string everywhere = name + "/Body force";
  if (is_value_list(body))
  {
    const auto b = vectors_on_cells(packing, body, everywhere);
    for (const unsigned int c : others)
      if (b[c].norm() > 0.)
        add_at_centroid(packing, c, packing.volume(c) * b[c], loads);
  }
  else
    add_body_force(packing, others, vector_in_space(body, places, everywhere),
                   everywhere, loads, warnings);
}

void SpaceLoadParameters::add_cell_forces(const Packing<3> &packing,
                                          SpaceLoads &loads) const
{
  const std::string parameter = name + "/Cell forces";
  if (is_value_list(cell_forces))
  {
    const auto forces = vectors_on_cells(packing, cell_forces, parameter);
    for (unsigned int c = 0; c < packing.n_cells(); ++c)
      if (forces[c].norm() > 0.)
        add_at_centroid(packing, c, forces[c], loads);
    return;
  }
  for (const auto &[who, value] : split_named_list(cell_forces, parameter))
  {
    const std::size_t at = value.find(" at ");
    const Tensor<1, 3> force = three_or_refuse(
        value.substr(0, at), "F_x, F_y, F_z",
        "The parameter '" + parameter + "' gives '" + who + "' the force");
    const std::string begin = "The parameter '" + parameter + "' lets a force";
    if (who.compare(0, 3, "at ") == 0)
    {
      const Point<3> x(
          three_or_refuse(who.substr(3), "x, y, z", begin + " act at"));
      std::vector<unsigned int> there;
      double least = std::numeric_limits<double>::infinity();
      unsigned int nearest = 0;
      for (unsigned int c = 0; c < packing.n_cells(); ++c)
      {
        const double distance = distance_outside(packing, c, x);
        if (distance <= largest_distance_from_block)
          there.push_back(c);
        if (distance < least)
        {
          least = distance;
          nearest = c;
        }
      }
      if (there.empty())
        throw InputError(text(begin, " act at ", text_of_point(x),
                              ", which is in no cell; the nearest is ",
                              packing.describe(nearest), " at ",
                              text_of_point(packing.centre(nearest)),
                              ". Correct the place, or name the cell."));
      for (const unsigned int c : there)
        loads.add(c, force / double(there.size()), x - packing.centre(c));
      continue;
    }
    const std::vector<unsigned int> cells =
        cells_that_take("a force", packing, who, parameter);
    if (at == std::string::npos)
    {
      for (const unsigned int c : cells)
        add_at_centroid(packing, c, force, loads);
      continue;
    }
    const Point<3> x(three_or_refuse(value.substr(at + 4), "x, y, z",
                                     begin + " on '" + who + "' act at"));
    if (cells.size() != 1)
      throw InputError(text(begin, " on '", who, "' act at ", text_of_point(x),
                            ", but there are ", cells.size(),
                            " cells of that name; name one cell, as in cell "
                            "12, or give the place alone."));
    if (distance_outside(packing, cells[0], x) > largest_distance_from_block)
      throw InputError(text(begin, " on '", who, "' act at ", text_of_point(x),
                            ", which is not a place in ",
                            packing.describe(cells[0]), " at ",
                            text_of_point(packing.centre(cells[0])), "."));
    loads.add(cells[0], force, x - packing.centre(cells[0]));
  }
}
} // namespace Voussoir
