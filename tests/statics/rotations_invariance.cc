// SPDX-License-Identifier: LGPL-2.1-or-later

// Blocks that turn: neither a rotation of the scene, nor coordinates a million
// lengths away, nor the order of the cells, nor the units change a force or
// the place where it acts.

#include "judgement.h"
#include "room.h"
#include <array>
#include <map>
#include <numeric>
#include <random>

namespace test_rotations_invariance
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

/** A scene seen otherwise. */
struct Transformed
{
  double angle = 0.;
  Tensor<1, 2> offset;
  double length = 1.;
  double stress = 1.;
  /** Of each cell; empty: as it was. */
  std::vector<unsigned int> old_number;

  Tensor<1, 2> turned(const Tensor<1, 2> &v, const double sign = 1.) const
  {
    const double c = std::cos(angle), s = sign * std::sin(angle);
    return Tensor<1, 2>({c * v[0] - s * v[1], s * v[0] + c * v[1]});
  }
  Point<2> operator()(const Point<2> &x) const
  {
    return Point<2>(length * (turned(x) + offset));
  }
  Point<2> back(const Point<2> &x) const
  {
    return Point<2>(turned(x / length - offset, -1.));
  }
};

CellLoops seen(const CellLoops &cells, const Transformed &view)
{
  CellLoops result;
  for (const Point<2> &x : cells.vertices)
    result.vertices.push_back(view(x));
  for (const unsigned int c : view.old_number)
  {
    result.loops.insert(result.loops.end(),
                        cells.loops.begin() + cells.first[c],
                        cells.loops.begin() + cells.first[c + 1]);
    result.first.push_back(result.loops.size());
    result.centres.push_back(view(cells.centres[c]));
  }
  return result;
}

/** On the ground, under weight with a horizontal share and a load on top. */
Scene scene_of(const CellLoops &cells, const Transformed &view)
{
  Packing<2> packing(seen(cells, view));
  const auto is_at = [&](const auto &edge, const double y) {
    return std::abs(view.back(edge.midpoint())[1] - y) < 1e-6;
  };
  std::vector<bool> is_support;
  for (const auto &edge : packing.boundary_edges())
    is_support.push_back(is_at(edge, 0.));
  packing.support(is_support);
  Loads loads;
  for (const auto &edge : packing.boundary_edges())
  {
    Tensor<1, 2> g;
    if (is_at(edge, 1.))
      g = view.stress * view.turned(Tensor<1, 2>({0.1, -0.4}));
    loads.traction.push_back(g);
  }
  const Tensor<1, 2> b =
      view.stress / view.length * view.turned(Tensor<1, 2>({0.15, -1.}));
  loads.body =
      BodyForce(packing, [=](const Point<2> &, unsigned int) { return b; });
  const std::vector<double> strengths(packing.interfaces().size(),
                                      0.5 * view.stress);
  return Scene(std::move(packing), strengths, std::move(loads), rotations());
}

/**
 * By the old numbers of two cells: both components, and the resultant's arm
 * about the midpoint of their interface times its normal component.
 */
using Forces =
    std::map<std::pair<unsigned int, unsigned int>, std::array<double, 4>>;

Forces forces_of(const CellLoops &cells, Transformed view, const Method &method)
{
  if (view.old_number.empty())
  {
    view.old_number.resize(cells.first.size() - 1);
    std::iota(view.old_number.begin(), view.old_number.end(), 0);
  }
  const Scene scene = scene_of(cells, view);
  const Judgement found = judge(scene, method);
  Forces forces;
  if (found.verdict != Verdict::carried)
    return forces;
  const auto number = [&](const unsigned int c) {
    return c == scene.packing.ground() ? c : view.old_number[c];
  };
  for (unsigned int e = 0; e < found.forces.normal.size(); ++e)
  {
    const auto &i = scene.packing.interfaces()[e];
    const double unit = view.length * view.stress;
    const double normal = found.forces.normal[e] / unit;
    const Tensor<1, 2> arm = normal * found.forces.eccentricity(i, e) /
                             view.length * view.turned(i.end - i.start, -1.);
    const unsigned int a = number(i.cell_minus), b = number(i.cell_plus);
    forces[{std::min(a, b), std::max(a, b)}] = {
        {normal, found.forces.tangential[e] / unit, arm[0], arm[1]}};
  }
  return forces;
}

double difference(const Forces &a, const Forces &b)
{
  if (a.size() != b.size() || a.empty())
    return 1e300;
  Worst worst;
  for (const auto &[pair, force] : a)
    for (unsigned int k = 0; k < force.size(); ++k)
      worst.add(b.count(pair) == 0 ? 1e300
                                   : std::abs(force[k] - b.at(pair)[k]));
  return worst.error;
}

void run()
{
  constexpr unsigned int n_cells = 80;
  const CellLoops cells =
      voronoi_cells(random_points(n_cells, 3), Rectangle{{0., 0.}, {1., 1.}});
  std::map<std::string, Transformed> views;
  views["turned"].angle = 2.3;
  views["far away"].offset = Tensor<1, 2>({1e6, -1e6});
  views["in other units"].length = 1e3;
  views["in other units"].stress = 1e-7;
  views["renumbered"].old_number.resize(n_cells);
  std::iota(views["renumbered"].old_number.begin(),
            views["renumbered"].old_number.end(), 0);
  std::shuffle(views["renumbered"].old_number.begin(),
               views["renumbered"].old_number.end(), std::mt19937(1));
  for (const Method &method : all_methods)
  {
    const Forces reference = forces_of(cells, Transformed(), method);
    for (const auto &[name, view] : views)
      check_error(method.name + ", " + name,
                  difference(reference, forces_of(cells, view, method)), 1e-8);
  }
}

const RoomTest test("rotations_invariance", run);
} // namespace test_rotations_invariance
