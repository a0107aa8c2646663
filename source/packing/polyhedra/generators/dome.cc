// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/packing/polyhedra/generators/block_faces.h>
#include <voussoir/packing/polyhedra/generators/block_resolution.h>
#include <voussoir/packing/polyhedra/generators/dome.h>

#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/sin_pi.hpp>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
using dealii::Point;

namespace
{
enum DomeGroup : unsigned int
{
  voussoir_of_dome,
  keystone_of_dome
};

/** The planes between the facets of a dome, from which it is made. */
class Meridians
{
public:
  explicit Meridians(const unsigned int n_facets)
  {
    for (unsigned int j = 0; j < n_facets; ++j)
    {
      const double turn = 2. * j / n_facets;
      directions.emplace_back(boost::math::cos_pi(turn),
                              boost::math::sin_pi(turn));
    }
  }

  /** The place of (r, z) in meridian @p j, counted modulo their number. */
  Point<3> place(const Point<2> &p, const unsigned int j) const
  {
    const Point<2> &direction = directions[j % directions.size()];
    return {p[0] * direction[0], p[0] * direction[1], p[1]};
  }

  /** The polygon of the places of (r, z) in all meridians. */
  BlockBuilder::Loop around(const Point<2> &p) const
  {
    BlockBuilder::Loop loop;
    for (unsigned int j = 0; j < directions.size(); ++j)
      loop.push_back(place(p, j));
    return loop;
  }

  /** The polygon between two joints of a course in meridian @p j. */
  BlockBuilder::Loop section(const ArchJoint &upper,
                             const ArchJoint &lower,
                             const unsigned int j) const
  {
    return {place(upper.intrados, j), place(upper.extrados, j),
            place(lower.extrados, j), place(lower.intrados, j)};
  }

private:
  /** (cos, sin) of the angle of each. */
  std::vector<Point<2>> directions;
};
} // namespace

void DomeGenerator::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  prm.add_parameter("Mean radius", mean_radius,
                    "Radius of the middle surface, on which the joints are "
                    "halved if they are radial; a length, positive.",
                    Double(0.));
  prm.add_parameter("Thickness", thickness,
                    "Distance from the intrados to the extrados along a "
                    "radius; a length, positive.",
                    Double(0.));
  prm.add_parameter("Embrace", embrace,
                    "Angle from springing to springing, seen from the centre; "
                    "degrees, positive. 180 is a hemisphere.",
                    Double(0., 180.));
  add_choice<bool>(
      prm, "Crown", has_keystone,
      {{true, "keystone", "one block closes the dome, as wide as a course."},
       {false, "oculus", "the dome is open.", "Oculus"}},
      "What is inside the uppermost course.");
  prm.add_parameter("Oculus", oculus,
                    "Angle from rim to rim of the opening, seen from the "
                    "centre; degrees, positive and less than 'Embrace'.",
                    Double(0., 180.));
  prm.add_parameter("Courses", n_courses,
                    "Number of courses, without the keystone.",
                    Integer(1, 1000000));
  prm.add_parameter("Sectors", n_sectors, "Number of blocks in a course.",
                    Integer(3, 1000000));
  add_choice<Bond>(
      prm, "Bond", bond,
      {{Bond::running, "running",
        "every second course is shifted by half a block; a block has two flat "
        "halves."},
       {Bond::stack, "stack",
        "all head joints are above each other; a block is flat."}},
      "How the blocks of a course overlap those of the next.");
  add_choice<bool>(
      prm, "Bed joints", level_beds,
      {{false, "radial", "on lines through the centre."},
       {true, "horizontal",
        "at equal distances, as in a corbelled dome; the keystone is a lid."}},
      "The joints between the courses.");
}

void DomeGenerator::check_parameters() const
{
  check_measures("Packing/dome", {{"Mean radius", mean_radius},
                                  {"Thickness", thickness},
                                  {"Embrace", embrace}});
  if (!(thickness < 2. * mean_radius))
    throw InputError(text("The dome 'Packing/dome' has the thickness ",
                          thickness, " and the mean radius ", mean_radius,
                          "; the thickness must be less than twice the "
                          "radius."));
  if (!has_keystone)
  {
    check_measures("Packing/dome", {{"Oculus", oculus}});
    if (!(oculus < embrace))
      throw InputError(text("'Packing/dome/Oculus' is ", oculus,
                            " degrees and 'Embrace' ", embrace,
                            "; the oculus must be smaller."));
  }
  check_number_of_cells(double(n_courses) * n_sectors,
                        "'Packing/dome/Courses' and 'Sectors'");
}

std::vector<ArchJoint> DomeGenerator::radial_joints() const
{
  const double inner = mean_radius - 0.5 * thickness;
  const double outer = mean_radius + 0.5 * thickness;
  // Angles from the axis over pi, for functions that are exact where the sine
  // or the cosine vanishes.
  const double foot = embrace / 360.;
  const double crown =
      has_keystone ? foot / (2. * n_courses + 1.) : oculus / 360.;
  std::vector<ArchJoint> joints;
  for (unsigned int k = 0; k <= n_courses; ++k)
  {
    const double turn = (crown * (n_courses - k) + foot * k) / n_courses;
    const Point<2> direction(boost::math::sin_pi(turn),
                             boost::math::cos_pi(turn));
    joints.push_back(
        {Point<2>(inner * direction), Point<2>(outer * direction)});
  }
  return joints;
}

std::vector<ArchJoint> DomeGenerator::joints() const
{
  std::vector<ArchJoint> joints = radial_joints();
  if (!level_beds)
    return joints;
  const Point<2> top = joints.front().intrados;
  const Point<2> foot = joints.back().intrados;
  for (unsigned int k = 0; k <= n_courses; ++k)
  {
    // By Pythagoras, from what cancels nothing: the radii of both spheres
    // differ by the thickness, their squares by 2 R t.
    const double z = (top[1] * (n_courses - k) + foot[1] * k) / n_courses;
    const double r = std::hypot(top[0], std::sqrt(std::max(top[1] - z, 0.)) *
                                            std::sqrt(top[1] + z));
    joints[k] = {
        {r, z},
        {std::hypot(r, std::sqrt(2. * mean_radius) * std::sqrt(thickness)), z}};
  }
  return joints;
}

CellFaces DomeGenerator::generate(const std::filesystem::path &,
                                  Terminal &) const
{
  check_parameters();
  const std::vector<ArchJoint> joints = this->joints();
  const unsigned int facets_in_block = bond == Bond::running ? 2 : 1;
  const unsigned int n_facets = facets_in_block * n_sectors;
  const ArchJoint &crown = joints.front();
  check_resolution(
      "Packing/dome",
      {{"'Thickness'", thickness},
       {"'Courses'", level_beds ? crown.intrados[1] - joints[1].intrados[1]
                                : crown.intrados.distance(joints[1].intrados)},
       {"'Sectors'", crown.intrados[0] * 2. * dealii::numbers::PI / n_facets}},
      mean_radius);

  const Meridians meridians(n_facets);
  BlockBuilder builder({"voussoir", "keystone"});
  builder.reserve_boxes(n_courses * n_sectors + 1);
  if (has_keystone)
  {
    const double outer_over_inner =
        (2. * mean_radius + thickness) / (2. * mean_radius - thickness);
    const ArchJoint keystone =
        level_beds ? ArchJoint{crown.extrados,
                               Point<2>(crown.intrados * outer_over_inner)}
                   : crown;
    builder.add_frustum(meridians.around(keystone.intrados),
                        meridians.around(keystone.extrados), keystone_of_dome);
  }
  for (unsigned int k = 0; k < n_courses; ++k)
    for (unsigned int b = 0; b < n_sectors; ++b)
    {
      const unsigned int first =
          facets_in_block * b + (bond == Bond::running ? k % 2 : 0);
      std::vector<BlockBuilder::Loop> sections;
      for (unsigned int j = first; j <= first + facets_in_block; ++j)
        sections.push_back(meridians.section(joints[k], joints[k + 1], j));
      BlockFaces::swept(sections).add_to(builder, voussoir_of_dome);
    }
  return builder.take();
}
} // namespace Voussoir
