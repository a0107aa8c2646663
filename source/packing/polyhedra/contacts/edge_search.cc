// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/contacts/edge_pair.h>
#include <voussoir/packing/polyhedra/contacts/edge_search.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace Voussoir
{
namespace
{
/** The rounding of the middle of a joint, over its size. */
constexpr double rounding_of_middle = 1e-9;

/** The middle of the corners of a joint, without what is rounding of zero. */
dealii::Point<3> middle_of(const std::vector<dealii::Point<3>> &polygon)
{
  dealii::Tensor<1, 3> sum;
  for (const dealii::Point<3> &corner : polygon)
    sum += corner;
  dealii::Point<3> middle(sum / double(polygon.size()));
  const double rounding = rounding_of_middle * middle.distance(polygon[0]);
  for (unsigned int d = 0; d < 3; ++d)
    if (std::abs(middle[d]) < rounding)
      middle[d] = 0.;
  return middle;
}
} // namespace

void EdgeContacts::append(EdgeContacts &&other)
{
  joints.insert(joints.end(), std::make_move_iterator(other.joints.begin()),
                std::make_move_iterator(other.joints.end()));
  n_pairs_without_normal += other.n_pairs_without_normal;
}

EdgeContacts EdgeSearch::find(const unsigned int begin,
                              const unsigned int end,
                              const PatchList &patches) const
{
  const CellFaces &cells = geometry.cells;
  EdgeContacts found;
  for (unsigned int cell = begin, first = 0, behind; cell < end;
       ++cell, first = behind)
  {
    behind = first;
    while (behind < patches.faces.size() &&
           patches.faces[behind][0] < cells.first_face[cell + 1])
      ++behind;
    for (const unsigned int other :
         geometry.boxes.higher_neighbours(cell, geometry.tolerance))
    {
      std::vector<unsigned int> of_pair;
      for (unsigned int k = first; k < behind; ++k)
        if (patches.faces[k][1] >= cells.first_face[other] &&
            patches.faces[k][1] < cells.first_face[other + 1])
          of_pair.push_back(k);
      // Two convex cells touch in one convex polygon.
      if (!of_pair.empty() && convex.is_convex(cell) && convex.is_convex(other))
        continue;
      EdgePair pair(geometry, {{cell, other}});
      for (const unsigned int k : of_pair)
        pair.add_patch(patches.patches[k]);
      std::vector<EdgeContact> joints = pair.joints();
      if (joints.empty() && of_pair.empty() && pair.meets_without_normal())
        ++found.n_pairs_without_normal;
      found.append({std::move(joints), 0});
    }
  }
  std::stable_sort(found.joints.begin(), found.joints.end(),
                   [](const EdgeContact &a, const EdgeContact &b) {
                     return a.faces < b.faces;
                   });
  return found;
}

std::string notice_of(const CellFaces &cells, const EdgeContacts &contacts)
{
  if (contacts.joints.empty())
    return "";
  const EdgeContact &first = contacts.joints.front();
  const unsigned int n = contacts.joints.size();
  const unsigned int n_points =
      std::count_if(contacts.joints.begin(), contacts.joints.end(),
                    [](const EdgeContact &joint) { return joint.is_in_point; });
  std::string others;
  if (contacts.n_pairs_without_normal > 0)
    others = text(" ", counted(contacts.n_pairs_without_normal, "pair"),
                  " of blocks where corners or parallel edges meet edges or "
                  "corners have no normal there, and carry nothing.");
  return text("Blocks touch along an edge in ", counted(n - n_points, "place"),
              " and in a point in ", counted(n_points, "place"), ", first ",
              cells.describe(cells.cell_of_face(first.faces[0])), " and ",
              cells.describe(cells.cell_of_face(first.faces[1])), " at ",
              text_of_point(middle_of(first.polygon)),
              ". They get joints as good as without area there; 'Rotations = "
              "false' leaves them open.",
              others);
}
} // namespace Voussoir
