// SPDX-License-Identifier: LGPL-2.1-or-later

// Cross vaults against closed forms: numbers of blocks, volumes, areas of
// joints with groin blocks and with mitre joints, springings, symmetry to the
// last bit; failures.

#include <voussoir/packing/polyhedra/generators/cross_vault.h>

#include "shell_checks.h"

namespace test_space_cross_vault
{
using namespace Voussoir;
using dealii::numbers::PI;

CellFaces generate(const std::string &settings)
{
  return generated<CrossVaultGenerator>(settings);
}

/** A circular vault of the mean radius 2; angles in degrees. */
struct Shape
{
  unsigned int n_voussoirs, n_blocks;
  bool running = true;
  bool mitred = false;
  double embrace = 180.;
  double extension = 0.;
  double thickness = 0.4;

  bool has_crown() const { return n_voussoirs % 2 == 1; }
  unsigned int n_below_crown() const { return n_voussoirs / 2; }
  double angle() const { return embrace * PI / 180. / n_voussoirs; }
  /** The sine of the angle of a joint from the vertical. */
  double sine(const unsigned int joint) const
  {
    return std::sin(0.5 * embrace * PI / 180. - joint * angle());
  }
  double outer() const { return 2. + thickness / 2.; }
  double half_width() const { return outer() * sine(0) + extension; }
  double voussoir() const { return std::sin(angle()) * 2. * thickness; }

  double volume() const
  {
    const double half = angle() / 2., e = embrace * PI / 360.;
    const double c = std::cos(half), s = std::sin(half);
    const double a = std::pow(outer(), 3) - std::pow(4. - outer(), 3);
    const double moment =
        has_crown() ? a * c * (2. * c * (c - std::cos(e)) + s * s) / 3.
                    : a * c * c * (1. - std::cos(e)) * 2. / 3.;
    return 4. * (half_width() * n_voussoirs * voussoir() - moment);
  }

  /** The head joints of a course in a half web, of the crown in a web. */
  unsigned int n_heads(const unsigned int course) const
  {
    const double block = half_width() / n_blocks;
    const double shift = running && course % 2 == 1 ? 0.5 * block : 0.;
    unsigned int n = 0;
    while (half_width() - (n + 1) * block + shift >=
           outer() * sine(course) + 0.25 * block)
      ++n;
    return n;
  }

  unsigned int n_cells() const
  {
    unsigned int n = 0;
    for (unsigned int k = 0; k < n_below_crown(); ++k)
      n += 8 * n_heads(k) + (mitred ? 8 : 4);
    if (has_crown())
      n += 4 * n_heads(n_below_crown()) + (mitred ? 4 : 1);
    return n;
  }

  double joints() const
  {
    double area = 0.;
    for (unsigned int k = 1; k < n_below_crown() + (has_crown() ? 1 : 0); ++k)
      area += 8. * thickness * (half_width() - 2. * sine(k));
    for (unsigned int k = 0; k < n_below_crown(); ++k)
      area += 8. * n_heads(k) * voussoir();
    if (has_crown())
      area += 4. * n_heads(n_below_crown()) * voussoir();
    else
      area += 4. * thickness * half_width();
    return area;
  }

  double mitres() const
  {
    return mitred ? std::sqrt(2.) * 4. * n_voussoirs * voussoir() / 2. : 0.;
  }
};

std::string settings_of(const Shape &shape)
{
  return text("set Mean radius = 2\nset Voussoirs = ", shape.n_voussoirs,
              "\nset Blocks = ", shape.n_blocks,
              "\nset Bond = ", shape.running ? "running" : "stack",
              "\nset Groins = ", shape.mitred ? "mitre joints" : "blocks",
              "\nset Embrace = ", shape.embrace,
              "\nset Extension = ", shape.extension,
              "\nset Thickness = ", shape.thickness, "\n");
}

bool is_mitre(const dealii::Point<3> &, const dealii::Tensor<1, 3> &normal)
{
  return std::abs(std::abs(normal[0]) - std::abs(normal[1])) < 1e-9 &&
         std::abs(normal[2]) < 1e-9;
}

/** All vertices, turned by right angles and mirrored, are vertices again. */
bool is_symmetric(const CellFaces &cells)
{
  const auto sorted = [&](const auto &turned) {
    std::vector<std::array<double, 3>> places;
    for (const auto &p : cells.vertices)
      places.push_back(turned(p));
    std::sort(places.begin(), places.end());
    return places;
  };
  using Place = std::array<double, 3>;
  const auto places = sorted([](const auto &p) -> Place {
    return {{p[0], p[1], p[2]}};
  });
  return places == sorted([](const auto &p) -> Place {
           return {{-p[1], p[0], p[2]}};
         }) &&
         places == sorted([](const auto &p) -> Place {
           return {{-p[0], p[1], p[2]}};
         });
}

void check_groups(const CellFaces &cells, const Shape &shape)
{
  auto sizes = group_sizes(cells);
  check("  groups",
        sizes["groin"] == shape.n_below_crown() * (shape.mitred ? 8 : 4) &&
            sizes["keystone"] ==
                (shape.has_crown() ? (shape.mitred ? 4 : 1) : 0) &&
            cells.group[0] == 1);
}

void check_cross_vault(const Shape &shape)
{
  std::cout << shape.n_voussoirs << " voussoirs, " << shape.n_blocks
            << " blocks" << (shape.running ? ", running" : ", stack")
            << (shape.mitred ? ", mitred" : "") << ", embrace " << shape.embrace
            << ", extension " << shape.extension << std::endl;
  const CellFaces cells = generate(settings_of(shape));
  check("  cells", cells.n_cells() == shape.n_cells());
  check_groups(cells, shape);
  const unsigned int n_bent =
      shape.mitred ? 0
                   : 4 * shape.n_below_crown() + (shape.has_crown() ? 1 : 0);
  check_shell(cells, shape.volume(), n_bent);
  check("  symmetric to the last bit", is_symmetric(cells));
  const ContactAreas areas = contact_areas(cells, is_mitre);
  check_area("  joints in the webs", areas.beds, shape.joints());
  check_area("  joints in the groins", areas.heads, shape.mitres());
  if (shape.embrace == 180.)
  {
    const double t = shape.thickness;
    check_area("  springings at z = 0", area_on_ground(cells),
               4. * (t * t + 2. * t * shape.extension));
  }
}

/** The area of an arch of the plane, and the integral of |x| over it. */
std::array<double, 2> area_and_moment(const std::string &settings)
{
  ArchGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.parse_input_from_string(settings);
  const CellLoops cells = generator.generate("", Terminal::silent());
  std::array<double, 2> sums = {{0., 0.}};
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
    for (unsigned int i = 0, n = cells.n_sides(c); i < n; ++i)
    {
      // Under a side, less what is to the right of the crown.
      auto a = cells.vertices[cells.corner(c, i)];
      auto b = cells.vertices[cells.corner(c, (i + 1) % n)];
      if (a[0] >= 0. && b[0] >= 0.)
        continue;
      for (auto *const p : {&a, &b})
        if ((*p)[0] > 0.)
        {
          const auto &other = p == &a ? b : a;
          const double share = other[0] / (other[0] - (*p)[0]);
          *p = other + share * (*p - other);
        }
      const double width = a[0] - b[0];
      sums[0] += width * (a[1] + b[1]);
      sums[1] -=
          width * (a[0] * (2. * a[1] + b[1]) + b[0] * (a[1] + 2. * b[1])) / 3.;
    }
  return sums;
}

/** Ridges at the crown, and a bay that is deeper than wide. */
void check_pointed(const unsigned int n,
                   const bool mitred,
                   const double stretch)
{
  std::cout << "pointed, " << n << " voussoirs" << (mitred ? ", mitred" : "")
            << ", depth over width " << stretch << std::endl;
  const std::string arch = text("set Shape = pointed\nset Span = 4\n"
                                "set Thickness = 0.4\nset Voussoirs = ",
                                n, "\n");
  const CellFaces cells = generate(
      text(arch, "set Extension = 0.3\nset Depth over width = ", stretch,
           "\nset Groins = ", mitred ? "mitre joints" : "blocks", "\n"));
  const auto [area, moment] = area_and_moment(arch);
  check_shell(cells, 4. * stretch * (2.5 * area - moment),
              mitred ? 0 : 4 * (n / 2) + n % 2);
  check_area("  springings at z = 0", area_on_ground(cells),
             stretch * 4. * (0.16 + 2. * 0.4 * 0.3));
  // A mitre is as long as the diagonal over the half width.
  const ContactAreas areas = contact_areas(
      cells, [=](const dealii::Point<3> &p, const dealii::Tensor<1, 3> &) {
        return std::abs(std::abs(p[1]) - stretch * std::abs(p[0])) < 1e-9;
      });
  check_area("  joints in the groins", areas.heads,
             mitred ? 2. * area * std::sqrt(1. + stretch * stretch) : 0.);
}

void refuse(const std::string &settings)
{
  show_refusal([&] { generate(settings); });
}

void run()
{
  check_cross_vault({15, 4});
  check_cross_vault({16, 4});
  check_cross_vault({15, 4, true, true});
  check_cross_vault({16, 5, true, true});
  check_cross_vault({9, 3, false});
  check_cross_vault({9, 3, false, false, 100.});
  check_cross_vault({10, 3, true, false, 100., 0.5});
  check_cross_vault({13, 6, true, true, 180., 0.5});
  check_cross_vault({2, 1});
  check_cross_vault({3, 1, false});
  check_pointed(13, false, 1.);
  check_pointed(13, true, 1.);
  check_pointed(12, false, 1.5);
  check_pointed(13, true, 0.7);

  refuse("set Thickness = 0");
  refuse("set Thickness = 2");
  refuse("set Depth over width = 0");
  refuse("set Extension = 0.001");
  refuse("set Voussoirs = 1000000\nset Blocks = 1000");
  refuse("set Thickness = 1e-7");
  refuse("set Depth over width = 1e-7");
  refuse("set Voussoirs = 1000000\nset Embrace = 0.1");
  refuse("set Blocks = 600000");
}

const RoomTest test("space_cross_vault", run);
} // namespace test_space_cross_vault
