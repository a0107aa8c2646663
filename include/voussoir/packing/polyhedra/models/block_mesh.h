// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_models_block_mesh_h
#define voussoir_packing_polyhedra_models_block_mesh_h

#include <voussoir/packing/polyhedra/models/model_defects.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/point.h>

#include <filesystem>
#include <string>
#include <vector>

namespace Voussoir
{
/** Polygons by the numbers of their vertices, one behind the other. */
struct FaceLoops
{
  /** Vertex numbers of one face after the other. */
  std::vector<unsigned int> corners;
  /** The start of each face among them, and the end: size() + 1 numbers. */
  std::vector<unsigned int> first = {0};

  /** The number of faces. */
  unsigned int size() const { return first.size() - 1; }
  /** The vertex numbers of a face, in order around it. */
  dealii::ArrayView<const unsigned int>
  operator[](const unsigned int face) const
  {
    return {corners.data() + first[face], first[face + 1] - first[face]};
  }
  /** Add a face by its vertex numbers, in order around it. */
  template <typename Range>
  void add(const Range &loop)
  {
    corners.insert(corners.end(), loop.begin(), loop.end());
    first.push_back(corners.size());
  }
};

/** A block as it stands in a file, with whatever is wrong with it. */
struct BlockMesh
{
  /** The places of its vertices, which need not be numbers; lengths. */
  std::vector<dealii::Point<3>> vertices;
  /** Its faces, of any orientation, with any number of vertices. */
  FaceLoops faces;
  /** Its name in the file; empty if it has none. */
  std::string name;
  /** True if the file says that it does not move. */
  bool is_support = false;
  /** The record of the file that it comes from. */
  unsigned int record = 0;
  /** What of it could not be read: its shape is then of no meaning. */
  std::vector<ModelDefect> faults;
};

/** What a file says of blocks, before anything is mended. */
struct BlockMeshes
{
  /** The file that they were read from. */
  std::filesystem::path file;
  /** The name of a record of the file, such as a line or a node. */
  std::string record_name = "line";
  /** In the order of the file. */
  std::vector<BlockMesh> blocks;
  /** True if all digits of the coordinates are right, as in a tessellation. */
  bool is_computed = false;
  /** What is wrong with the file, and of no block. */
  std::vector<ModelDefect> faults;
};

/**
 * The part of a block that some of its faces make, with the vertices that they
 * have, in the order of their numbers; else the same block.
 *
 * @param faces their numbers, in the order that they are to have.
 */
BlockMesh part_of_block(const BlockMesh &block,
                        const std::vector<unsigned int> &faces);
} // namespace Voussoir

#endif
