// SPDX-License-Identifier: LGPL-2.1-or-later

// What is said of the load: that it is carried, only if it is. A light part
// that slides on, under or beside one with loads up to 1e13 times as large is
// found; what has a state is never called a collapse; and close to the limit
// the word is never wrong.

#include <voussoir/analyses/state/assess.h>

#include "polygons.h"
#include "tests.h"

namespace test_status_words
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

Status::Kind status_of(const Scene &scene, const Method &method)
{
  try
  {
    const DiscreteProblem problem = discretise(scene);
    const Solution solution = Solver(method).solve(problem);
    if (solution.mechanism)
      return proves_collapse(certify_mechanism(
                 scene,
                 dimensional_motion(discretise(scene), *solution.mechanism)))
                 ? Status::Kind::collapse
                 : Status::Kind::carried_within;
    const InterfaceForces forces = dimensional_forces(problem, solution);
    const Assessment found =
        assess(scene, forces, certify(scene, forces), Terminal::silent());
    if (!found.mechanism.displacement.empty() &&
        !proves_collapse(certify_mechanism(scene, found.mechanism)))
      std::cout << "FAILED: a mechanism that proves nothing" << std::endl;
    return found.status.kind;
  }
  catch (const SolverError &)
  {
    return Status::Kind::carried_within; // it says that there is no answer
  }
}

struct Block
{
  /** The load on it. */
  Tensor<1, 2> load;
  /** The strength of the joint below. */
  double strength;
};

Tensor<1, 2> force(const double x, const double y)
{
  Tensor<1, 2> f;
  f[0] = x;
  f[1] = y;
  return f;
}

Scene pile(const std::vector<Block> &blocks)
{
  Packing<2> packing = stack_of_squares(blocks.size());
  std::vector<bool> supports;
  for (const Packing<2>::BoundaryEdge &edge : packing.boundary_edges())
    supports.push_back(edge.midpoint()[1] < 0.1);
  packing.support(supports);
  std::vector<double> strengths;
  for (const Packing<2>::Interface &i : packing.interfaces())
    strengths.push_back(blocks[std::lround(i.midpoint()[1])].strength);
  Loads loads;
  loads.traction.resize(packing.boundary_edges().size());
  loads.body = BodyForce(packing, [=](const Point<2> &x, unsigned int) {
    return blocks[static_cast<unsigned int>(x[1])].load;
  });
  return Scene(std::move(packing), strengths, std::move(loads));
}

/** Light parts of @p light that resist @p resistance times what pushes them. */
std::vector<Scene> light_parts(const double light, const double resistance)
{
  const double s = resistance * light;
  const Tensor<1, 2> weight = force(0., -1.), push = force(light, -light);
  const Tensor<1, 2> none;
  return {// on a heavy block
          pile({{weight, 10.}, {push, s}}),
          // under one
          pile({{push, 0.5 * s}, {weight, 0.5 * s}}),
          // between two
          pile({{weight, 10.}, {push, 0.5 * s}, {weight, 0.5 * s}}),
          // on an unloaded block, which slides with it on a heavy one
          pile({{weight, 10.}, {none, s}, {push, 10.}}),
          // on an unloaded block that stays
          pile({{weight, 10.}, {none, 10.}, {push, s}}),
          // under the light one the heavy one, and under it the light one again
          pile({{push, 3. * s}, {weight, 10.}, {push, s}})};
}

/** Eight grains of a square, all of it under a uniform stress. */
Scene grains(const double strength)
{
  CellLoops cells;
  cells.vertices = {{10.0, 3.6908116947445517},
                    {10.412743294053053, 3.6300207739520225},
                    {10.518584049417537, 3.742667720261338},
                    {10.57062787161213, 4.0},
                    {10.0, 4.0},
                    {10.462723486368034, 3.0},
                    {10.56991333015253, 3.0},
                    {10.46672099430093, 3.4118022878813568},
                    {10.243100213683393, 3.2717488753934862},
                    {10.21407108693194, 3.0},
                    {10.052192956378315, 3.234652090334938},
                    {11.0, 3.6943229795916164},
                    {11.0, 4.0},
                    {10.0, 3.0},
                    {10.0, 3.2742606819055435},
                    {10.467125215152087, 3.5093041896365107},
                    {11.0, 3.3892389909910303},
                    {11.0, 3.0}};
  const std::vector<std::vector<unsigned int>> loops = {
      {0, 1, 2, 3, 4},    {5, 6, 7, 8},      {9, 5, 8, 10},
      {2, 11, 12, 3},     {13, 9, 10, 14},   {14, 10, 8, 7, 15, 1, 0},
      {15, 16, 11, 2, 1}, {6, 17, 16, 15, 7}};
  for (const auto &loop : loops)
  {
    cells.loops.insert(cells.loops.end(), loop.begin(), loop.end());
    cells.first.push_back(cells.loops.size());
  }
  return scene_under_stress(Packing<2>(cells), strength,
                            tensor(-0.832732290223203, -0.010278597588870175,
                                   -0.010278597588870175, -1.0108444140902197));
}

/** By what the two scenes are below and above their limits. */
void check_near_limit(const std::string &what,
                      const Method &method,
                      const Scene &below,
                      const Scene &above)
{
  check(what + ", " + method.name + ": below the limit not solved",
        status_of(below, method) != Status::Kind::solved);
  check(what + ", " + method.name + ": above it no collapse",
        status_of(above, method) != Status::Kind::collapse);
}

void run()
{
  const std::vector<Method> ways = {least_energy,   compliant, hard,
                                    linear_program, centre,    centre_equal};
  for (const double light :
       {1., 1e-4, 1e-6, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13})
    for (const Method &method : ways)
    {
      unsigned int n_wrong = 0, n_vague = 0;
      for (const double resistance : {0.5, 2.})
      {
        const auto scenes = light_parts(light, resistance);
        for (const Scene &scene : scenes)
        {
          const Status::Kind kind = status_of(scene, method);
          const Status::Kind right =
              resistance < 1. ? Status::Kind::collapse : Status::Kind::solved;
          n_vague += kind == Status::Kind::carried_within;
          n_wrong += kind != right && kind != Status::Kind::carried_within;
        }
      }
      std::ostringstream name;
      name << "light parts of " << light << ", " << method.name;
      check(name.str() + ": no wrong word", n_wrong == 0);
      // Below, and where the centre has lost its digits, it may be left open.
      if (light >= 1e-10 && method.formulation != centre.formulation)
        check(name.str() + ": a word for each", n_vague == 0);
    }

  // The wall is carried from a strength of one on; the limit of the grains is
  // a strength of limit (1 + 1e-8).
  const double limit = 0.016775105177451635;
  for (const Method &method : ways)
  {
    for (const double off : {1e-5, 1e-6, 1e-7, 1e-8})
    {
      std::ostringstream name;
      name << "wall, " << off << " off the limit";
      check_near_limit(name.str(), method, shear_wall(1. - off),
                       shear_wall(1. + off));
    }
    check_near_limit("grains", method, grains(limit),
                     grains(limit * (1. + 1e-6)));
  }

  // Forces that are balanced to a loose tolerance only say so.
  const Scene loose = scene_under_stress(random_packing(200, 5), 0.3,
                                         tensor(-0.6, 0., 0., -1.4));
  const DiscreteProblem problem = discretise(loose);
  const InterfaceForces forces =
      dimensional_forces(problem, Solver(least_energy, 1e-2).solve(problem));
  const Certificate certificate = certify(loose, forces);
  const Assessment found =
      assess(loose, forces, certificate, Terminal::silent());
  check("loose tolerance: carried to within the residual",
        found.status.kind == Status::Kind::carried_within &&
            found.status.within ==
                std::max(certificate.equilibrium_residual,
                         certificate.admissibility_violation) &&
            found.status.within > largest_accepted_error);
}

const RoomTest test("status_words", run);
} // namespace test_status_words
