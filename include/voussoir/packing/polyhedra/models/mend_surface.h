// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_models_mend_surface_h
#define voussoir_packing_polyhedra_models_mend_surface_h

#include <voussoir/packing/polyhedra/models/model_defects.h>
#include <voussoir/packing/polyhedra/models/surface.h>

#include <vector>

namespace Voussoir
{
/** A surface, and what was wrong with it. */
struct MendedSurface
{
  /** As far as it could be mended. */
  Surface surface;
  /** Without the numbers of cells. */
  std::vector<ModelDefect> defects;

  /** True if no defect is a refusal. */
  bool is_usable() const;
};

/**
 * The faces of a block that can be told apart, or the defect that stops it:
 * without a face or with less than four, with a number that is not finite, or
 * of a size that cannot be reckoned with.
 */
MendedSurface surface_of(const BlockMesh &block);

/**
 * The distance of vertices that are one, for numbers with seven digits, as in
 * files of single precision; a length.
 */
double distance_of_seven_digits(const std::vector<dealii::Point<3>> &vertices);

/**
 * For each vertex the first one within a distance: itself, or one that is the
 * first for itself.
 */
std::vector<unsigned int>
first_vertices_nearby(const std::vector<dealii::Point<3>> &vertices,
                      double distance);

/**
 * Weld the vertices that are no further apart than @p distance, each to the
 * first one there; leave out repeated vertices of faces, faces with less than
 * three vertices, and faces with the same vertices as one before.
 */
void weld(MendedSurface &mended, double distance);

/**
 * Add vertices to the open edges that they lie within, up to @p distance from
 * them, so that two faces have the same edges. Only vertices of open edges are
 * added.
 */
void add_hanging_vertices(MendedSurface &mended, double distance);

/**
 * Tell edges of one face that miss others from those where a face is missing:
 * the others have no face on their other side either, and both of their ends
 * are near, beside the length of the edge. No change if there is none such.
 *
 * @param tolerance a length, for the message.
 */
void tell_gaps(MendedSurface &mended, double tolerance);

/**
 * Turn the faces so that neighbours run along their common edge in opposite
 * directions, and the volume is positive. The first face of a surface that
 * agrees with itself stays as it is if the volume lets it. A turned face keeps
 * its first vertex.
 *
 * Refused are edges of one face or of more than two, or twice of the same, a
 * surface without an inside, and one whose volume over its area is nothing
 * beside its size.
 */
void orient(MendedSurface &mended);

/**
 * Join neighbouring faces in one plane: vertices no further from the plane than
 * @p distance. No face gets a hole or touches itself: where faces lie around a
 * hole they stay cut. The plane is that of all faces joined so far, from the
 * largest on. A face of several has the number of the lowest, and its place in
 * the list.
 */
void join_coplanar_faces(MendedSurface &mended, double distance);

/**
 * Leave out the vertices that only two faces have, if they are no further than
 * @p distance from the straight line between those beside them.
 */
void drop_straight_vertices(MendedSurface &mended, double distance);
} // namespace Voussoir

#endif
