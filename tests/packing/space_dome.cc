// SPDX-License-Identifier: LGPL-2.1-or-later

// Domes against closed forms of volumes and areas of joints, with a keystone
// and with an oculus, radial and horizontal bed joints, and both bonds;
// failures.

#include <voussoir/packing/polyhedra/generators/dome.h>

#include "shell_checks.h"

namespace test_space_dome
{
using namespace Voussoir;
using dealii::numbers::PI;

CellFaces generate(const std::string &settings)
{
  return generated<DomeGenerator>(settings);
}

/** A dome of the mean radius 2; angles in degrees. */
struct Shape
{
  unsigned int n_courses, n_sectors;
  bool running = true;
  double thickness = 0.3;
  double embrace = 180.;
  double oculus = 0.; /**< 0: a keystone */
  bool level = false;

  double inner() const { return 2. - thickness / 2.; }
  double outer() const { return 2. + thickness / 2.; }
  unsigned int n_facets() const { return n_sectors * (running ? 2 : 1); }
  /** The angle of a facet. */
  double facet() const { return 2. * PI / n_facets(); }

  /** The angle from the axis to a joint, from the crown down. */
  double angle(const unsigned int k) const
  {
    const double foot = embrace * PI / 360.;
    const double crown =
        oculus > 0. ? oculus * PI / 360. : 0.5 * foot / (n_courses + 0.5);
    return crown + (foot - crown) * k / n_courses;
  }

  double volume() const
  {
    return n_facets() * std::sin(facet()) * (level ? level_part() : radial());
  }

  /** The area of one bed, all around. */
  double bed(const unsigned int k) const
  {
    const double s = std::sin(angle(k));
    const double d = facet();
    if (level)
      return 0.5 * n_facets() * std::sin(d) *
             (outer() * outer() - inner() * inner());
    // With the origin, an upper corner and the next one, on a unit sphere.
    const double triangle = s * std::sin(d / 2.) *
                            std::sqrt(1. - std::pow(s * std::sin(d / 2.), 2));
    return n_facets() * triangle * (outer() * outer() - inner() * inner());
  }

  double beds() const
  {
    double area = 0.;
    for (unsigned int k = oculus > 0. ? 1 : 0; k < n_courses; ++k)
      area += bed(k);
    return area;
  }

  double heads() const
  {
    double area = 0.;
    for (unsigned int k = 0; k < n_courses; ++k)
      if (level)
      {
        const double high = height(k), low = height(k + 1);
        area += 0.5 * (high - low) *
                (radius_at(outer(), high) - radius_at(inner(), high) +
                 radius_at(outer(), low) - radius_at(inner(), low));
      }
      else
        area += 0.5 * std::sin(angle(k + 1) - angle(k)) *
                (outer() * outer() - inner() * inner());
    return area * n_sectors;
  }

private:
  /** The height of a horizontal joint. */
  double height(const unsigned int k) const
  {
    const double top = std::cos(angle(0)), foot = std::cos(angle(n_courses));
    return inner() * (top + (foot - top) * k / n_courses);
  }

  /** The distance of a sphere from the axis at a height. */
  static double radius_at(const double sphere, const double z)
  {
    return std::sqrt(sphere * sphere - z * z);
  }

  /** The part of a facet between heights, over the sine of its angle. */
  static double
  cone(const double a, const double b, const double z_a, const double z_b)
  {
    return (z_a - z_b) * (a * a + a * b + b * b) / 6.;
  }

  double radial() const
  {
    const double shell = std::pow(outer(), 3) - std::pow(inner(), 3);
    double sum = 0.;
    for (unsigned int k = 0; k < n_courses; ++k)
      sum += (std::sin(angle(k)) + std::sin(angle(k + 1))) *
             std::sin(angle(k + 1) - angle(k)) / 6.;
    if (oculus == 0.)
      sum += std::pow(std::sin(angle(0)), 2) * std::cos(angle(0)) / 6.;
    return shell * sum;
  }

  double level_part() const
  {
    double sum = 0.;
    for (unsigned int k = 0; k < n_courses; ++k)
    {
      const double high = height(k), low = height(k + 1);
      for (const double sphere : {outer(), inner()})
        sum += (sphere > 2. ? 1. : -1.) *
               cone(radius_at(sphere, high), radius_at(sphere, low), high, low);
    }
    if (oculus == 0.)
      sum += cone(outer() * std::sin(angle(0)), radius_at(outer(), height(0)),
                  outer() * std::cos(angle(0)), height(0));
    return sum;
  }
};

CellFaces generate(const Shape &shape)
{
  return generate(text(
      "set Mean radius = 2\nset Courses = ", shape.n_courses,
      "\nset Sectors = ", shape.n_sectors,
      "\nset Thickness = ", shape.thickness, "\nset Embrace = ", shape.embrace,
      "\nset Bond = ", shape.running ? "running" : "stack", "\nset Crown = ",
      shape.oculus > 0. ? text("oculus\nset Oculus = ", shape.oculus)
                        : "keystone",
      "\nset Bed joints = ", shape.level ? "horizontal" : "radial"));
}

/** Head joints are in planes through the axis of z. */
bool is_meridian(const dealii::Point<3> &p, const dealii::Tensor<1, 3> &n)
{
  return std::abs(n[2]) < 1e-9 && std::abs(n[0] * p[0] + n[1] * p[1]) < 1e-9;
}

void check_dome(const Shape &shape)
{
  const unsigned int n = shape.n_courses, m = shape.n_sectors;
  std::cout << n << " courses of " << m
            << (shape.running ? ", running" : ", stack") << ", t "
            << shape.thickness << ", embrace " << shape.embrace << ", oculus "
            << shape.oculus << (shape.level ? ", horizontal" : ", radial")
            << std::endl;
  const CellFaces cells = generate(shape);
  const bool has_keystone = shape.oculus == 0.;
  check("  cells", cells.n_cells() == n * m + (has_keystone ? 1 : 0));
  check("  keystone", has_keystone == (cells.group[0] == 1) &&
                          std::count(cells.group.begin(), cells.group.end(),
                                     1) == (has_keystone ? 1 : 0) &&
                          cells.group_names[1] == "keystone");
  check_shell(cells, shape.volume(), shape.running ? n * m : 0);
  const ContactAreas areas = contact_areas(cells, is_meridian);
  check("  pairs that touch",
        areas.n_pairs ==
            n * m + (n - 1) * shape.n_facets() + (has_keystone ? m : 0));
  check_area("  beds", areas.beds, shape.beds());
  check_area("  heads", areas.heads, shape.heads());
  if (shape.embrace == 180.)
    check_area("  foot", area_on_ground(cells), shape.bed(n));
}

/** All vertices on two spheres, and head joints of courses in turn. */
void check_places()
{
  std::cout << "places" << std::endl;
  const CellFaces cells = generate(Shape{6, 5});
  double off_sphere = 0.;
  for (const auto &p : cells.vertices)
    off_sphere = std::max(off_sphere, std::min(std::abs(p.norm() - 1.85),
                                               std::abs(p.norm() - 2.15)));
  check_error("  vertices on two spheres", off_sphere, 1e-15);
  bool in_order = true;
  for (unsigned int c = 1; c < cells.n_cells(); ++c)
  {
    const unsigned int course = (c - 1) / 5, block = (c - 1) % 5;
    const auto centre = moments_of(cells, c).centroid;
    double angle = std::atan2(centre[1], centre[0]) / (2. * PI) * 10.;
    angle += angle < 0. ? 10. : 0.;
    const double expected =
        std::fmod(2. * block + 1. + (course % 2 == 1 ? 1. : 0.), 10.);
    in_order &= std::abs(angle - expected) < 1e-9 ||
                std::abs(angle - expected - 10.) < 1e-9;
  }
  check("  order of the cells, every second course shifted", in_order);
}

void refuse(const std::string &settings)
{
  show_refusal([&] { generate(settings); });
}

void run()
{
  check_dome({10, 12});
  check_dome({10, 12, false});
  check_dome({5, 3, false, 0.8});
  check_dome({5, 3, true, 0.8});
  check_dome({1, 4, true});
  check_dome({7, 9, true, 0.3, 120.});
  check_dome({7, 9, false, 0.3, 120.});
  check_dome({6, 8, true, 0.3, 180., 40.});
  check_dome({6, 8, false, 0.3, 100., 40.});
  check_dome({8, 7, true, 0.3, 180., 0., true});
  check_dome({8, 7, false, 1.5, 180., 0., true});
  check_dome({8, 7, true, 0.3, 130., 30., true});
  check_places();

  // A finer dome comes near the shell of a hemisphere.
  std::cout << "hemisphere" << std::endl;
  const double shell = 2. / 3. * PI * (std::pow(2.15, 3) - std::pow(1.85, 3));
  const auto distance = [&](const unsigned int n) {
    return 1. - volume_of(generate(Shape{n, 2 * n})) / shell;
  };
  const double coarse = distance(8), fine = distance(16);
  check("  the second order of the volume",
        fine > 0. && coarse / fine > 3.8 && coarse / fine < 4.4);

  refuse("set Mean radius = 0");
  refuse("set Thickness = 0");
  refuse("set Embrace = 0");
  refuse("set Crown = oculus\nset Oculus = 0");
  refuse("set Crown = oculus\nset Oculus = 90\nset Embrace = 90");
  refuse("set Thickness = 2");
  refuse("set Courses = 1000000\nset Sectors = 1000000");
  refuse("set Sectors = 1000000");
  refuse("set Crown = oculus\nset Oculus = 179.9999\nset Courses = 100");
  refuse("set Thickness = 1e-7");
}

const RoomTest test("space_dome", run);
} // namespace test_space_dome
