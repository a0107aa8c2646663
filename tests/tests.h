// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_tests_tests_h
#define voussoir_tests_tests_h

#include <voussoir/analyses/state/solver_parameters.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/packing/generators/arch.h>
#include <voussoir/packing/generators/wall.h>
#include <voussoir/packing/voronoi/voronoi.h>
#include <voussoir/scene/proofs/certificate.h>
#include <voussoir/scene/scene.h>
#include <voussoir/statics/problem/discretise.h>
#include <voussoir/terminal/terminal.h>

#include "room.h"
#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <sstream>

// What the tests share. A test computes a closed form or a property and says
// "OK"; small residuals are judged here, since numdiff takes whatever is below
// 1e-6 for zero.

/** As the program, so do the tests trap invalid operations in Debug. */
inline const bool invalid_operations_are_trapped =
    Voussoir::trap_invalid_operations();

/** One property: print OK, or FAILED. */
inline void check(const std::string &what, const bool holds)
{
  std::cout << what << ": " << (holds ? "OK" : "FAILED") << std::endl;
}

/** One error: print OK if it is at most @p bound (so not if it is NaN). */
inline void
check_error(const std::string &what, const double error, const double bound)
{
  std::cout << what << " <= " << bound << ": ";
  if (error <= bound)
    std::cout << "OK" << std::endl;
  else
    std::cout << "FAILED with " << error << std::endl;
}

/** Print what @p action throws as InputError, or that it throws nothing. */
inline void show_refusal(const std::function<void()> &action)
{
  try
  {
    action();
    std::cout << "FAILED: nothing was thrown" << std::endl;
  }
  catch (const Voussoir::InputError &error)
  {
    std::cout << error.what() << std::endl;
  }
}

/** A number with digits enough to be read back as it is. */
inline std::string digits(const double x)
{
  std::ostringstream out;
  out.precision(17);
  out << x;
  return out.str();
}

/** All digits in brackets, for a formula. */
inline std::string bracketed(const double x)
{
  return '(' + digits(x) + ')';
}

namespace Voussoir
{
/** Voronoi cells in a rectangle. */
inline CellLoops voronoi_cells(const PointList<2> &generators,
                               const Rectangle &rectangle)
{
  return voronoi_cells(generators, ConvexPolygon(rectangle));
}
} // namespace Voussoir

inline Voussoir::Packing<2>
random_packing(const unsigned int n,
               const unsigned int seed,
               const Voussoir::Rectangle &rectangle = {{0., 0.}, {1., 1.}})
{
  return Voussoir::Packing<2>(
      voronoi_cells(Voussoir::random_points(n, seed, rectangle), rectangle));
}

inline dealii::Tensor<2, 2>
tensor(const double xx, const double xy, const double yx, const double yy)
{
  dealii::Tensor<2, 2> S;
  S[0][0] = xx;
  S[0][1] = xy;
  S[1][0] = yx;
  S[1][1] = yy;
  return S;
}

/** A running bond wall from the names and values of its parameters. */
inline Voussoir::Packing<2> wall(const unsigned int n_courses,
                                 const unsigned int n_bricks,
                                 const double width = 1.,
                                 const double height = 1.)
{
  Voussoir::WallGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.set("Courses", static_cast<long int>(n_courses));
  prm.set("Bricks per course", static_cast<long int>(n_bricks));
  prm.set("Width", width);
  prm.set("Height", height);
  return Voussoir::Packing<2>(
      generator.generate("", Voussoir::Terminal::silent()));
}

/** Unit squares on top of each other, from y = 0 on. */
inline Voussoir::Packing<2> stack_of_squares(const unsigned int n)
{
  Voussoir::CellLoops cells;
  for (unsigned int k = 0; k <= n; ++k)
  {
    cells.vertices.emplace_back(0., k);
    cells.vertices.emplace_back(1., k);
  }
  for (unsigned int k = 0; k < n; ++k)
  {
    for (const unsigned int v : {2 * k, 2 * k + 1, 2 * k + 3, 2 * k + 2})
      cells.loops.push_back(v);
    cells.first.push_back(cells.loops.size());
  }
  return Voussoir::Packing<2>(cells);
}

/** The packing with supports along y = 0. */
inline Voussoir::Packing<2> on_ground(Voussoir::Packing<2> packing)
{
  std::vector<bool> rests;
  for (const auto &edge : packing.boundary_edges())
    rests.push_back(edge.midpoint()[1] < 1e-9);
  packing.support(rests);
  return packing;
}

/** A scene with one strength everywhere, under the tractions g(x, n). */
template <typename Traction>
Voussoir::Scene
scene_with(Voussoir::Packing<2> packing,
           const double strength,
           const Traction &g,
           const Voussoir::Kinematics &kinematics = Voussoir::translations())
{
  std::vector<dealii::Tensor<1, 2>> tractions;
  for (const auto &edge : packing.boundary_edges())
    tractions.push_back(g(edge.midpoint(), edge.normal));
  std::vector<double> strengths(packing.interfaces().size(), strength);
  return Voussoir::Scene(std::move(packing), strengths, {tractions, {}, {}},
                         kinematics);
}

/** A scene with one strength everywhere, under the tractions S n. */
inline Voussoir::Scene scene_under_stress(
    Voussoir::Packing<2> packing,
    const double strength,
    const dealii::Tensor<2, 2> &S,
    const Voussoir::Kinematics &kinematics = Voussoir::translations())
{
  return scene_with(
      std::move(packing), strength,
      [&](const dealii::Point<2> &, const dealii::Tensor<1, 2> &n) {
        return S * n;
      },
      kinematics);
}

/** A scene under a body force, with the coefficient of friction @p mu. */
inline Voussoir::Scene under_weight(
    Voussoir::Packing<2> packing,
    const double strength,
    const double mu,
    const Voussoir::Kinematics &kinematics,
    const dealii::Tensor<1, 2> &force = dealii::Tensor<1, 2>({0., -1.}))
{
  Voussoir::Loads loads;
  loads.traction.resize(packing.boundary_edges().size());
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    loads.body.add(packing, c, packing.area(c) * force);
  const unsigned int n = packing.interfaces().size();
  Voussoir::Scene scene(std::move(packing), std::vector<double>(n, strength),
                        loads, kinematics);
  if (mu > 0.)
    scene.coefficient.assign(n, mu);
  return scene;
}

/**
 * A block of weight 1 on ground that holds it, beside a smooth wall on its
 * right, which crush it at a stress of 4.
 */
inline Voussoir::Scene crushing_beside_smooth_wall()
{
  Voussoir::Packing<2> packing = wall(1, 1);
  std::vector<bool> rests;
  for (const auto &edge : packing.boundary_edges())
    rests.push_back(edge.normal[1] < -0.5 || edge.normal[0] > 0.5);
  packing.support(rests);
  Voussoir::Scene scene = under_weight(packing, 10., 0., Voussoir::rotations());
  const auto &interfaces = scene.packing.interfaces();
  scene.compressive_strength.assign(interfaces.size(), 4.);
  for (unsigned int e = 0; e < interfaces.size(); ++e)
    scene.strength[e] *= interfaces[e].normal[1] < -0.5;
  return scene;
}

/** The straight-sided voussoirs of a semicircle of mean radius 1. */
inline Voussoir::Packing<2> semicircle(const unsigned int n,
                                       const double thickness)
{
  Voussoir::ArchGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.set("Mean radius", 1.);
  prm.set("Thickness", thickness);
  prm.set("Voussoirs", static_cast<long int>(n));
  return Voussoir::Packing<2>(
      generator.generate("", Voussoir::Terminal::silent()));
}

/** The shear wall of 12 courses of 6 bricks: +1 along the top, -1 below. */
inline Voussoir::Scene shear_wall(const double strength,
                                  const double width = 1.,
                                  const double height = 1.)
{
  return scene_with(
      wall(12, 6, width, height), strength,
      [](const dealii::Point<2> &, const dealii::Tensor<1, 2> &n) {
        dealii::Tensor<1, 2> g;
        g[0] = n[1];
        return g;
      });
}

/** n^2 / 2 squares, the points of a lattice turned by 45 degrees. */
inline Voussoir::Packing<2> turned_squares(const int n)
{
  Voussoir::PointList<2> list;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      if ((i + j) % 2 == 0)
        list.points.emplace_back((i + 0.5) / n, (j + 0.5) / n);
  return Voussoir::Packing<2>(voronoi_cells(list, {{0, 0}, {1, 1}}));
}

/** A formulation with settings "set Entry = value" of its own subsection. */
struct Method
{
  std::string name;
  std::string formulation;
  std::string settings;

  Method with(const std::string &setting) const
  {
    return {name, formulation, settings + "\n" + setting};
  }
};

inline const Method compliant = {"compliant", "smoothed friction",
                                 "set Contact = compliant"};
inline const Method hard = {"hard", "smoothed friction", "set Contact = hard"};
inline const Method linear_program = {"linear program", "linear program", ""};
inline const Method least_energy = {"least energy", "least energy", ""};
inline const Method centre = {"analytic centre", "analytic centre",
                              "set Barrier weights = edge area"};
inline const Method centre_equal = {"analytic centre, equal weights",
                                    "analytic centre",
                                    "set Barrier weights = equal"};
inline const std::vector<Method> all_methods = {
    compliant, hard, linear_program, least_energy, centre, centre_equal};

/** One way to solve, with a tolerance, and settings of the section Solver. */
struct Solver
{
  explicit Solver(
      const Method &method,
      const double tolerance = 1e-10,
      const std::string &settings = "",
      const Voussoir::ProcessGroup &processes = Voussoir::ProcessGroup())
      : parameters(processes), quiet(nowhere, 0)
  {
    parameters.add_parameters(prm);
    std::ostringstream input;
    input << "set Formulation = " << method.formulation
          << "\nsubsection Solver\nset Tolerance = " << tolerance << "\n"
          << settings << "\nsubsection " << method.formulation << "\n"
          << method.settings << "\nend\nend\n";
    prm.parse_input_from_string(input.str());
  }

  Voussoir::Solution solve(const Voussoir::DiscreteProblem &problem)
  {
    return parameters.formulation().solve(problem, parameters.controls(),
                                          quiet);
  }

  /** The forces in the units of the scene. */
  Voussoir::InterfaceForces forces(const Voussoir::Scene &scene)
  {
    const Voussoir::DiscreteProblem problem = discretise(scene);
    return dimensional_forces(problem, solve(problem));
  }

  dealii::ParameterHandler prm;
  Voussoir::SolverParameters parameters;
  std::ostringstream nowhere;
  Voussoir::Terminal quiet;
};

/** The largest difference of two sets of forces. */
inline double distance(const Voussoir::InterfaceForces &a,
                       const Voussoir::InterfaceForces &b)
{
  double largest = 0.;
  for (unsigned int e = 0; e < a.normal.size(); ++e)
    largest = std::max({largest, std::abs(a.normal[e] - b.normal[e]),
                        std::abs(a.tangential[e] - b.tangential[e])});
  for (unsigned int e = 0; e < std::min(a.at_ends.size(), b.at_ends.size());
       ++e)
    for (unsigned int k = 0; k < 2; ++k)
      largest = std::max(largest, std::abs(a.at_ends[e][k] - b.at_ends[e][k]));
  return largest;
}

/** The largest difference of the tractions from those of the stress S. */
inline double distance_from_uniform(const Voussoir::Scene &scene,
                                    const Voussoir::InterfaceForces &forces,
                                    const dealii::Tensor<2, 2> &S)
{
  double largest = 0.;
  for (unsigned int e = 0; e < forces.normal.size(); ++e)
  {
    const auto &i = scene.packing.interfaces()[e];
    largest = std::max(
        largest, (forces.on_cell_minus(i, e) / i.length - S * i.normal).norm());
  }
  return largest;
}

#endif
