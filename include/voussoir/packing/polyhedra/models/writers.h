// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_models_writers_h
#define voussoir_packing_polyhedra_models_writers_h

#include <voussoir/packing/polyhedra/cell_faces.h>
#include <voussoir/packing/polyhedra/face_contacts.h>

#include <deal.II/base/tensor.h>

#include <iosfwd>
#include <vector>

namespace Voussoir
{
/** Of some contacts the forces at each corner of their patches. */
using ForcesAtCorners = std::vector<std::vector<dealii::Tensor<1, 3>>>;

/**
 * Write cells as an OFF file, which read_off_model() reads back: the vertices
 * of each cell, as many as it has, and its faces. Names and what is fixed are
 * not in such a file. Coordinates have all their digits.
 */
void write_off_model(std::ostream &out, const CellFaces &cells);

/**
 * Write cells as a Wavefront OBJ file, which read_obj_model() reads back: "o"
 * and the name of its group before each cell. What is fixed is not in it.
 */
void write_obj_model(std::ostream &out, const CellFaces &cells);

/**
 * Write cells as an Assembly of compas_assembly in JSON, which
 * read_compas_model() reads back. The key of a node is the number of its cell,
 * its block has the name of the cell's group, and is_support tells what is
 * fixed.
 *
 * @param contacts gives interfaces {points, size, frame} between two cells, if
 *   it is not null: points are counterclockwise about the normal of the frame,
 *   which points from the lower cell to the higher; lengths, and areas.
 * @param forces gives interfaces {c_np, c_nn, c_u, c_v} at each of their
 * points, if there are any: compression, tension, and the friction along the
 * axes of the frame, of the force on the higher cell. One list for each
 * contact.
 */
void write_compas_assembly(std::ostream &out,
                           const CellFaces &cells,
                           const FaceContacts *contacts = nullptr,
                           const ForcesAtCorners &forces = {});
} // namespace Voussoir

#endif
