// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/generators/block_faces.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace Voussoir
{
using dealii::Point;

namespace
{
/** Whether a side of the polygon, from @p p to @p next, is level throughout. */
bool is_level_side(const std::vector<BlockFaces::Loop> &sections,
                   const unsigned int p,
                   const unsigned int next)
{
  const double height = sections[0][p][2];
  return std::all_of(
      sections.begin(), sections.end(), [=](const BlockFaces::Loop &section) {
        return section[p][2] == height && section[next][2] == height;
      });
}
} // namespace

BlockFaces BlockFaces::swept(const std::vector<Loop> &sections)
{
  BlockFaces block;
  const unsigned int n_points = sections.front().size();
  const unsigned int last = sections.size() - 1;
  block.add({sections.front().rbegin(), sections.front().rend()});
  block.add(sections.back());
  for (unsigned int p = 0; p < n_points; ++p)
  {
    const unsigned int next = (p + 1) % n_points;
    const unsigned int stride = is_level_side(sections, p, next) ? last : 1;
    for (unsigned int s = 0; s < last; s += stride)
    {
      Loop face;
      for (unsigned int k = 0; k <= stride; ++k)
        face.push_back(sections[s + stride - k][p]);
      for (unsigned int k = 0; k <= stride; ++k)
        face.push_back(sections[s + k][next]);
      block.add(face);
    }
  }
  return block;
}

void BlockFaces::add(const Loop &corners)
{
  std::vector<unsigned int> face;
  for (const Point<3> &corner : corners)
  {
    // A block has too few vertices for any search but this.
    const auto found = std::find(vertices.begin(), vertices.end(), corner);
    const unsigned int number = found - vertices.begin();
    if (found == vertices.end())
      vertices.push_back(corner);
    if (face.empty() || face.back() != number)
      face.push_back(number);
  }
  while (face.size() > 1 && face.back() == face.front())
    face.pop_back();
  if (face.size() >= 3)
    faces.push_back(std::move(face));
}

void BlockFaces::add_to(BlockBuilder &builder, const unsigned int group) const
{
  builder.add_polyhedron(vertices, faces, group);
}
} // namespace Voussoir
