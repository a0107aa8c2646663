// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_tests_statics_space_scenes_h
#define voussoir_tests_statics_space_scenes_h

#include <voussoir/analyses/factors/load_factor.h>
#include <voussoir/analyses/factors/strength_factor.h>
#include <voussoir/packing/polyhedra/generators/dome.h>
#include <voussoir/packing/polyhedra/voronoi/random_points.h>
#include <voussoir/packing/polyhedra/voronoi/voronoi_cells.h>
#include <voussoir/scene/proofs/space_certificate.h>
#include <voussoir/scene/space/space_scene.h>
#include <voussoir/statics/energy/space_state.h>
#include <voussoir/statics/problem/discretise_space.h>

#include "cell_faces.h"
#include "tests.h"
#include <memory>

// Blocks in space under loads, for tests.

using Vector3 = dealii::Tensor<1, 3>;

/** The vector (x, y, z). */
inline Vector3 vector(const double x, const double y, const double z)
{
  Vector3 v;
  v[0] = x;
  v[1] = y;
  v[2] = z;
  return v;
}

/** Blocks with the same law everywhere, and body forces on them. */
struct SpaceCase
{
  /** Those on z = 0 rest there. */
  explicit SpaceCase(Voussoir::Packing<3> packing_in)
      : packing(std::move(packing_in))
  {
    support([](const auto &face) {
      return std::abs(face.centroid[2]) < 1e-9 && face.normal[2] < -0.5;
    });
  }

  /** Let free faces rest on the ground, too, by a predicate. */
  template <typename Predicate>
  void support(const Predicate &rests)
  {
    std::vector<bool> is_support;
    for (const auto &face : packing.boundary_faces())
      is_support.push_back(rests(face));
    packing.support(is_support);
  }

  /** @{ */
  /** The laws and the kinematics. */
  double strength = 0., mu = 0., tension = 0., crushing = 0.;
  bool turns = true, dilates = true;
  unsigned int n_cuts = 1;
  /** The strength of each interface instead, if there are any. */
  std::vector<double> strengths;
  /** @} */
  Voussoir::Packing<3> packing;

  std::shared_ptr<const Voussoir::SpaceBlocks> blocks() const
  {
    const std::size_t n = packing.interfaces().size();
    Voussoir::Strengths limits;
    limits.of_interface = strengths;
    limits.of_interface.resize(n, strength);
    limits.dilate = dilates;
    if (mu > 0.)
      limits.coefficient.assign(n, mu);
    if (tension > 0.)
      limits.tensile.assign(n, tension);
    if (crushing > 0.)
      limits.compressive.assign(n, crushing);
    return std::make_shared<const Voussoir::SpaceBlocks>(
        packing, limits,
        turns ? Voussoir::rotations_in_space()
              : Voussoir::translations_in_space(),
        n_cuts);
  }
};

/** The body force @p b on all blocks. */
inline Voussoir::SpaceLoads body_force(const Voussoir::Packing<3> &packing,
                                       const Vector3 &b)
{
  Voussoir::SpaceLoads loads(packing.n_cells());
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    loads.add(c, packing.volume(c) * b,
              packing.moments(c).centroid - packing.centre(c));
  return loads;
}

/** The tractions S n on the whole boundary. */
inline Voussoir::SpaceLoads tractions(const Voussoir::Packing<3> &packing,
                                      const dealii::Tensor<2, 3> &S)
{
  Voussoir::SpaceLoads loads(packing.n_cells());
  for (const auto &face : packing.boundary_faces())
    loads.add(face.cell, face.area * (S * face.normal),
              face.centroid - packing.centre(face.cell));
  return loads;
}

/** Both, the second one times a factor. */
inline Voussoir::SpaceLoads together(Voussoir::SpaceLoads a,
                                     const double factor,
                                     const Voussoir::SpaceLoads &b)
{
  a.add(factor, b);
  return a;
}

/** The Voronoi cells of random points in a box from the origin on. */
inline Voussoir::Packing<3> cells_in_box(const unsigned int n,
                                         const dealii::Point<3> &end,
                                         const unsigned int seed)
{
  using namespace Voussoir;
  const Box box{{0., 0., 0.}, end};
  return Packing<3>(
      voronoi_cells(random_points(n, seed, box), ConvexPolyhedron(box)));
}

/** A symmetric stress with entries up to one, less a pressure. */
inline dealii::Tensor<2, 3> random_stress(Voussoir::Random &random,
                                          const double pressure)
{
  dealii::Tensor<2, 3> S;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j <= i; ++j)
      S[i][j] = S[j][i] = 2. * random() - 1. - (i == j ? pressure : 0.);
  return S;
}

/**
 * Grains under the tractions of the uniform stress S, which their joints bear:
 * least energy gives it back in one step.
 */
inline void check_uniform_stress(const std::string &name,
                                 const SpaceCase &of,
                                 const dealii::Tensor<2, 3> &S)
{
  using namespace Voussoir;
  const SpaceScene scene(of.blocks(), tractions(of.packing, S));
  const DiscreteProblem problem = discretise(scene);
  const Solution solution = find_space_state(
      problem, {}, LinearSolver::automatic, Terminal::silent());
  const FaceForces forces = dimensional_forces(problem, scene, solution);
  double error = 0.;
  for (unsigned int e = 0; e < of.packing.interfaces().size(); ++e)
  {
    const auto &i = of.packing.interfaces()[e];
    const Vector3 force = forces.resultant(of.packing, e).force;
    error = std::max(error, (force / i.area - S * i.normal).norm());
  }
  check_error(name + ": tractions", error / S.norm(), 1e-9);
  check("  in one step", solution.n_iterations == 1);
}

/** The forces of least energy. */
inline Voussoir::FaceForces elastic_forces(const Voussoir::SpaceScene &scene)
{
  using namespace Voussoir;
  const DiscreteProblem problem = discretise(scene);
  return dimensional_forces(problem, scene,
                            find_space_state(problem, {},
                                             LinearSolver::automatic,
                                             Terminal::silent()));
}

/** The load factor with both proofs, each added up again. */
inline Voussoir::FactorOf<Voussoir::SpaceScene>
proven_factor(const std::string &name,
              const SpaceCase &of,
              const Voussoir::SpaceLoads &dead,
              const Voussoir::SpaceLoads &live,
              const bool greatest = true,
              const double largest_width = 1e-8)
{
  using namespace Voussoir;
  std::cout << name << std::endl;
  const auto blocks = of.blocks();
  const SpaceScene dead_scene(blocks, dead), live_scene(blocks, live);
  const auto answer =
      find_load_factor(dead_scene, live_scene, {greatest}, Terminal::silent());
  check("  a factor is carried", answer.factor.has_value());
  if (!answer.factor)
    return {};
  const FactorOf<SpaceScene> &found = *answer.factor;
  const SpaceScene at(blocks, together(dead, found.carried, live));
  check_error("  balance", certify(at, found.forces).error(), 1e-10);
  if (found.is_unbounded)
    return found;
  const FactorBound bound =
      bound_of_factor(dead_scene, live_scene, found.mechanism);
  check("  bound", bound.factor == found.bound &&
                       bound.closing_violation <= 1e-12 &&
                       (bound.live_work > 0.) == greatest);
  check_error("  width", found.width(), largest_width);
  return found;
}

/** proven_factor() against a closed form. */
inline void check_factor(const std::string &name,
                         const double expected,
                         const SpaceCase &of,
                         const Voussoir::SpaceLoads &dead,
                         const Voussoir::SpaceLoads &live,
                         const double error = 2e-9)
{
  const double found = proven_factor(name, of, dead, live).bound;
  check_error("  factor", std::abs(found / expected - 1.), error);
}

/**
 * The number by which the strengths may be divided, with both proofs, of which
 * that by forces is added up again.
 */
inline Voussoir::FactorOf<Voussoir::SpaceScene>
proven_strength_factor(const std::string &name,
                       const SpaceCase &of,
                       const Voussoir::SpaceLoads &loads)
{
  using namespace Voussoir;
  std::cout << name << std::endl;
  const SpaceScene scene(of.blocks(), loads);
  const auto answer = find_strength_factor(scene, {true}, Terminal::silent());
  check("  a factor is carried", answer.factor.has_value());
  if (!answer.factor)
    return {};
  const FactorOf<SpaceScene> &found = *answer.factor;
  const SpaceScene at = with_strengths_divided(scene, found.carried);
  check_error("  balance", certify(at, found.forces).error(), 1e-10);
  return found;
}

/** proven_strength_factor() against a closed form. */
inline void check_strength_factor(const std::string &name,
                                  const double expected,
                                  const SpaceCase &of,
                                  const Voussoir::SpaceLoads &loads)
{
  const auto found = proven_strength_factor(name, of, loads);
  check_error("  carried", std::abs(found.carried / expected - 1.), 1e-8);
  check_error("  and bound", std::abs(found.bound / expected - 1.), 1e-8);
}

/** A hemispherical dome of the mean radius one, of blocks in stack bond. */
inline Voussoir::CellFaces dome_cells(const unsigned int n_courses,
                                      const unsigned int n_sectors,
                                      const double thickness)
{
  Voussoir::DomeGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.set("Mean radius", 1.);
  prm.set("Thickness", thickness);
  prm.set("Embrace", 180.);
  prm.set("Courses", static_cast<long int>(n_courses));
  prm.set("Sectors", static_cast<long int>(n_sectors));
  prm.set("Bond", "stack");
  return generator.generate("", Voussoir::Terminal::silent());
}

/** That dome on the ground. */
inline SpaceCase dome(const unsigned int n_courses,
                      const unsigned int n_sectors,
                      const double thickness)
{
  return SpaceCase(
      Voussoir::Packing<3>(dome_cells(n_courses, n_sectors, thickness)));
}

/** Find the state of a scene or its collapse: "carried" or "collapse". */
inline std::string proven_verdict(const Voussoir::SpaceScene &scene)
{
  using namespace Voussoir;
  const DiscreteProblem problem = discretise(scene);
  const Solution solution = find_space_state(
      problem, {}, LinearSolver::automatic, Terminal::silent());
  if (solution.mechanism)
  {
    const SpaceMotion motion =
        dimensional_motion(problem, scene, solution.mechanism->u, 1.);
    return proves_collapse(certify_mechanism(scene, motion))
               ? "collapse"
               : "no proof of collapse";
  }
  const Certificate certificate =
      certify(scene, dimensional_forces(problem, scene, solution));
  return certificate.error() <= 1e-10 ? "carried" : "not balanced";
}

#endif
