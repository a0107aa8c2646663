// SPDX-License-Identifier: LGPL-2.1-or-later

// Ties and props: a block that one holds, a portal with a stay and an arch
// whose tie takes its thrust against closed forms; one that is slack carries
// nothing, and one that is stressed pulls. Certificates see forces that are too
// large, and the stress has what a tie does to a block.

#include <voussoir/analyses/factors/load_factor.h>
#include <voussoir/analyses/factors/strength_factor.h>
#include <voussoir/analyses/ranges/ranges.h>
#include <voussoir/analyses/samples/state_samples.h>
#include <voussoir/base/geometry.h>
#include <voussoir/packing/area_moments.h>
#include <voussoir/scene/links/ties.h>
#include <voussoir/stress/cell_means.h>

#include "polygons.h"
#include "tests.h"

namespace test_ties
{
using namespace Voussoir;
using dealii::Point;

/** Links from a section `Ties`, one for each text of entries. */
std::vector<Link> ties(const Packing<2> &packing,
                       const std::vector<std::string> &entries)
{
  std::string input = "subsection Ties\n";
  std::set<std::string> names;
  for (const std::string &of_tie : entries)
  {
    const std::string name = "tie " + std::to_string(names.size());
    names.insert(name);
    input += "subsection " + name + "\n" + of_tie + "\nend\n";
  }
  Ties of_section;
  dealii::ParameterHandler prm;
  of_section.add_parameters(prm, names);
  prm.parse_input_from_string(input + "end\n");
  return of_section.links(packing);
}

/** A scene with a weight of one, friction that holds, and links. */
Scene linked(const Packing<2> &packing,
             const double mu,
             std::vector<Link> links,
             const std::vector<CellForce> &on_cells = {},
             const double weight = 1.)
{
  Loads loads;
  loads.traction.resize(packing.boundary_edges().size());
  loads.on_cells = on_cells;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    loads.body.add(packing, c, Point<2>(0., -weight * packing.area(c)));
  const unsigned int n = packing.interfaces().size();
  Scene scene(packing, std::vector<double>(n, 0.), loads, rotations(),
              std::move(links));
  scene.coefficient.assign(n, mu);
  scene.friction_law = "associated Coulomb";
  return scene;
}

Scene dead_of(const Packing<2> &packing,
              const double mu,
              std::vector<Link> links)
{
  return linked(packing, mu, std::move(links));
}

Scene live_of(const Packing<2> &packing,
              const double mu,
              std::vector<Link> links,
              const std::vector<CellForce> &on_cells)
{
  return linked(packing, mu, without_rest(std::move(links)), on_cells, 0.);
}

LoadFactor factor_of(const Packing<2> &packing,
                     const double mu,
                     const std::vector<Link> &links,
                     const std::vector<CellForce> &live)
{
  const Scene dead = dead_of(packing, mu, links);
  return *find_load_factor(dead, live_of(packing, mu, links, live), {},
                           Terminal::silent())
              .factor;
}

void check_factor(const std::string &what,
                  const LoadFactor &found,
                  const double expected,
                  const double error = 1e-9)
{
  check_error(what + ": carried", std::abs(found.carried / expected - 1.),
              error);
  check_error(what + ": collapses", std::abs(found.bound / expected - 1.),
              error);
}

InterfaceForces state_of(const Scene &scene)
{
  const DiscreteProblem problem = discretise(scene);
  SolverParameters parameters{ProcessGroup()};
  dealii::ParameterHandler prm;
  parameters.add_parameters(prm);
  prm.parse_input_from_string("");
  return dimensional_forces(
      problem, parameters.formulation_for(scene).solve(
                   problem, parameters.controls(), Terminal::silent()));
}

/** A square of weight 1 with mu = 1/5 on the ground. */
void block()
{
  const Packing<2> square = on_ground(wall(1, 1));
  const auto pushed = [&](const double x) {
    return std::vector<CellForce>{{"cell 0", {0}, Point<2>(x, 0.)}};
  };
  const std::string ends = "set From = cell 0\nset To = ground at -2, 0.5\n";
  const auto held = ties(square, {ends + "set Yield force = 0.25"});
  check_factor("a rod holds a block", factor_of(square, 0.2, held, pushed(1.)),
               0.45);
  check_factor("not from the other side",
               factor_of(square, 0.2, held, pushed(-1.)), 0.2);
  check_factor(
      "a prop does",
      factor_of(square, 0.2,
                ties(square, {ends + "set Compressive strength = 0.25"}),
                pushed(-1.)),
      0.45);
  const auto stressed =
      ties(square, {ends + "set Yield force = 0.25\nset Prestress = 0.05"});
  check_factor("a stressed rod pulls",
               factor_of(square, 0.2, stressed, pushed(-1.)), 0.15);
  check_factor("and holds", factor_of(square, 0.2, stressed, pushed(1.)), 0.45);
  const auto given =
      ties(square, {ends + "set Yield force = 0.1\nset Prestress = 0.1"});
  check_factor("a force that is given",
               factor_of(square, 0.2, given, pushed(-1.)), 0.1);

  check_error("a slack rod carries nothing at the limit",
              factor_of(square, 0.2, held, pushed(-1.)).forces.in_links[0],
              1e-9);
  // The push P = mu / f + T.
  LoadFactorControls controls;
  const FactorAnswerOf<Scene> strength = find_strength_factor(
      linked(square, 0.2, held, pushed(0.35)), controls, Terminal::silent());
  check_factor("strengths may be divided, but not that of the rod",
               *strength.factor, 0.2 / (0.35 - 0.25), 1e-8);
  const Scene pulled = linked(square, 0.2, held, pushed(0.44));
  InterfaceForces taut = state_of(pulled);
  check_error("a taut one balances", certify(pulled, taut).error(), 1e-12);
  check("within its bounds", taut.in_links[0] > 0.239);

  taut.in_links[0] = 0.3;
  check_error("beyond them it is seen by how much",
              std::abs(certify(pulled, taut).admissibility_violation -
                       0.05 / pulled.load[0].norm()),
              1e-12);
  taut.in_links[0] = std::numeric_limits<double>::quiet_NaN();
  check("and if it is no number",
        std::isinf(certify(pulled, taut).admissibility_violation));
  try
  {
    check_can_be_sampled(pulled);
    check("is not sampled", false);
  }
  catch (const InputError &error)
  {
    std::cout << error.what() << std::endl;
  }
}

/**
 * Columns of 1 x 2 and a beam of 4 x 1 on them: pushed to the right they turn
 * about their toes by theta, and the beam goes by (2, 1) theta.
 */
void portal()
{
  write_file("portal.wkt", "POLYGON((0 0, 1 0, 1 2, 0 2, 0 0))\n"
                           "POLYGON((3 0, 4 0, 4 2, 3 2, 3 0))\n"
                           "POLYGON((0 2, 4 2, 4 3, 0 3, 0 2))\n");
  const Packing<2> frame = on_ground(Packing<2>(imported_cells("portal.wkt")));
  const std::vector<CellForce> push = {{"cell 2", {2}, Point<2>(1., 0.)}};
  check_factor("a portal", factor_of(frame, 5., {}, push), 3.);
  const double T = 0.7;
  check_factor("a portal with a stay",
               factor_of(frame, 5.,
                         ties(frame, {"set From = cell 2 at 0, 2.5\nset To = "
                                      "ground at -2, 0.5\nset Yield force = " +
                                      digits(T)}),
                         push),
               3. + T * 3. / std::sqrt(2.) / 2.);
}

/**
 * The least and the greatest thrust H of an arch on smooth supports: at the
 * crown it acts at some height h, and the line of thrust is within each joint,
 * above its inner end (x, y) and below its outer one, where with the weight W
 * of what lies between, at w,
 *
 *     H (h - y) >= W (x - w)  and  <=.
 *
 * In H and H h these are half planes, whose corners are tried.
 */
std::pair<double, double> thrusts(const Packing<2> &arch)
{
  const unsigned int n = arch.n_cells();
  std::vector<std::array<double, 3>> half_planes; // a H + b H h <= c
  double W = 0., Ww = 0.;
  for (unsigned int c = n / 2 - 1; c < n; ++c)
  {
    if (c >= n / 2)
    {
      W += arch.area(c);
      Ww +=
          arch.area(c) * (arch.centre(c) + area_moments(arch, c).centroid())[0];
    }
    for (const auto &i : arch.interfaces())
      if (i.cell_minus == c && i.cell_plus == c + 1)
      {
        const bool starts_inside = i.start.norm() < i.end.norm();
        const auto &inside = starts_inside ? i.start : i.end;
        const auto &outside = starts_inside ? i.end : i.start;
        half_planes.push_back({{inside[1], -1., Ww - W * inside[0]}});
        half_planes.push_back({{-outside[1], 1., W * outside[0] - Ww}});
      }
  }
  double least = 1e9, greatest = 0.;
  for (const auto &p : half_planes)
    for (const auto &q : half_planes)
    {
      const double d = p[0] * q[1] - p[1] * q[0];
      if (std::abs(d) < 1e-12)
        continue;
      const double H = (p[2] * q[1] - p[1] * q[2]) / d;
      const double Hh = (p[0] * q[2] - p[2] * q[0]) / d;
      bool is_inside = true;
      for (const auto &r : half_planes)
        is_inside &= r[0] * H + r[1] * Hh <= r[2] + 1e-12;
      if (!is_inside)
        continue;
      least = std::min(least, H);
      greatest = std::max(greatest, H);
    }
  return {least, greatest};
}

void arch()
{
  for (const auto &[n, thickness] :
       {std::pair(20U, 0.15), {40U, 0.2}, {40U, 0.1075}})
  {
    Packing<2> ring = on_ground(semicircle(n, thickness));
    const auto tie =
        ties(ring, {"set From = cell 0 at -1, 0\nset To = cell " +
                    std::to_string(n - 1) + " at 1, 0\nset Yield force = 10"});
    Scene scene = linked(ring, 5., tie);
    const auto &interfaces = scene.packing.interfaces();
    for (unsigned int e = 0; e < interfaces.size(); ++e)
      if (interfaces[e].cell_plus == scene.packing.ground())
        scene.coefficient[e] = 0.;
    const std::string name = text(n, " voussoirs, ", thickness, " thick");
    const auto [least, greatest] = thrusts(ring);
    for (const RangeMethod method :
         {RangeMethod::simplex, RangeMethod::interior_point})
    {
      const Ranges ranges = find_ranges(
          scene,
          {std::vector<bool>(interfaces.size(), false), false, method, true},
          Terminal::silent());
      check_error(name + ": the least thrust",
                  std::abs(ranges.links[0].least / least - 1.), 1e-8);
      check_error(name + ": the greatest",
                  std::abs(ranges.links[0].greatest / greatest - 1.), 1e-8);
    }
    scene.links[0].most = (1. - 1e-6) * least;
    const DiscreteProblem problem = discretise(scene);
    SolverParameters parameters{ProcessGroup()};
    dealii::ParameterHandler prm;
    parameters.add_parameters(prm);
    prm.parse_input_from_string("");
    check(name + ": with less it collapses",
          parameters.formulation_for(scene)
              .solve(problem, parameters.controls(), Terminal::silent())
              .mechanism.has_value());
  }
}

/** What a tie does to the stress of a block, and a scene with it as a load. */
void stress()
{
  const Packing<2> tower = on_ground(wall(4, 1));
  const auto links =
      ties(tower, {"set From = cell 3 at 0.9, 0.9\nset To = ground at 1.6, "
                   "0\nset Yield force = 1\nset Prestress = 0.3",
                   "set From = cell 0 at 0.2, 0.1\nset To = cell 2\nset Yield "
                   "force = 1\nset Compressive strength = 0.1"});
  const Scene scene = linked(tower, 1., links);
  const InterfaceForces forces = state_of(scene);
  check_error("a tower balances", certify(scene, forces).error(), 1e-12);
  const Scene loaded = loaded_by_links(scene, forces);
  InterfaceForces of_joints = forces;
  of_joints.in_links.clear();
  check_error("so it does with ties as loads",
              certify(loaded, of_joints).error(), 1e-12);
  const auto means = cell_mean_stresses(scene, forces);
  double skew = 0.;
  for (const auto &mean : means)
    skew = std::max(skew, std::abs(mean[0][1] - mean[1][0]));
  check_error("mean stresses are symmetric", skew, 1e-12);

  const std::string given = "set Yield force = 0.3\nset Prestress = 0.3\n";
  const Packing<2> square = on_ground(wall(1, 1));
  const Scene stretched = linked(
      square, 1.,
      ties(square,
           {given + "set From = cell 0 at 0.1, 0.5\nset To = ground at -1, 0.5",
            given +
                "set From = cell 0 at 0.9, 0.5\nset To = ground at 2, 0.5"}));
  const InterfaceForces of_both = state_of(stretched);
  check_error("two ties stretch what is between them",
              std::abs(cell_mean_stresses(stretched, of_both)[0][0][0] - 0.24),
              1e-12);
}

void refused()
{
  const Packing<2> pair = on_ground(wall(2, 1));
  for (
      const char *const entries :
      {"set From = 0.5, 0.5\nset To = ground at 3, 0\nset Yield force = 1",
       "set From = 7, 0.2\nset To = ground at 3, 0\nset Yield force = 1",
       "set From = cell 0\nset To = cell 0 at 0.1, 0.1\nset Yield force = 1",
       "set From = ground at 0, 0\nset To = ground at 1, 0\nset Yield force = "
       "1",
       "set From = cell 0\nset To = cell 1",
       "set From = cell 0\nset To = ground",
       "set From = cell 0 at 0\nset To = cell 1\nset Yield force = 1",
       "set From = cell 0 at 0.1, 0.5\nset To = cell 1 at 0.1, 0.5\nset Yield "
       "force = 1",
       "set From = block\nset To = ground at 3, 0\nset Yield force = 1",
       "set From = cell 9\nset To = cell 1\nset Yield force = 1",
       "set From = cell 0\nset To = cell 1\nset Yield force = 1\nset Prestress "
       "= 2",
       "set From = cell 0\nset To = cell 1\nset Yield force = 1\nset Prestress "
       "= 1\nset Compressive strength = 1"})
    show_refusal([&] { ties(pair, {entries}); });
}

void run()
{
  block();
  portal();
  arch();
  stress();
  refused();
}

const RoomTest test("ties", run);
} // namespace test_ties
