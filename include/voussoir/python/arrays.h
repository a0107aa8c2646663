// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_python_arrays_h
#define voussoir_python_arrays_h

#include <voussoir/packing/polygons/polygon_list.h>

#include <deal.II/base/tensor.h>

#include <memory>
#include <pybind11/numpy.h>
#include <utility>
#include <vector>

namespace Voussoir
{
/** An object that keeps @p owner, whose memory an array shows. */
template <typename Owner>
pybind11::capsule keeper(std::shared_ptr<Owner> owner)
{
  return pybind11::capsule(
      new std::shared_ptr<Owner>(std::move(owner)),
      [](void *of) { delete static_cast<std::shared_ptr<Owner> *>(of); });
}

/**
 * A view, not to be written to, of one member of each of @p n objects that lie
 * one behind the other, of which @p first is that of the first.
 *
 * @param shape of the member: {} a number, {2} a vector, {2, 2} a tensor.
 * @param owner keeps the memory.
 */
template <typename Number, typename Object, typename Owner>
pybind11::array_t<Number> view(const Number *first,
                               const std::size_t n,
                               const std::vector<pybind11::ssize_t> &shape,
                               const Owner &owner)
{
  std::vector<pybind11::ssize_t> all = {pybind11::ssize_t(n)};
  all.insert(all.end(), shape.begin(), shape.end());
  std::vector<pybind11::ssize_t> strides(all.size(), sizeof(Number));
  for (std::size_t d = all.size(); d-- > 2;)
    strides[d - 1] = strides[d] * all[d];
  strides[0] = sizeof(Object);
  pybind11::array_t<Number> array(all, strides, first, keeper(owner));
  pybind11::detail::array_proxy(array.ptr())->flags &=
      ~pybind11::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/** A view of all of a vector of numbers, vectors or tensors. */
template <typename Object, typename Owner>
pybind11::array_t<double> view_of(const std::vector<Object> &of,
                                  const std::vector<pybind11::ssize_t> &shape,
                                  const Owner &owner)
{
  return view<double, Object>(reinterpret_cast<const double *>(of.data()),
                              of.size(), shape, owner);
}

/** The polygons given as arrays of their corners, of shape (n, 2). */
inline PolygonList
list_of(const std::vector<pybind11::array_t<double>> &polygons)
{
  PolygonList list;
  list.file = "the arrays";
  list.record_name = "polygon";
  for (const auto &corners : polygons)
  {
    if (corners.ndim() != 2 || corners.shape(1) != 2)
      throw pybind11::value_error("Each polygon is an array of shape (n, 2), "
                                  "with the x and y of its corners.");
    list.polygons.emplace_back();
    PolygonList::Polygon &polygon = list.polygons.back();
    polygon.record = list.polygons.size();
    for (pybind11::ssize_t i = 0; i < corners.shape(0); ++i)
      polygon.ring.emplace_back(corners.at(i, 0), corners.at(i, 1));
  }
  return list;
}
} // namespace Voussoir

#endif
