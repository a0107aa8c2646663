// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/generators/arch.h>
#include <voussoir/packing/generators/arch_joints.h>
#include <voussoir/packing/generators/measures.h>

#include <algorithm>
#include <cmath>

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

/** The cells left of the crown, from the ground up. */
class LeftHalf
{
public:
  /** An arch of @p n_rings without a pier, from its springing. */
  LeftHalf(const ArchJoint &springing, const unsigned int n_rings)
      : n_rings(n_rings), last(add_vertices(springing))
  {}

  /** Begin with a pier of @p n_courses, at least as wide as the joint. */
  LeftHalf(const ArchJoint &springing,
           const unsigned int n_rings,
           const double width,
           const unsigned int n_courses,
           const double height)
      : n_rings(n_rings), n_courses(n_courses)
  {
    const Point<2> &inner = springing.intrados, &outer = springing.extrados;
    const double ledge = outer[0] - (inner[0] - width);
    const bool has_ledge = ledge > narrowest_ledge * inner.distance(outer);
    const double back = has_ledge ? inner[0] - width : outer[0];
    const double ground = inner[1] - height;
    half.vertices = {{inner[0], ground}, {back, ground}};
    for (unsigned int k = 1; k < n_courses; ++k)
    {
      const double y = inner[1] - height * (n_courses - k) / n_courses;
      half.vertices.insert(half.vertices.end(), {{inner[0], y}, {back, y}});
      half.add({2 * k - 1, 2 * k - 2, 2 * k, 2 * k + 1});
    }
    last = add_vertices(springing);
    std::vector<unsigned int> top = {2 * n_courses - 1, 2 * n_courses - 2};
    for (unsigned int r = 0; r <= n_rings; ++r)
      top.push_back(last + r);
    if (has_ledge)
    {
      top.push_back(half.vertices.size());
      half.vertices.emplace_back(back, outer[1]);
    }
    half.add(top);
    half.group.assign(n_courses, abutment());
  }

  /** Add the voussoirs up to the next joint, one a ring from the inside. */
  void add(const ArchJoint &joint)
  {
    const unsigned int next = add_vertices(joint);
    for (unsigned int r = 0; r < n_rings; ++r)
    {
      half.add({last + r + 1, last + r, next + r, next + r + 1});
      half.group.push_back(r);
    }
    last = next;
  }

  /** The arch of the half, the keystones if there are any, and the image. */
  CellLoops mirrored(const bool has_keystone,
                     const std::optional<Point<2>> &apex) const
  {
    CellLoops arch = half;
    arch.group_names = group_names();
    const std::vector<unsigned int> image = add_image(arch);
    if (has_keystone)
      add_keystones(arch, image, apex);
    for (unsigned int k = n_places(); k-- > 0;)
      for (unsigned int r = 0; r < n_rings; ++r)
        add_image_of(n_courses + k * n_rings + r, image, arch);
    for (unsigned int c = n_courses; c-- > 0;)
      add_image_of(c, image, arch);
    return arch;
  }

private:
  /** Add the ends of the joints of the rings; return the number of the inner
   * one, which the others follow. */
  unsigned int add_vertices(const ArchJoint &joint)
  {
    const unsigned int first = half.vertices.size();
    const auto across = joint.extrados - joint.intrados;
    half.vertices.push_back(joint.intrados);
    for (unsigned int r = 1; r < n_rings; ++r)
      half.vertices.push_back(joint.intrados + across * (1. * r / n_rings));
    half.vertices.push_back(joint.extrados);
    return first;
  }

  /** Add the mirror images of the vertices; return their numbers. */
  std::vector<unsigned int> add_image(CellLoops &arch) const
  {
    std::vector<unsigned int> image;
    for (unsigned int v = 0; v < half.vertices.size(); ++v)
      if (half.vertices[v][0] == 0.)
        image.push_back(v);
      else
      {
        image.push_back(arch.vertices.size());
        arch.vertices.emplace_back(-half.vertices[v][0], half.vertices[v][1]);
      }
    return image;
  }

  void add_keystones(CellLoops &arch,
                     const std::vector<unsigned int> &image,
                     const std::optional<Point<2>> &apex) const
  {
    for (unsigned int r = 0; r < n_rings; ++r)
    {
      const unsigned int low = last + r, high = low + 1;
      std::vector<unsigned int> loop = {low, image[low], image[high]};
      if (apex && r + 1 == n_rings)
      {
        loop.push_back(arch.vertices.size());
        arch.vertices.push_back(*apex);
      }
      loop.push_back(high);
      arch.add(loop);
      arch.group.push_back(n_rings == 1 ? keystone : r);
    }
  }

  void add_image_of(const unsigned int cell,
                    const std::vector<unsigned int> &image,
                    CellLoops &arch) const
  {
    std::vector<unsigned int> loop;
    for (unsigned int i = half.n_sides(cell); i-- > 0;)
      loop.push_back(image[half.corner(cell, i)]);
    arch.add(loop);
    arch.group.push_back(half.group[cell]);
  }

  /** The number of voussoirs along each ring of the half. */
  unsigned int n_places() const
  {
    return (half.n_cells() - n_courses) / n_rings;
  }

  /** The names of the groups: those of voussoirs, then that of the piers. */
  std::vector<std::string> group_names() const
  {
    if (n_rings == 1)
      return {"voussoir", "keystone", "abutment"};
    std::vector<std::string> names;
    for (unsigned int r = 1; r <= n_rings; ++r)
      names.push_back(text("ring ", r));
    names.push_back("abutment");
    return names;
  }

  /** The group of the keystone of an arch of one ring. */
  static constexpr unsigned int keystone = 1;
  unsigned int abutment() const { return std::max(n_rings, 2u); }

  CellLoops half;
  unsigned int n_rings;
  unsigned int n_courses = 0;
  /** The inner end of the last joint; the outer ones are the next vertices. */
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
  prm.add_parameter("Rings", n_rings,
                    "Number of rings into which the thickness is divided "
                    "evenly, one upon the other, with the same number of "
                    "voussoirs in each. Their joints lie along the arch.",
                    Integer(1, 1000));
  prm.add_parameter("Abutments", n_abutment_courses,
                    "Number of courses of the pier under each springing; 0 for "
                    "no piers. Under an inclined springing the top course is a "
                    "skewback.",
                    Integer(0, 1000000));
  prm.add_parameter("Abutment height", abutment_height,
                    "Height of the piers up to the intrados at the springing; "
                    "a length, positive.",
                    Double(0.));
  prm.add_parameter("Abutment width", abutment_width,
                    "Width of the piers, from the intrados outwards; a length, "
                    "at least 'Thickness'. 0: the same as 'Thickness'.",
                    Double(0.));
}

double ArchGenerator::width_of_piers() const
{
  const double thickness = profile.thickness();
  if (abutment_width == 0.)
    return thickness;
  if (!(abutment_width >= thickness && std::isfinite(abutment_width)))
    throw InputError(text("'", section, "/Abutment width' is ", abutment_width,
                          " and the thickness of the arch ", thickness,
                          "; the piers must be at least as wide as the arch is "
                          "thick, or 0 to be just so."));
  return abutment_width;
}

unsigned int ArchGenerator::rank_of(const unsigned int cell) const
{
  const unsigned int n_voussoirs = profile.n_voussoirs();
  if (cell < n_abutment_courses)
    return cell;
  const unsigned int in_arch = cell - n_abutment_courses;
  if (in_arch < n_voussoirs * n_rings)
    return n_abutment_courses + in_arch / n_rings + in_arch % n_rings;
  return cell - n_voussoirs * (n_rings - 1);
}

CellLoops ArchGenerator::generate(const std::filesystem::path &,
                                  Terminal &) const
{
  if (n_abutment_courses > 0)
    check_measures(section, {{"Abutment height", abutment_height}});
  check_number_of_cells(double(profile.n_voussoirs()) * n_rings,
                        text("'Voussoirs' and 'Rings' of '", section, "'"));
  const HalfArch half = profile.joints();

  const ArchJoint &springing = half.joints.front();
  LeftHalf left = n_abutment_courses == 0
                      ? LeftHalf(springing, n_rings)
                      : LeftHalf(springing, n_rings, width_of_piers(),
                                 n_abutment_courses, abutment_height);
  for (unsigned int k = 1; k < half.joints.size(); ++k)
    left.add(half.joints[k]);
  return left.mirrored(profile.n_voussoirs() % 2 == 1, half.apex);
}
} // namespace Voussoir
