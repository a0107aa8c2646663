// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/generators/arch.h>
#include <voussoir/packing/generators/arch_joints.h>
#include <voussoir/packing/generators/measures.h>

namespace Voussoir
{
using dealii::Point;

namespace
{
/**
 * The narrowest ledge of a skewback, over the thickness of the arch: a shorter
 * side carries nothing, and slender triangles spoil the stress in the block.
 */
constexpr double narrowest_ledge = 0.01;

enum Group : unsigned int
{
  voussoir,
  keystone,
  abutment
};

/** The cells left of the crown, from the ground up. */
class LeftHalf
{
public:
  /** Begin with a pier of @p n_courses, of none with the springing alone. */
  LeftHalf(const ArchJoint &springing,
           const double thickness,
           const unsigned int n_courses,
           const double height)
  {
    const Point<2> &inner = springing.intrados, &outer = springing.extrados;
    const double ledge = outer[0] - (inner[0] - thickness);
    const bool has_ledge = ledge > narrowest_ledge * thickness;
    const double back = has_ledge ? inner[0] - thickness : outer[0];
    if (n_courses == 0)
    {
      last = add_vertices(springing);
      return;
    }
    const double ground = inner[1] - height;
    last = add_vertices({{inner[0], ground}, {back, ground}});
    for (unsigned int k = 1; k < n_courses; ++k)
    {
      const double y = inner[1] - height * (n_courses - k) / n_courses;
      add({{inner[0], y}, {back, y}}, abutment);
    }
    add(springing, abutment);
    if (has_ledge) // one more vertex of the last cell
    {
      half.loops.push_back(half.vertices.size());
      ++half.first.back();
      half.vertices.emplace_back(back, outer[1]);
    }
  }

  /** Add the cell up to the next joint. */
  void add(const ArchJoint &joint, const Group group)
  {
    const unsigned int next = add_vertices(joint);
    half.add({last + 1, last, next, next + 1});
    half.group.push_back(group);
    last = next;
  }

  /** The arch of the half, the keystone if there is one, and the image. */
  CellLoops mirrored(const bool has_keystone,
                     const std::optional<Point<2>> &apex) const
  {
    CellLoops arch = half;
    arch.group_names = {"voussoir", "keystone", "abutment"};
    std::vector<unsigned int> image;
    for (unsigned int v = 0; v < half.vertices.size(); ++v)
      if (half.vertices[v][0] == 0.)
        image.push_back(v);
      else
      {
        image.push_back(arch.vertices.size());
        arch.vertices.emplace_back(-half.vertices[v][0], half.vertices[v][1]);
      }
    if (has_keystone)
    {
      std::vector<unsigned int> loop = {last, image[last], image[last + 1]};
      if (apex)
      {
        loop.push_back(arch.vertices.size());
        arch.vertices.push_back(*apex);
      }
      loop.push_back(last + 1);
      arch.add(loop);
      arch.group.push_back(keystone);
    }
    for (unsigned int c = half.n_cells(); c-- > 0;)
    {
      std::vector<unsigned int> loop;
      for (unsigned int i = half.n_sides(c); i-- > 0;)
        loop.push_back(image[half.corner(c, i)]);
      arch.add(loop);
      arch.group.push_back(half.group[c]);
    }
    return arch;
  }

private:
  /** Add the ends of a joint; return the number of the inner one. */
  unsigned int add_vertices(const ArchJoint &joint)
  {
    half.vertices.push_back(joint.intrados);
    half.vertices.push_back(joint.extrados);
    return half.vertices.size() - 2;
  }

  CellLoops half;
  /** The inner end of the last joint; the outer one is the next vertex. */
  unsigned int last;
};
} // namespace

ArchGenerator::ArchGenerator(const std::string &section)
    : section(section), profile(section)
{}

void ArchGenerator::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  profile.add_parameters(prm);
  prm.add_parameter("Abutments", n_abutment_courses,
                    "Number of courses of the pier under each springing; 0 for "
                    "no piers. Under an inclined springing the top course is a "
                    "skewback.",
                    Integer(0, 1000000));
  prm.add_parameter("Abutment height", abutment_height,
                    "Height of the piers up to the intrados at the springing; "
                    "a length, positive.",
                    Double(0.));
}

CellLoops ArchGenerator::generate(const std::filesystem::path &,
                                  Terminal &) const
{
  if (n_abutment_courses > 0)
    check_measures(section, {{"Abutment height", abutment_height}});
  const HalfArch half = profile.joints();

  LeftHalf left(half.joints.front(), profile.thickness(), n_abutment_courses,
                abutment_height);
  for (unsigned int k = 1; k < half.joints.size(); ++k)
    left.add(half.joints[k], voussoir);
  return left.mirrored(profile.n_voussoirs() % 2 == 1, half.apex);
}
} // namespace Voussoir
