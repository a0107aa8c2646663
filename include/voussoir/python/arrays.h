// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_python_arrays_h
#define voussoir_python_arrays_h

#include <voussoir/packing/polygons/polygon_list.h>

#include <pybind11/numpy.h>
#include <vector>

namespace Voussoir
{
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
