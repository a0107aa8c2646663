// SPDX-License-Identifier: LGPL-2.1-or-later

// Geometry at its extremes: edges down to 1e-14 of the longest, generators
// closer than rounding, many cells at one point, slender bricks, courses of
// very different heights, cells of 3 and of 1,000 sides, one to three cells.

#include <voussoir/base/geometry.h>
#include <voussoir/base/text.h>
#include <voussoir/stress/reconstruction.h>

#include <deal.II/base/numbers.h>

#include "judgement.h"
#include "room.h"
#include <array>
#include <map>

namespace test_geometry
{
using namespace Voussoir;
using dealii::Point;

const auto pressure = tensor(-1., 0., 0., -1.);
const Rectangle unit = {{0., 0.}, {1., 1.}};

PointList<2> points(const std::vector<Point<2>> &list)
{
  PointList<2> result;
  result.points = list;
  return result;
}

CellLoops cells_of(const std::vector<Point<2>> &vertices,
                   const std::vector<std::vector<unsigned int>> &loops)
{
  CellLoops cells;
  cells.vertices = vertices;
  for (const auto &loop : loops)
  {
    cells.loops.insert(cells.loops.end(), loop.begin(), loop.end());
    cells.first.push_back(cells.loops.size());
  }
  return cells;
}

/**
 * The error of the stress inside the cells under a uniform one: the largest in
 * a cell's L2 norm, over the root of its area, and the largest of all.
 */
std::array<double, 2> errors_inside(const Scene &scene,
                                    const dealii::Tensor<2, 2> &S,
                                    const Reconstruction &how)
{
  const Packing<2> &packing = scene.packing;
  InterfaceForces forces;
  for (const auto &i : packing.interfaces())
  {
    forces.normal.push_back(i.length * (i.normal * (S * i.normal)));
    forces.tangential.push_back(i.length * (i.tangent() * (S * i.normal)));
  }
  std::ostringstream nowhere;
  Terminal &quiet = Terminal::silent();
  const StressField field = reconstruct_stress(scene, forces, how, quiet);

  Worst in_mean, anywhere;
  const unsigned int n_quads = field.cut.of_triangle().size();
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    double square = 0.;
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
      for (unsigned int k = 0; k < n_quads; ++k)
      {
        const auto q =
            field.cut.corners(k, packing.centre(c), packing.vertex(c, i),
                              packing.vertex(c, i + 1));
        const SubCellStress &s =
            field.sub_cells[field.first(packing, c, i) + k];
        const double error = (s.stress - S).norm() + s.skew;
        anywhere.add(error);
        square +=
            error * error * std::abs(cross(q[3] - q[0], q[2] - q[1])) / 2.;
      }
    in_mean.add(std::sqrt(square / packing.area(c)));
  }
  return {{in_mean.error, anywhere.error}};
}

/** Uniform stresses come back inside the cells, and nothing is NaN. */
void reconstruct(const std::string &name, const Packing<2> &packing)
{
  for (const auto &S : {pressure, tensor(-1.3, 0.2, 0.2, -0.7)})
  {
    const Scene scene = scene_under_stress(packing, 1., S);
    for (const bool is_refined : {false, true})
    {
      const auto [in_mean, anywhere] =
          errors_inside(scene, S, {is_refined, 0, 0});
      check_error(name +
                      (is_refined ? ": on finer sub-cells" : ": stress inside"),
                  in_mean, 1e-6);
      // A sliver has fewer digits, and they weigh less.
      check_error("  anywhere", anywhere, 1e-4);
    }
  }
}

/**
 * All formulations carry a uniform pressure, which is right in the mean but for
 * the residual times the cells' @p aspect.
 */
void carry_pressure(const std::string &name,
                    const Packing<2> &packing,
                    const double aspect = 1.)
{
  Worst certificate, mean;
  std::string not_carried;
  for (const Method &method : all_methods)
  {
    const Scene scene = scene_under_stress(packing, 0.5, pressure);
    const Judgement found = judge(scene, method);
    if (found.verdict != Verdict::carried)
    {
      not_carried += " " + method.name + " (" + found.message + ")";
      continue;
    }
    certificate.add(found.error);
    mean.add(error_of_mean(scene, found.forces, pressure));
  }
  check(name + ": carried" + not_carried, not_carried.empty());
  check_error(name + ": certificate", certificate.error, 1e-8);
  check_error(name + ": mean stress", mean.error, 1e-8 * aspect);
  reconstruct(name, packing);
}

// ------------------------------------------------------------- short edges

/** Four cells around an edge of length h in the middle of a square. */
Packing<2> around_short_edge(const double h)
{
  return Packing<2>(
      cells_of({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -h / 2}, {0, h / 2}},
               {{0, 1, 4}, {1, 2, 5, 4}, {2, 3, 5}, {3, 0, 4, 5}}));
}

void try_short_edges()
{
  std::map<std::string, InterfaceForces> shortest;
  for (const double h : {1e-14, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4})
  {
    const std::string name = text("edge of ", h);
    carry_pressure(name, around_short_edge(h));
    Worst difference;
    for (const Method &method : all_methods)
    {
      if (!selects_a_state(method))
        continue;
      const InterfaceForces forces =
          judge(scene_under_stress(around_short_edge(h), 0.5, pressure), method)
              .forces;
      const auto limit = shortest.emplace(method.name, forces).first;
      difference.add(forces.normal.size() == limit->second.normal.size()
                         ? distance(forces, limit->second)
                         : 1e300);
    }
    // As the edge shrinks the forces tend to a limit, in proportion to h.
    check_error("  from those of the shortest", difference.error,
                30. * h + 1e-7);
  }
}

void try_close_generators()
{
  for (const double distance : {1e-3, 1e-6, 1e-9, 1e-11})
    carry_pressure(text("generators ", distance, " apart"),
                   Packing<2>(voronoi_cells(points({{0.5, 0.5},
                                                    {0.5 + distance, 0.5},
                                                    {0.2, 0.3},
                                                    {0.8, 0.2},
                                                    {0.3, 0.8}}),
                                            unit)));
  for (const double distance : {1e-13, 1e-15, 0.})
    show_refusal([&] {
      voronoi_cells(points({{0.25, 0.5}, {0.25 + distance, 0.5}}), unit);
    });
}

/** Five cells that meet at one point, but for a perturbation. */
void try_meeting_cells()
{
  for (const double perturbation :
       {0., 1e-16, 1e-14, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4})
  {
    PointList<2> list;
    for (unsigned int i = 0; i < 5; ++i)
    {
      const double angle = 0.3 + 2. * dealii::numbers::PI * i / 5;
      const double radius = 0.25 + (i == 0 ? perturbation : 0.);
      list.points.emplace_back(0.5 + radius * std::cos(angle),
                               0.5 + radius * std::sin(angle));
    }
    carry_pressure(text("five cells at a point but for ", perturbation),
                   Packing<2>(voronoi_cells(list, unit)));
  }
  PointList<2> grid;
  for (unsigned int i = 0; i < 7; ++i)
    for (unsigned int j = 0; j < 7; ++j)
      grid.points.emplace_back((i + 0.5) / 7, (j + 0.5) / 7);
  const Packing<2> squares(voronoi_cells(grid, unit));
  check("cocircular seeds: 84 interfaces", squares.interfaces().size() == 84);
  carry_pressure("cocircular seeds", squares);
}

// ------------------------------------------------------------ slender cells

/**
 * A wall that stands if and only if s_T >= 1. Where no state has every p > 0
 * the centres must tell which joints are never pressed, and may give up.
 */
void try_shear(const std::string &name,
               const std::function<Scene(double)> &scene_at,
               const bool centres_may_refuse = false)
{
  for (const Method &method : all_methods)
    for (const double strength : {1.5, 1.01, 0.99})
    {
      const Judgement found = judge(scene_at(strength), method);
      check(name + ", s_T = " + std::to_string(strength) + ", " + method.name,
            found.verdict ==
                    (strength > 1. ? Verdict::carried : Verdict::collapse) ||
                (centres_may_refuse && strength > 1. &&
                 method.formulation == "analytic centre" &&
                 found.verdict == Verdict::refused && !found.message.empty()));
    }
}

/** Two columns in courses of height 1 and 1e-6 in turn. */
Packing<2> uneven_courses()
{
  std::vector<double> y = {0.};
  for (unsigned int k = 0; k < 5; ++k)
    y.push_back(y.back() + (k % 2 == 0 ? 1. : 1e-6));
  const double x[] = {0., 0.7, 1.5};
  std::vector<Point<2>> vertices;
  for (const double level : y)
    for (const double place : x)
      vertices.emplace_back(place, level);
  std::vector<std::vector<unsigned int>> loops;
  for (unsigned int k = 0; k + 1 < y.size(); ++k)
    for (unsigned int i = 0; i < 2; ++i)
    {
      const unsigned int v = 3 * k + i;
      loops.push_back({v, v + 1, v + 4, v + 3});
    }
  return Packing<2>(cells_of(vertices, loops));
}

// ------------------------------------------------------- sides and counts

/** A regular polygon of n sides, and a ring of n cells around it. */
Packing<2> ring_around(const unsigned int n)
{
  std::vector<Point<2>> vertices;
  for (const double radius : {1., 1.05})
    for (unsigned int i = 0; i < n; ++i)
      vertices.emplace_back(radius * std::cos(2. * dealii::numbers::PI * i / n),
                            radius *
                                std::sin(2. * dealii::numbers::PI * i / n));
  std::vector<std::vector<unsigned int>> loops(1);
  for (unsigned int i = 0; i < n; ++i)
  {
    loops[0].push_back(i);
    const unsigned int next = (i + 1) % n;
    loops.push_back({i, i + n, next + n, next});
  }
  return Packing<2>(cells_of(vertices, loops));
}

void try_few_cells()
{
  const Packing<2> one(voronoi_cells(points({{0.3, 0.8}}), unit));
  const Scene alone = scene_under_stress(one, 1., pressure);
  for (const Method &method : all_methods)
    check("one cell, " + method.name,
          judge(alone, method).verdict == Verdict::carried);
  for (const unsigned int n : {2, 3})
  {
    PointList<2> row;
    for (unsigned int i = 0; i < n; ++i)
      row.points.emplace_back((i + 0.5) / n, 0.5);
    Worst error;
    for (const Method &method : all_methods)
    {
      // The joints are as long as the sides: |f^n| = 1, f^t = 0.
      const Judgement found =
          judge(scene_under_stress(Packing<2>(voronoi_cells(row, unit)), 1.,
                                   pressure),
                method);
      check(std::to_string(n) + " cells, " + method.name,
            found.verdict == Verdict::carried);
      for (unsigned int e = 0; e < found.forces.normal.size(); ++e)
        error.add(std::abs(found.forces.normal[e] + 1.) +
                  std::abs(found.forces.tangential[e]));
    }
    check_error(std::to_string(n) + " cells in a row: forces", error.error,
                1e-8);
  }
}

void run()
{
  try_short_edges();
  try_close_generators();
  try_meeting_cells();
  // Bricks of aspect 1e4, lying and standing.
  for (const auto &[width, height] :
       {std::make_pair(5e3, 1.), std::make_pair(1., 2e4)})
  {
    carry_pressure(
        text("bricks of aspect 1e4, pressure, ", width, " x ", height),
        wall(12, 6, width, height), 1e4);
    try_shear(
        text("bricks of aspect 1e4, wall of ", width, " x ", height),
        [&](const double strength) {
          return shear_wall(strength, width, height);
        },
        height > width);
  }
  try_shear("courses of 1 and 1e-6", [](const double strength) {
    return scene_with(uneven_courses(), strength,
                      [](const Point<2> &, const dealii::Tensor<1, 2> &n) {
                        return dealii::Tensor<1, 2>({n[1], 0.});
                      });
  });
  carry_pressure("courses of 1 and 1e-6, pressure", uneven_courses());
  carry_pressure("a triangle in a ring", ring_around(3));
  carry_pressure("a cell of 1,000 sides", ring_around(1000));
  try_few_cells();
}

const RoomTest test("geometry", run);
} // namespace test_geometry
