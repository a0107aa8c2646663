// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_python_arrays_h
#define voussoir_python_arrays_h

#include <voussoir/packing/packing.h>
#include <voussoir/packing/polygons/polygon_list.h>
#include <voussoir/packing/polyhedra/models/block_mesh.h>
#include <voussoir/packing/polyhedra/packing.h>

#include <pybind11/numpy.h>
#include <vector>

namespace Voussoir
{
/**
 * The polygons given as arrays of their corners, of shape (n, 2).
 *
 * @throws pybind11::value_error on another shape.
 */
PolygonList list_of(const std::vector<pybind11::array_t<double>> &polygons);

/**
 * The polyhedra given as pairs: an array of vertices, of shape (n, 3), and the
 * faces as sequences of the numbers of vertices.
 *
 * @throws pybind11::value_error on anything else, with the number of the first.
 */
BlockMeshes meshes_of(const pybind11::sequence &polyhedra);

/** The corners of each cell of a packing. */
std::vector<pybind11::array_t<double>> polygons_of(const Packing<2> &packing);

/** The polyhedra of a packing, as meshes_of() takes them. */
pybind11::list polyhedra_of(const Packing<3> &packing);

/** The vertices of each interface of a packing. */
std::vector<pybind11::array_t<double>>
interface_polygons_of(const Packing<3> &packing);
} // namespace Voussoir

#endif
