// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_fields_field_table_h
#define voussoir_output_fields_field_table_h

#include <voussoir/output/fields/field.h>

#include <algorithm>
#include <string>
#include <vector>

namespace Voussoir
{
/**
 * All quantities of one kind of element, such as interfaces, that some data
 * have. Tables have them in the order of the groups, and grids in an order of
 * their own.
 */
template <typename Data>
class FieldTable
{
public:
  /**
   * Put groups behind one another.
   *
   * @param first_in_grid the names of the first arrays of a grid, with a space
   *   between each two; the others follow in the order of the groups.
   * @param groups each of data that are a part of these, see part_of().
   */
  template <typename... Parts>
  explicit FieldTable(const std::string &first_in_grid,
                      const Fields<Parts> &...groups)
  {
    (add(groups), ...);
    const auto rank = [order = ' ' + first_in_grid + ' '](const auto *field) {
      return order.find(' ' + field->name + ' '); // the largest if not there
    };
    for (const Field<Data> &field : fields)
      if (field.in_grid != FieldDescription::Place::nowhere)
        grid.push_back(&field);
    std::stable_sort(grid.begin(), grid.end(),
                     [&](auto a, auto b) { return rank(a) < rank(b); });
  }
  FieldTable(const FieldTable &) = delete; // grid points to fields

  /** All quantities, in the order of a table. */
  const Fields<Data> &all() const { return fields; }
  /** The quantities that a grid has, in its order. */
  const std::vector<const Field<Data> *> &in_grid() const { return grid; }

  /** The columns of a table of @p data, to which they refer. */
  BoundFields columns(const Data &data) const
  {
    BoundFields bound;
    for (const Field<Data> &field : fields)
      if (!field.columns.empty() && field.holds(data))
        bound.push_back(field.bound(data));
    return bound;
  }

  /** The arrays of a grid of @p data, to which they refer, of its cells. */
  BoundFields arrays(const Data &data) const
  {
    BoundFields bound;
    for (const Field<Data> *const field : grid)
      if (field->in_grid == FieldDescription::Place::cells &&
          field->holds(data) && field->lacks(data).empty())
        bound.push_back(field->bound(data));
    return bound;
  }

  /** All values of the quantity @p name, a number, of @p n elements. */
  std::vector<double>
  values(const std::string &name, const Data &data, const std::size_t n) const
  {
    const auto field =
        std::find_if(fields.begin(), fields.end(),
                     [&](const auto &any) { return any.name == name; });
    Assert(field != fields.end(),
           dealii::ExcMessage(name + " is no quantity."));
    std::vector<double> values(n);
    field->bind(data).values(0, n, values.data());
    return values;
  }

private:
  template <typename Part>
  void add(const Fields<Part> &group)
  {
    for (const Field<Part> &field : group)
      fields.push_back(Field<Data>(field));
  }

  Fields<Data> fields;
  std::vector<const Field<Data> *> grid;
};
} // namespace Voussoir

#endif
