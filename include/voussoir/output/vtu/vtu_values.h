// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_vtu_vtu_values_h
#define voussoir_output_vtu_vtu_values_h

#include <voussoir/output/vtu/vtu_file.h>

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <tuple>

namespace Voussoir
{
/** Values as VTK has them, in three dimensions and row by row. */
namespace VtuValues
{
/** A number alone. */
template <typename Number>
std::array<Number, 1> scalar(const Number value)
{
  return {{value}};
}

/** A vector in the plane, or the coordinates of a point. */
inline std::array<double, 3> vector(const dealii::Tensor<1, 2> &v)
{
  return {{v[0], v[1], 0.}};
}

/** A tensor in the plane: xx, xy, xz, yx and so on. */
inline std::array<double, 9> tensor(const dealii::Tensor<2, 2> &t)
{
  return {{t[0][0], t[0][1], 0., t[1][0], t[1][1], 0., 0., 0., 0.}};
}

/**
 * The cell to which item @p i belongs, such as a point, where the items of cell
 * c are numbered from @p first(c) to first(c + 1) - 1.
 */
template <typename First>
unsigned int
cell_of(const std::size_t i, const unsigned int n_cells, const First &first)
{
  unsigned int begin = 0, end = n_cells;
  while (begin + 1 < end)
  {
    const unsigned int middle = begin + (end - begin) / 2;
    (first(middle) <= i ? begin : end) = middle;
  }
  return begin;
}

/** Items of a VtuFile, some to each cell; see cell_of(). */
template <typename First>
struct ItemsByCell
{
  unsigned int n_cells; /**< of the packing */
  First first;          /**< the first item of a cell */

  /**
   * Put the arrays @p value(cell, k), for k counting the items of the cell, of
   * the items from @p begin to @p end - 1 where @p place says.
   */
  template <typename Number, typename Value>
  void fill(const std::size_t begin,
            const std::size_t end,
            Number *place,
            const Value &value) const
  {
    unsigned int c = cell_of(begin, n_cells, first);
    for (std::size_t i = begin; i < end; ++i)
    {
      c += (i == first(c + 1));
      const auto components = value(c, i - first(c));
      place = std::copy(components.begin(), components.end(), place);
    }
  }
};

/** So that the type of the function need not be named. */
template <typename First>
ItemsByCell(unsigned int, First) -> ItemsByCell<First>;

/** Add to @p file the field of the arrays @p value(cell of the grid). */
template <typename Value>
void add_cell_field(VtuFile &file, const std::string &name, const Value &value)
{
  using Components = decltype(value(0));
  using Number = typename Components::value_type;
  file.add_cell_field<Number>(
      name, std::tuple_size<Components>::value,
      [value](std::size_t i, const std::size_t end, Number *place) {
        for (; i < end; ++i)
        {
          const Components components = value(i);
          place = std::copy(components.begin(), components.end(), place);
        }
      });
}
} // namespace VtuValues
} // namespace Voussoir

#endif
