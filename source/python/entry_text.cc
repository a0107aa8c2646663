// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/formula/value_list.h>
#include <voussoir/python/entry_text.h>

#include <array>
#include <charconv>
#include <map>
#include <pybind11/numpy.h>

namespace Voussoir
{
namespace py = pybind11;

namespace
{
/** What the rows of an array belong to. */
enum class Rows
{
  joints,
  blocks
};

/** The entries that may be lists, by their names in whatever section. */
const std::map<std::string, Rows> &entries_with_lists()
{
  static const std::map<std::string, Rows> entries = {
      {"Strength", Rows::joints},
      {"Coefficient", Rows::joints},
      {"Cohesion", Rows::joints},
      {"Friction angle", Rows::joints},
      {"Tensile strength", Rows::joints},
      {"Compressive strength", Rows::joints},
      {"Body force", Rows::blocks},
      {"Cell forces", Rows::blocks}};
  return entries;
}

Rows rows_of(const std::string &name)
{
  const auto found = entries_with_lists().find(
      name.substr(name.rfind('/') + 1)); // npos + 1 is 0
  if (found != entries_with_lists().end())
    return found->second;
  std::string names;
  for (const auto &[entry, rows] : entries_with_lists())
    names += (names.empty() ? "'" : ", '") + entry + "'";
  throw py::value_error("'" + name +
                        "' takes no array; the entries that do are named " +
                        names + ".");
}

std::string shape_in_words(const py::array &array)
{
  return py::str(array.attr("shape")).cast<std::string>();
}

/** "list" and the numbers of column @p j of @p n_columns. */
std::string list_of(const double *const first,
                    const py::ssize_t n_rows,
                    const py::ssize_t n_columns,
                    const py::ssize_t j)
{
  std::string list = list_word;
  std::array<char, 32> digits;
  for (py::ssize_t i = 0; i < n_rows; ++i)
  {
    // The shortest digits that are the same double.
    const auto written = std::to_chars(
        digits.data(), digits.data() + digits.size(), first[i * n_columns + j]);
    list += i == 0 ? " " : ", ";
    list.append(digits.data(), written.ptr);
  }
  return list;
}

std::string text_of_array(const std::string &name,
                          const py::array &given,
                          const unsigned int dimension)
{
  const bool are_vectors = rows_of(name) == Rows::blocks;
  const std::string wanted =
      are_vectors ? text("of shape (n, ", dimension,
                         ") with a row for each of the n blocks that move")
                  : "of shape (n) with a number for each of the n joints";
  using Numbers = py::array_t<double, py::array::c_style>;
  const std::string kind = given.dtype().attr("kind").cast<std::string>();
  if (std::string("fiub").find(kind) == std::string::npos)
    throw py::value_error("'" + name + "' takes an array " + wanted +
                          ", and this one has no real numbers.");
  const Numbers array = py::reinterpret_borrow<py::object>(given);
  if (array.ndim() != (are_vectors ? 2 : 1) ||
      (are_vectors && array.shape(1) != py::ssize_t(dimension)))
    throw py::value_error("'" + name + "' takes an array " + wanted +
                          ", and this one has the shape " +
                          shape_in_words(given) + ".");
  const py::ssize_t n_columns = are_vectors ? dimension : 1;
  std::string lists;
  for (py::ssize_t j = 0; j < n_columns; ++j)
    lists += (j == 0 ? "" : "; ") +
             list_of(array.data(), array.shape(0), n_columns, j);
  return lists;
}
} // namespace

std::string entry_text(const std::string &name,
                       const py::handle &value,
                       const unsigned int dimension)
{
  if (py::isinstance<py::array>(value))
    if (const auto array = py::reinterpret_borrow<py::array>(value);
        array.ndim() > 0)
      return text_of_array(name, array, dimension);
  // Numbers of numpy's, whose repr() says so.
  const py::object number =
      py::hasattr(value, "dtype") && py::hasattr(value, "item")
          ? value.attr("item")()
          : py::reinterpret_borrow<py::object>(value);
  if (py::isinstance<py::bool_>(number))
    return number.cast<bool>() ? "true" : "false";
  // repr: the shortest digits that are the same double.
  return py::isinstance<py::float_>(number) ? py::repr(number)
                                            : py::str(number);
}
} // namespace Voussoir
