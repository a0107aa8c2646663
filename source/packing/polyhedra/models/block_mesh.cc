// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/models/block_mesh.h>

#include <algorithm>

namespace Voussoir
{
BlockMesh part_of_block(const BlockMesh &block,
                        const std::vector<unsigned int> &faces)
{
  std::vector<unsigned int> used;
  for (const unsigned int face : faces)
    used.insert(used.end(), block.faces[face].begin(), block.faces[face].end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());

  BlockMesh part;
  part.name = block.name;
  part.is_support = block.is_support;
  part.record = block.record;
  part.vertices.reserve(used.size());
  for (const unsigned int vertex : used)
    part.vertices.push_back(block.vertices[vertex]);
  std::vector<unsigned int> loop;
  for (const unsigned int face : faces)
  {
    loop.clear();
    for (const unsigned int vertex : block.faces[face])
      loop.push_back(std::lower_bound(used.begin(), used.end(), vertex) -
                     used.begin());
    part.faces.add(loop);
  }
  return part;
}
} // namespace Voussoir
