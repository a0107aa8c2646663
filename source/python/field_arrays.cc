// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/python/field_arrays.h>

#include <cstdint>
#include <pybind11/stl.h>
#include <regex>

namespace Voussoir
{
namespace py = pybind11;

namespace
{
/** The shape of the arrays of a quantity of @p n elements. */
std::vector<py::ssize_t> shape_of(const FieldDescription &field,
                                  const std::size_t n)
{
  switch (field.shape)
  {
  case FieldShape::number: return {py::ssize_t(n)};
  case FieldShape::tensor: return {py::ssize_t(n), 2, 2};
  case FieldShape::space_vector: return {py::ssize_t(n), 3};
  case FieldShape::space_tensor: return {py::ssize_t(n), 3, 3};
  default: return {py::ssize_t(n), 2};
  }
}

/** Copies of the values of @p field, as Number. */
template <typename Number>
py::array_t<Number>
numbers(const BoundField &field, const std::size_t n, const FieldValues &values)
{
  const unsigned int n_components = field.about->n_components();
  std::vector<double> all(n * n_components);
  values(0, n, all.data());
  py::array_t<Number> array(shape_of(*field.about, n));
  std::copy(all.begin(), all.end(), array.mutable_data());
  return array;
}
} // namespace

std::string help_on(const FieldDescription &field)
{
  static const std::regex link("\\[([^\\]]*)\\]\\([^)]*\\)");
  const std::string condition =
      field.condition.empty() ? "" : field.condition + " only: ";
  const std::string shape = field.shape == FieldShape::number   ? ""
                            : field.shape == FieldShape::tensor ? "(n, 2, 2)"
                            : field.shape == FieldShape::space_vector ? "(n, 3)"
                            : field.shape == FieldShape::space_tensor
                                ? "(n, 3, 3)"
                                : "(n, 2)";
  return condition + std::regex_replace(field.words, link, "$1") +
         (shape.empty() ? "" : "; shape " + shape) +
         (field.unit.empty() ? "." : "; " + field.unit + ".");
}

py::array_t<double> view_of(const BoundField &field,
                            const std::shared_ptr<const void> &owner)
{
  using Owner = std::shared_ptr<const void>;
  const py::capsule keeper(new Owner(owner),
                           [](void *of) { delete static_cast<Owner *>(of); });
  const std::vector<py::ssize_t> shape = shape_of(*field.about, field.memory.n);
  std::vector<py::ssize_t> strides(shape.size(), sizeof(double));
  if (shape.size() == 3)
    strides[1] = shape[2] * sizeof(double);
  strides[0] = field.memory.stride;
  py::array_t<double> array(shape, strides, field.memory.first, keeper);
  py::detail::array_proxy(array.ptr())->flags &=
      ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

py::object copy_of(const BoundField &field, const std::size_t n)
{
  switch (field.about->type)
  {
  case FieldType::real: return numbers<double>(field, n, field.values);
  case FieldType::integer:
    return numbers<std::int64_t>(field, n, field.drawn());
  case FieldType::mark: return numbers<bool>(field, n, field.values);
  case FieldType::name: break;
  }
  std::vector<double> all(n);
  field.values(0, n, all.data());
  std::vector<std::string> texts;
  for (const double number : all)
    texts.push_back((*field.names)[number]);
  return py::cast(texts);
}
} // namespace Voussoir
