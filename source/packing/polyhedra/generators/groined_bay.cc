// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/generators/bay_crown.h>
#include <voussoir/packing/polyhedra/generators/block_faces.h>
#include <voussoir/packing/polyhedra/generators/groined_bay.h>

#include <utility>

namespace Voussoir
{
using dealii::Point;

namespace
{
/**
 * The shortest leg of a block at a groin, along the extrados and over the
 * length of a block, so that the bond holds it.
 */
constexpr double shortest_leg = 0.25;

enum GroupOfBay : unsigned int
{
  voussoir_of_bay,
  groin_of_bay,
  keystone_of_bay
};

/** The polygon between a joint of the arch and the next. */
BayPlaces::Section section_of_course(const HalfArch &arch, const unsigned int k)
{
  BayPlaces::Section section;
  const ArchJoint &lower = arch.joints[k], &upper = arch.joints[k + 1];
  for (const Point<2> &p :
       {lower.intrados, lower.extrados, upper.extrados, upper.intrados})
    section.emplace_back(0. - p[0], p[1]);
  return section;
}

/**
 * The head joints of a course from its groins outwards, and the end of the web.
 *
 * @param widest the distance of the course from the crown, at most.
 */
std::vector<double> head_joints_of_course(const GroinedBay &bay,
                                          const unsigned int course,
                                          const double widest)
{
  const unsigned int n_halves = 2 * bay.n_blocks;
  const double half = bay.half_width / n_halves;
  const double first = widest + 2. * shortest_leg * half;
  unsigned int k = bay.bond == Bond::running ? course % 2 : 0;
  std::vector<double> joints;
  for (; k < n_halves; k += 2)
    if (const double out = bay.half_width * k / n_halves; out >= first)
      joints.push_back(out);
  joints.push_back(bay.half_width);
  return joints;
}

/** Add the blocks of a half course at the springings' side of the crown. */
void add_course_of_bay(BlockBuilder &builder,
                       const BayPlaces &places,
                       const BayPlaces::Section &section,
                       const std::vector<double> &heads,
                       const bool mitred)
{
  for (unsigned int web = 0; web < n_webs; ++web)
  {
    const unsigned int next = (web + 1) % n_webs;
    const auto leg = places.section(web, Flank::left, section, heads[0]);
    const auto mitre = places.mitre(web, section);
    const auto next_leg = places.section(next, Flank::right, section, heads[0]);
    if (mitred)
    {
      BlockFaces::swept({leg, mitre}).add_to(builder, groin_of_bay);
      BlockFaces::swept({mitre, next_leg}).add_to(builder, groin_of_bay);
    }
    else
      BlockFaces::swept({leg, mitre, next_leg}).add_to(builder, groin_of_bay);
    for (const auto &[at, flank] :
         {std::pair(web, Flank::left), {next, Flank::right}})
      for (unsigned int k = 0; k + 1 < heads.size(); ++k)
        builder.add_frustum(places.section(at, flank, section, heads[k]),
                            places.section(at, flank, section, heads[k + 1]),
                            voussoir_of_bay);
  }
}

/** Add the blocks between the last joints of the half arches. */
void add_crown_of_bay(BlockBuilder &builder,
                      const BayCrown &crown,
                      const std::vector<double> &heads,
                      const bool mitred)
{
  if (mitred)
    for (unsigned int web = 0; web < n_webs; ++web)
      crown.quarter(web, heads[0]).add_to(builder, keystone_of_bay);
  else
    crown.keystone(heads[0]).add_to(builder, keystone_of_bay);
  for (unsigned int web = 0; web < n_webs; ++web)
    for (unsigned int k = 0; k + 1 < heads.size(); ++k)
      builder.add_frustum(crown.section(web, heads[k]),
                          crown.section(web, heads[k + 1]), voussoir_of_bay);
}
} // namespace

CellFaces cells_of_bay(const HalfArch &arch, const GroinedBay &bay)
{
  BlockBuilder builder({"voussoir", "groin", "keystone"});
  const BayPlaces places(bay.depth_over_width);
  const unsigned int n_below_crown = arch.joints.size() - 1;
  for (unsigned int k = 0; k < n_below_crown; ++k)
  {
    const auto section = section_of_course(arch, k);
    add_course_of_bay(builder, places, section,
                      head_joints_of_course(bay, k, section[1][0]), bay.mitred);
  }
  if (const ArchJoint &last = arch.joints.back(); last.extrados[0] != 0.)
    add_crown_of_bay(
        builder, BayCrown(arch, places),
        head_joints_of_course(bay, n_below_crown, 0. - last.extrados[0]),
        bay.mitred);
  return builder.take();
}
} // namespace Voussoir
