// SPDX-License-Identifier: LGPL-2.1-or-later

// A program with a formulation of its own: of all states that carry a load, the
// mean of two others. The set of states is convex, so that it carries the load,
// too, which the certificate confirms.

#include <voussoir/analyses/state/answer.h>
#include <voussoir/scene/scene_parameters.h>
#include <voussoir/statics/energy/least_energy.h>
#include <voussoir/statics/paper/analytic_centre.h>

using namespace Voussoir;

class MeanOfTwo : public Formulation
{
public:
  std::string name() const override { return "mean of two"; }
  std::string meaning() const override { return "the mean of two states."; }
  std::string selection() const override
  {
    return "the mean of the least energy and the analytic centre";
  }

private:
  Solution select(const DiscreteProblem &problem,
                  const SolverControls &controls,
                  Terminal &terminal) const override
  {
    Solution mean = LeastEnergy().solve(problem, controls, terminal);
    if (mean.mechanism)
      return mean;
    const Solution centre = AnalyticCentre().solve(problem, controls, terminal);
    for (std::size_t k = 0; k < mean.forces.size(); ++k)
      mean.forces[k] = 0.5 * (mean.forces[k] + centre.forces[k]);
    return mean;
  }
};

int main()
{
  SceneParameters parameters;
  dealii::ParameterHandler prm;
  parameters.add_parameters(prm, {});
  prm.parse_input_from_string(
      "subsection Packing\n subsection Voronoi\n"
      "  set Number of points = 50\n end\nend\n"
      "subsection Loads\n set Traction = -nx; -ny\nend\n"
      "subsection Friction\n set Strength = 1\nend\n");
  Terminal terminal(std::cout, 0);
  const Scene scene = parameters.scene_of(
      parameters.data(parameters.read_packing(".", terminal), false, terminal));
  SolverRecord record;
  dealii::TimerOutput timer(std::cout, dealii::TimerOutput::never,
                            dealii::TimerOutput::wall_times);
  const Answer answer =
      analyse(scene, MeanOfTwo(), {}, record, timer, terminal);
  const Carried &found = std::get<Carried>(answer);
  std::cout << record.selection << ": " << found.status.word() << '\n';
  return found.certificate.error() < 1e-8 ? 0 : 1;
}
