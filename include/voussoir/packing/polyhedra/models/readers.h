// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_models_readers_h
#define voussoir_packing_polyhedra_models_readers_h

#include <voussoir/packing/polyhedra/models/block_mesh.h>

#include <string>

namespace Voussoir
{
/**
 * Read blocks in the format that the ending of the file's name tells: .off,
 * .obj, .ply, .stl, .json or .tess, in small or capital letters.
 *
 * @throws InputError as the readers below do, and if there is no such format.
 */
BlockMeshes read_model(const std::filesystem::path &file);

/** The endings of the names of files that read_model() reads, in words. */
extern const std::string model_endings;

/**
 * Read an OFF file (Geomview's object file format) as text. All its faces are
 * one block; so are those of each further OFF object behind the first. Colours
 * and normals are ignored. A record is an object, counted from one.
 *
 * @throws InputError naming the line if the file cannot be read, is no OFF
 *   file, is cut short, or has no face.
 */
BlockMeshes read_off_model(const std::filesystem::path &file);

/**
 * Read a Wavefront OBJ file. A line "o NAME" begins a block; if there is none
 * in the file, "g NAME" does. Vertices are numbered through the file from one,
 * or backwards from the last one by -1, -2, ...; those of texture and normals
 * are ignored, and so is all that is no vertex, face or name. A record is the
 * line of a block's name, or of its first face if it has none. Lines with
 * faults are faults of their blocks.
 *
 * @throws InputError if the file cannot be read, or there is no face.
 */
BlockMeshes read_obj_model(const std::filesystem::path &file);

/**
 * Read a PLY file (Stanford's polygon file format), as text or binary in
 * either order of bytes. All its faces are one block; a record is the file.
 *
 * @throws InputError naming the line of text, or the element of binary data, if
 *   the file cannot be read, is cut short, or has no face.
 */
BlockMeshes read_ply_model(const std::filesystem::path &file);

/**
 * Read an STL file, as text or binary. Each solid is a block; a record is a
 * solid, counted from one. Vertices of triangles at one place are one.
 *
 * @throws InputError naming the line of text, or what binary data should have,
 *   if the file cannot be read, is cut short, or has no triangle.
 */
BlockMeshes read_stl_model(const std::filesystem::path &file);

/**
 * Read blocks that COMPAS or a package on top of it wrote as JSON: an Assembly
 * of compas_assembly or compas_cra, in the forms of COMPAS 0 to 2; a BlockModel
 * of compas_dem, with the transformations of its elements; a mesh, or a list of
 * meshes, in lists if need be; each of these also wrapped as {"dtype", "data"}.
 *
 * A vertex without a coordinate takes the default of its mesh. A record is a
 * node, if all have numbers for keys, or an element or a mesh, counted from
 * zero. A block's name is that of its mesh, if it is not what COMPAS calls all
 * of them. What is faulty in a mesh is a fault of its block, and what is in no
 * mesh one of the file.
 *
 * @throws InputError naming the place in the file if it cannot be read, is not
 *   JSON, or is none of the above.
 */
BlockMeshes read_compas_model(const std::filesystem::path &file);

/**
 * Read a tessellation in space by Neper, in its format .tess. Polyhedra are
 * blocks, and records.
 *
 * @throws InputError naming the line if the file cannot be read, is in the
 *   plane, is periodic, or lacks something.
 */
BlockMeshes read_tess_model(const std::filesystem::path &file);
} // namespace Voussoir

#endif
