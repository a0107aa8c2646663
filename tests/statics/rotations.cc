// SPDX-License-Identifier: LGPL-2.1-or-later

// Blocks that turn, where the answer is known: columns overturn at the ratio of
// their width to their height, a corbel about the edge of its base, a tilted
// block at its diagonal, a semicircular arch at its least thickness. Each
// formulation carries a little less and proves the collapse of a little more.

#include <voussoir/scene/supports.h>

#include "tests.h"
#include <tuple>

namespace test_rotations
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

/** Under the body force @p b on supports where @p condition holds. */
Scene under(Packing<2> packing,
            const Tensor<1, 2> &b,
            const std::string &condition,
            const double strength = 100.)
{
  packing.support(boundary_edges_where(packing, condition, ""));
  Loads loads;
  loads.traction.resize(packing.boundary_edges().size());
  loads.body =
      BodyForce(packing, [=](const Point<2> &, unsigned int) { return b; });
  const std::vector<double> strengths(packing.interfaces().size(), strength);
  return Scene(std::move(packing), strengths, std::move(loads), rotations());
}

/** Quadrilaterals, each on top of the one before: rows of two corners. */
Packing<2> pile(const std::vector<std::array<Point<2>, 2>> &rows)
{
  CellLoops cells;
  for (const auto &row : rows)
    cells.vertices.insert(cells.vertices.end(), row.begin(), row.end());
  for (unsigned int k = 0; k + 1 < rows.size(); ++k)
  {
    for (const unsigned int v : {2 * k, 2 * k + 1, 2 * k + 3, 2 * k + 2})
      cells.loops.push_back(v);
    cells.first.push_back(cells.loops.size());
  }
  return Packing<2>(cells);
}

/** A column of n blocks under its weight and a share of it sideways. */
Scene column(const unsigned int n,
             const double width,
             const double height,
             const double share)
{
  std::vector<std::array<Point<2>, 2>> rows;
  for (unsigned int k = 0; k <= n; ++k)
    rows.push_back({{{0., height * k / n}, {width, height * k / n}}});
  return under(pile(rows), Tensor<1, 2>({share, -1.}), "y < 1e-9");
}

/** A column of width 1 tilted by @p angle on an inclined ground. */
Scene tilted(const unsigned int n, const double height, const double angle)
{
  return [&] {
    std::vector<std::array<Point<2>, 2>> rows;
    const Point<2> along(std::cos(angle), std::sin(angle));
    const Point<2> up(-std::sin(angle), std::cos(angle));
    for (unsigned int k = 0; k <= n; ++k)
    {
      const Point<2> left(height * k / n * up);
      rows.push_back({{left, Point<2>(left + along)}});
    }
    return under(pile(rows), Tensor<1, 2>({0., -1.}), "ny < -0.5");
  }();
}

/**
 * A block without weight that is wider at its top than at its base of width
 * 0.4, and a force that presses on its top at a distance from the base's left
 * end.
 */
Scene corbel(const double distance)
{
  Packing<2> packing =
      pile({{{{0., 0.}, {0.4, 0.}}}, {{{-0.3, 0.5}, {0.9, 0.5}}}});
  packing.support(boundary_edges_where(packing, "y < 1e-9", ""));
  Loads loads;
  loads.traction.resize(packing.boundary_edges().size());
  loads.body.add(packing, 0, Tensor<1, 2>({0., -1.}),
                 Point<2>(distance, packing.centre(0)[1]));
  const std::vector<double> strengths(packing.interfaces().size(), 100.);
  return Scene(std::move(packing), strengths, std::move(loads), rotations());
}

/**
 * A semicircle of n voussoirs whose weight acts on each at @p radius, or if it
 * is zero at the centroid of the annular sector.
 */
Scene arch(const unsigned int n, const double thickness, const bool on_line)
{
  Packing<2> packing = semicircle(n, thickness);
  packing.support(boundary_edges_where(packing, "ny < -0.99 && y < 1e-9", ""));
  Loads loads;
  loads.traction.resize(packing.boundary_edges().size());
  const double half = 0.5 * dealii::numbers::PI / n;
  const double inner = 1. - 0.5 * thickness, outer = 1. + 0.5 * thickness;
  const double sector = 2. / 3. * std::sin(half) / half *
                        (std::pow(outer, 3) - std::pow(inner, 3)) /
                        (outer * outer - inner * inner);
  const double radius = on_line ? std::sin(half) / half : sector;
  const Tensor<1, 2> weight({0., -2. * half * thickness});
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    const Point<2> &x = packing.centre(c);
    loads.body.add(packing, c, weight, Point<2>(radius / x.norm() * x));
  }
  const std::vector<double> strengths(packing.interfaces().size(), 100.);
  return Scene(std::move(packing), strengths, std::move(loads), rotations());
}

/** True if carried, false if collapse is proven; an error is neither. */
bool stands(const Scene &scene, const Method &method)
{
  const DiscreteProblem problem = discretise(scene);
  const Solution found = Solver(method).solve(problem);
  if (found.mechanism)
  {
    const MechanismCertificate proof = certify_mechanism(
        scene, dimensional_motion(discretise(scene), *found.mechanism));
    if (!proves_collapse(proof))
      std::cout << "FAILED: no proof, closing " << proof.closing_violation
                << std::endl;
    return false;
  }
  const Certificate certificate =
      certify(scene, dimensional_forces(problem, found));
  if (!(certificate.error() <= 1e-6))
    std::cout << "FAILED: " << found.stop.words() << ", residual "
              << certificate.error() << std::endl;
  return true;
}

/** @p scene_at stands a little below @p limit and falls a little above. */
template <typename SceneAt>
void approach(const std::string &name,
              const double limit,
              const double margin,
              const std::vector<Method> &ways,
              const SceneAt &scene_at)
{
  for (const Method &method : ways)
  {
    check(name + ", " + method.name + ": stands below",
          stands(scene_at(limit * (1. - margin)), method));
    check(name + ", " + method.name + ": falls above",
          !stands(scene_at(limit * (1. + margin)), method));
  }
}

/** The least thickness by bisection. */
double least_thickness(const unsigned int n, const bool on_line)
{
  double falls = 0.1, carried = 0.115;
  while (carried - falls > 1e-9)
  {
    const double middle = 0.5 * (falls + carried);
    (stands(arch(n, middle, on_line), least_energy) ? carried : falls) = middle;
  }
  return carried;
}

void run()
{
  for (const unsigned int n : {1, 10, 100})
    approach("a column of " + std::to_string(n), 0.3, 1e-9, {least_energy},
             [&](const double share) { return column(n, 0.3, 1., share); });
  approach("a column of 5", 0.3, 1e-4, all_methods,
           [&](const double share) { return column(5, 0.3, 1., share); });
  for (const unsigned int n : {1, 7})
    approach("a tilted column of " + std::to_string(n), std::atan(1. / 2.5),
             1e-9, {least_energy},
             [&](const double angle) { return tilted(n, 2.5, angle); });

  approach("a corbel", 0.4, 1e-9, {least_energy}, corbel);

  // Of doc/gallery.md, where the limit is that of infinitely many voussoirs.
  for (const auto &[n, on_line, of_sectors] :
       {std::tuple(12, 0.105059575, 0.105098513),
        {24, 0.107123572, 0.107178535},
        {36, 0.107406985, 0.107457579},
        {66, 0.107426268, 0.107477748},
        {132, 0.107426268, 0.107477748},
        {640, 0.107426118, 0.107477565}})
  {
    const std::string name = "a semicircle of " + std::to_string(n);
    check_error(name + ", weight on its line",
                std::abs(least_thickness(n, true) - on_line), 1e-8);
    check_error(name + ", weight of the sectors",
                std::abs(least_thickness(n, false) - of_sectors), 1e-8);
  }
  // The values of Cocchetti and Rizzi (2020), and of the true weight.
  check_error("the limit, weight on its line",
              std::abs(least_thickness(640, true) - 0.107426), 1e-6);
  check_error("the limit, weight of the sectors",
              std::abs(least_thickness(640, false) - 0.107477743), 1e-6);
}

const RoomTest test("rotations", run);
} // namespace test_rotations
