// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/voronoi/cell_size.h>

#include <cmath>
#include <vector>

namespace Voussoir
{
template <int dim>
CellSize<dim>::CellSize(const std::string &formula,
                        const std::string &parameter)
    : formula(formula), parameter(parameter),
      expression(formula,
                 dim == 2 ? std::vector<std::string>{"x", "y"}
                          : std::vector<std::string>{"x", "y", "z"},
                 parameter)
{}

template <int dim>
double CellSize<dim>::operator()(const dealii::Point<dim> &p) const
{
  double size;
  if constexpr (dim == 2)
    size = expression({p[0], p[1]});
  else
    size = expression({p[0], p[1], p[2]});
  if (!std::isfinite(size) || size <= 0.)
    throw InputError("The parameter '" + parameter + "', '" + formula +
                     "', is " + text_of_number(size) + " at " +
                     text_of_point(p) +
                     "; it must be positive and finite all over the packing.");
  return size;
}

template <int dim>
void CellSize<dim>::refuse_as_too_small(const dealii::Point<dim> &p) const
{
  throw InputError("The parameter '" + parameter + "', '" + formula +
                   "', comes too near to zero, or changes too fast, near " +
                   text_of_point(p) +
                   "; keep it away from zero, as by max(..., 0.01).");
}

template class CellSize<2>;
template class CellSize<3>;
} // namespace Voussoir
