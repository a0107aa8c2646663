// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_tests_statics_space_scenes_h
#define voussoir_tests_statics_space_scenes_h

#include <voussoir/analyses/factors/load_factor.h>
#include <voussoir/analyses/factors/strength_factor.h>
#include <voussoir/packing/polyhedra/generators/dome.h>
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
    std::vector<bool> at_foot;
    for (const auto &face : packing.boundary_faces())
      at_foot.push_back(std::abs(face.centroid[2]) < 1e-9 &&
                        face.normal[2] < -0.5);
    packing.support(at_foot);
  }

  /** @{ */
  /** The laws and the kinematics. */
  double strength = 0., mu = 0., tension = 0., crushing = 0.;
  bool turns = true, dilates = true;
  unsigned int n_cuts = 1;
  /** @} */
  Voussoir::Packing<3> packing;

  std::shared_ptr<const Voussoir::SpaceBlocks> blocks() const
  {
    const std::size_t n = packing.interfaces().size();
    Voussoir::Strengths strengths;
    strengths.of_interface.assign(n, strength);
    strengths.dilate = dilates;
    if (mu > 0.)
      strengths.coefficient.assign(n, mu);
    if (tension > 0.)
      strengths.tensile.assign(n, tension);
    if (crushing > 0.)
      strengths.compressive.assign(n, crushing);
    return std::make_shared<const Voussoir::SpaceBlocks>(
        packing, strengths,
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
  for (unsigned int c = 0; c < a.size.size(); ++c)
  {
    a.force[c] += factor * b.force[c];
    a.torque[c] += factor * b.torque[c];
    a.size[c] += std::abs(factor) * b.size[c];
  }
  return a;
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
