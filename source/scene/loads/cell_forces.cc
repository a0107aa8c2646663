// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/geometry.h>
#include <voussoir/base/text.h>
#include <voussoir/formula/value_list.h>
#include <voussoir/packing/area_moments.h>
#include <voussoir/packing/cells_at.h>
#include <voussoir/packing/group_names.h>
#include <voussoir/scene/loads/cell_forces.h>
#include <voussoir/scene/loads/loaded_cells.h>
#include <voussoir/scene/loads/segment_tractions.h>

#include <optional>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/** Two numbers; the message of their fault begins with @p begin. */
Point<2> pair_or_refuse(const std::string &text,
                        const std::string &form,
                        const std::string &begin)
{
  const std::optional<Point<2>> pair = pair_of_text(text);
  if (!pair)
    throw InputError(begin + " '" + text + "'; two finite numbers \"" + form +
                     "\" are expected, with a comma between.");
  return *pair;
}

/** "at x, y: force". */
void add_force_at(const Packing<2> &packing,
                  const Point<2> &x,
                  const Tensor<1, 2> &force,
                  const std::string &parameter,
                  std::vector<CellForce> &forces)
{
  const CellsAt cells(packing, x);
  if (cells.there.empty())
    throw InputError(text("The parameter '", parameter,
                          "' lets a force act at ", text_of_point(x),
                          ", which is in no cell; ",
                          cells.describe_nearest(packing),
                          ". Correct the place, or name the cell."));
  for (const unsigned int c : cells.there)
    forces.push_back(
        {text("cell ", c), {c}, force / double(cells.there.size()), x});
}

/** "name: force at x, y". */
CellForce force_in_cell(const Packing<2> &packing,
                        const std::vector<unsigned int> &cells,
                        const std::string &name,
                        const Tensor<1, 2> &force,
                        const std::string &place,
                        const std::string &parameter)
{
  const std::string begin = "The parameter '" + parameter +
                            "' lets the force on '" + name + "' act at ";
  const Point<2> x =
      pair_or_refuse(place, "x, y", begin.substr(0, begin.size() - 1));
  if (cells.size() != 1)
    throw InputError(text(begin, text_of_point(x), ", but there are ",
                          cells.size(),
                          " cells of that name; name one cell, as in cell "
                          "12, or give the place alone."));
  const unsigned int c = cells.front();
  if (!is_in_cell(packing, c, x))
    throw InputError(text(begin, text_of_point(x), ", which is not a place in ",
                          packing.describe(c), " at ",
                          text_of_point(packing.centre(c)), "."));
  return {name, {c}, force, x};
}

/** Forces on cells of which the components are lists. */
std::vector<CellForce> forces_of_lists(const Packing<2> &packing,
                                       const std::string &lists,
                                       const std::string &parameter)
{
  const auto f =
      vectors_of_lists(lists, parameter, 2, packing.n_cells(), "cell");
  std::vector<CellForce> forces;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    if (const Tensor<1, 2> of_c({f[0][c], f[1][c]}); of_c.norm() > 0.)
      forces.push_back({text("cell ", c), {c}, of_c});
  return forces;
}
} // namespace

Point<2> CellForce::place_in(const Packing<2> &packing,
                             const unsigned int cell) const
{
  return place ? *place
               : packing.centre(cell) + area_moments(packing, cell).centroid();
}

double CellForce::torque(const Packing<2> &packing,
                         const unsigned int cell) const
{
  return cross(place_in(packing, cell) - packing.centre(cell), force);
}

std::vector<CellForce> cell_forces_of_text(const Packing<2> &packing,
                                           const std::string &list,
                                           const std::string &parameter)
{
  if (is_value_list(list))
    return forces_of_lists(packing, list, parameter);
  std::vector<CellForce> forces;
  for (const auto &[name, value] : split_named_list(list, parameter))
  {
    const std::size_t at = value.find(" at ");
    const Tensor<1, 2> force = pair_or_refuse(
        value.substr(0, at), "F_x, F_y",
        "The parameter '" + parameter + "' gives '" + name + "' the force");
    if (name.compare(0, 3, "at ") == 0)
    {
      const Point<2> x = pair_or_refuse(name.substr(3), "x, y",
                                        "The parameter '" + parameter +
                                            "' lets a force act at");
      add_force_at(packing, x, force, parameter, forces);
      continue;
    }
    std::vector<unsigned int> cells =
        cells_that_take("a force", packing, name, parameter);
    if (at == std::string::npos)
      forces.push_back({name, std::move(cells), force});
    else
      forces.push_back(force_in_cell(packing, cells, name, force,
                                     value.substr(at + 4), parameter));
  }
  return forces;
}
} // namespace Voussoir
