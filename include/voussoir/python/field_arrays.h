// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_python_field_arrays_h
#define voussoir_python_field_arrays_h

#include <voussoir/output/fields/field_table.h>

#include <memory>
#include <pybind11/numpy.h>
#include <string>
#include <vector>

namespace Voussoir
{
/** What help() says of a quantity: when it is there, what it is, its unit. */
std::string help_on(const FieldDescription &field);

/** The values of @p field, real numbers in memory that @p owner keeps. */
pybind11::array_t<double> view_of(const BoundField &field,
                                  const std::shared_ptr<const void> &owner);

/**
 * The values of @p field of @p n elements: a list of texts, or an array, of
 * integers, marks or real numbers, of shape (n), (n, 2), (n, 3) or (n, 2, 2).
 */
pybind11::object copy_of(const BoundField &field, std::size_t n);

/**
 * Give a class an attribute for each quantity of a table that it has not yet.
 *
 * @param get the data of the table as a std::shared_ptr that keeps them, given
 *   an object and the name of what they are needed for; it throws where there
 *   are none.
 * @param n the number of elements, given the data.
 */
template <typename Class, typename Data, typename Get, typename Number>
void add_fields(Class &of,
                const FieldTable<Data> &table,
                const Get &get,
                const Number &n)
{
  for (const Field<Data> &field : table.all())
  {
    const std::string &name = field.attribute;
    if (name.empty() || pybind11::hasattr(of, name.c_str()))
      continue;
    of.def_property_readonly(
        name.c_str(),
        [&field, &name, get,
         n](typename Class::type &self) -> pybind11::object {
          const std::shared_ptr<const Data> data = get(self, name);
          const std::string lack = field.lacks(*data);
          if (!lack.empty())
            throw pybind11::attribute_error("there is no '" + name +
                                            "': " + lack);
          const BoundField bound = field.bound(*data);
          if (bound.memory.stride > 0)
            return view_of(bound, data);
          return copy_of(bound, n(*data));
        },
        help_on(field).c_str());
  }
}
} // namespace Voussoir

#endif
