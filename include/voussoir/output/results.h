// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_results_h
#define voussoir_output_results_h

#include <voussoir/statics/certificate.h>
#include <voussoir/statics/scene.h>
#include <voussoir/stress/reconstruction.h>

#include <map>
#include <string>
#include <vector>

namespace Voussoir
{
/** All that a run found, in the user's units; what the writers write. */
struct Results
{
  explicit Results(const Scene &scene) : scene(scene)
  {
  }

  const Scene &scene;

  std::string title;
  std::string formulation;
  std::string selection;
  /** "solved". */
  std::string status;
  unsigned int n_iterations = 0;
  unsigned int n_evaluations = 0;

  InterfaceForces forces;
  std::vector<dealii::Tensor<1, 2>> displacement;
  Certificate certificate;
  std::vector<double> torques;
  std::vector<dealii::Tensor<2, 2>> mean_stresses;
  StressField stress;

  /** Wall clock time of each stage, in seconds. */
  std::map<std::string, double> timings;
};
} // namespace Voussoir

#endif
