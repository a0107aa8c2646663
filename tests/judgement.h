// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_tests_judgement_h
#define voussoir_tests_judgement_h

#include <voussoir/stress/cell_means.h>

#include "tests.h"

// How a run would end, for scenes at the extremes: with forces that the
// certificate accepts, with a collapse that is proven, or with a refusal.

enum class Verdict
{
  carried,
  collapse,
  refused
};

struct Judgement
{
  Verdict verdict = Verdict::refused;
  /** If carried: the forces in the units of the scene. */
  Voussoir::InterfaceForces forces;
  /** Certificate::error(). */
  double error = 0.;
  /** If refused: the message. */
  std::string message;
};

/**
 * Whether its forces can be compared with those of another run. The linear
 * program has any, which depend on the version of Ipopt.
 */
inline bool selects_a_state(const Method &method)
{
  return method.name != linear_program.name;
}

/** What the program does with the outcome of a formulation. */
inline Judgement judge(const Voussoir::Scene &scene, const Method &method)
{
  using namespace Voussoir;
  Judgement judgement;
  try
  {
    const DiscreteProblem problem = discretise(scene);
    const Solution found = Solver(method).solve(problem);
    if (found.mechanism)
    {
      const MechanismCertificate proof = certify_mechanism(
          scene, dimensional_motion(discretise(scene), *found.mechanism));
      if (proves_collapse(proof))
        judgement.verdict = Verdict::collapse;
      else
        judgement.message = "The proof is not accepted.";
      return judgement;
    }
    judgement.forces = dimensional_forces(problem, found);
    const Certificate certificate = certify(scene, judgement.forces);
    judgement.error = certificate.error();
    if (judgement.error <= largest_accepted_error)
      judgement.verdict = Verdict::carried;
    else
      judgement.message = "The certificate finds " +
                          std::to_string(judgement.error) + ": " +
                          found.stop.words() + ".";
  }
  catch (const InputError &error)
  {
    judgement.message = error.what();
  }
  catch (const SolverError &error)
  {
    judgement.message = error.what();
  }
  return judgement;
}

/**
 * How far the mean over the packing of the mean stresses of the cells is from
 * S: by the divergence theorem it is S for all forces that balance the
 * tractions S n.
 */
inline double error_of_mean(const Voussoir::Scene &scene,
                            const Voussoir::InterfaceForces &forces,
                            const dealii::Tensor<2, 2> &S)
{
  const auto means = Voussoir::cell_mean_stresses(scene, forces);
  dealii::Tensor<2, 2> sum;
  for (unsigned int c = 0; c < means.size(); ++c)
    sum += scene.packing.area(c) / scene.packing.area() * means[c];
  const double error = (sum - S).norm() / S.norm();
  return std::isfinite(error) ? error : 1e300;
}

/** The largest of some errors of one kind; a NaN is taken for 1e300. */
struct Worst
{
  double error = 0.;

  void add(const double value)
  {
    error = std::max(error, std::isfinite(value) ? value : 1e300);
  }
};

#endif
