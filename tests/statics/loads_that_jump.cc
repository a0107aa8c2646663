// SPDX-License-Identifier: LGPL-2.1-or-later

// Loads and strengths that jump, on a block on the ground: what must slide
// slides, what must be carried is, and reactions, torques and strengths are
// those by hand. Tractions on lines are clipped to edges to rounding, with
// their first moments. What cannot be integrated exactly is a warning.

#include <voussoir/base/text.h>
#include <voussoir/contact/friction_parameters.h>
#include <voussoir/scene/loads/loads.h>
#include <voussoir/scene/loads/segment_tractions.h>
#include <voussoir/scene/supports.h>
#include <voussoir/stress/cell_means.h>

#include "tests.h"
#include <iomanip>

namespace test_loads_that_jump
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

/** No force on one interface. */
InterfaceForces no_force()
{
  InterfaceForces forces;
  forces.normal = forces.tangential = {0.};
  return forces;
}

/** The unit square on the ground. */
Packing<2> block_on_ground()
{
  Packing<2> packing = wall(1, 1);
  packing.support(boundary_edges_where(packing, "y < 1e-9", "Supports/Where"));
  return packing;
}

Loads loads_on(const Packing<2> &packing, const std::string &settings)
{
  LoadParameters loads;
  dealii::ParameterHandler prm;
  loads.add_parameters(prm);
  prm.parse_input_from_string("subsection Loads\n" + settings + "\nend\n");
  return loads.loads(packing);
}

Strengths strengths_of(const Packing<2> &packing, const std::string &strength)
{
  FrictionParameters friction;
  dealii::ParameterHandler prm;
  friction.add_parameters(prm);
  prm.parse_input_from_string(
      "subsection Friction\nset Strength = " + strength + "\nend\n");
  return friction.strengths(packing);
}

/** The block with one strength at its base. */
Scene block(const double strength, const std::string &settings)
{
  Packing<2> packing = block_on_ground();
  Loads loads = loads_on(packing, settings);
  return Scene(std::move(packing), {strength}, std::move(loads));
}

bool is_carried(const Scene &scene)
{
  const DiscreteProblem problem = discretise(scene);
  return !Solver(least_energy).solve(problem).mechanism;
}

void check_load(const std::string &what,
                const Scene &scene,
                const double F_x,
                const double F_y,
                const double torque)
{
  const InterfaceForces none = no_force();
  check_error(what + ": force",
              (scene.load[0] - Tensor<1, 2>({F_x, F_y})).norm(), 1e-13);
  check_error(what + ": torque",
              std::abs(residual_torques(scene, none)[0] - torque), 1e-13);
}

void check_sliding()
{
  // A strip load between the points of any rule of few points.
  const std::string strip =
      "set Body force = 0; -1\nset Traction = (y > 1-1e-9 && x > 0.27 && x < "
      "0.43) ? 10 : 0; 0";
  check_load("strip load", block(1., strip), 1.6, -1., -0.8);
  check("strip load: slides on a base of strength 1",
        !is_carried(block(1., strip)) && !is_carried(block(1.599999, strip)));
  check("strip load: is carried by 1.600001",
        is_carried(block(1.600001, strip)));
  const std::string same = "set Body force = 0; -1\nset Segment tractions = "
                           "0.27, 1 to 0.43, 1: 10, 0";
  check_load("the same on a line", block(1., same), 1.6, -1., -0.8);
  check("the same on a line: slides", !is_carried(block(1.599999, same)) &&
                                          is_carried(block(1.600001, same)));

  const Scene pressed =
      block(1., "set Body force = 0; -1\n"
                "set Traction = 0; (ny > 0.5 && x < 0.52) ? -10 : 0");
  check_load("one jump", pressed, 0., -6.2, 5.2 * 0.24);
  const InterfaceForces reaction = Solver(least_energy).forces(pressed);
  check_error("one jump: reaction", std::abs(reaction.normal[0] + 6.2), 1e-12);
}

void check_body_forces()
{
  check_load("a body force in the upper half",
             block(1., "set Body force = 0; (y > 0.5) ? -1 : 0"), 0., -0.5, 0.);
  check_load("a body force in a corner",
             block(1., "set Body force = 0; (x > 0.9 && y > 0.8) ? -50 : 0"),
             0., -1., -0.45);
  check_load("a body force in a disc",
             block(1.,
                   "set Body force = (x-0.75)^2 + (y-0.25)^2 < 0.01 ? 100 : "
                   "0; 0"),
             dealii::numbers::PI, 0., 0.25 * dealii::numbers::PI);
  const double e = std::exp(10.);
  // The moment about y = 1/2 of -exp(10 y) along y has no torque; along x it
  // has.
  check_error("exp(10 y)",
              std::abs(block(1., "set Body force = 0; -exp(10*y)").load[0][1] +
                       (e - 1.) / 10.),
              1e-9);
  const Scene sheared = block(1., "set Body force = exp(10*y); 0");
  const double torque = -((0.5 * e + 0.5) / 10. - (e - 1.) / 100.);
  check_error("exp(10 y): torque",
              std::abs(residual_torques(sheared, no_force())[0] - torque),
              1e-9);
  // A peak of the integral pi that a point of the rule meets on its flank.
  const Scene peaked = block(1., "set Body force = 0; "
                                 "-1e8*exp(-((x-0.5)^2+(y-0.16662)^2)/1e-8)");
  check_error("a peak", std::abs(peaked.load[0][1] + dealii::numbers::PI),
              1e-11);
  check_load("sin(20 x)", block(1., "set Body force = sin(20*x); 0"),
             (1. - std::cos(20.)) / 20., 0., 0.);
}

void check_strength()
{
  const Packing<2> packing = block_on_ground();
  const Strengths found = strengths_of(packing, "x > 0.37 ? 0.5 : 1.5");
  check_error("a strength that jumps", std::abs(found.of_interface[0] - 0.87),
              1e-14);
  check("without a warning", found.warnings.empty());
}

void check_segments()
{
  // A pressure of water on the left side of a block from 0.2 to 1.7 high, and
  // its resultant at a third of its height.
  const Scene dam =
      block(9., "set Segment tractions = 0, 0.9 to 0, 0.3: 0, 0 to 6, 0");
  check_load("water", dam, 1.8, 0., -1.8 * (0.5 - 0.5));
  const Scene deep = block(
      9., "set Segment tractions = 0, 1 to 0, 0: 0, 0 to 6, 0; 0, 1 to 1, "
          "1: 0, -3");
  check_load("water and a load", deep, 3., -3., 3. * (0.5 - 1. / 3.));
  const auto mean = cell_mean_stresses(deep, no_force())[0];
  // The integrals of g_x x and g_y y over the boundary, from the middle.
  check_error("water and a load: mean stress",
              std::max(std::abs(mean[0][0] + 1.5), std::abs(mean[1][1] + 1.5)),
              1e-14);
  check_error("water and a load: shear",
              std::abs(mean[0][1] - 3. * (1. / 3. - 0.5)), 1e-14);

  // A line over many edges of a wall, with ends inside edges.
  const Packing<2> courses = wall(3, 5, 2., 1.);
  const auto on_line = loads_on(
      courses, "set Segment tractions = 0.111, 1 to 1.777, 1: 1, -2 to 3, -6");
  const auto by_expression = loads_on(
      courses, "set Traction = (y > 0.9999 && ny > 0.5 && x > 0.111 && x < "
               "1.777) ? 1 + 2*(x - 0.111)/1.666 : 0; (y > 0.9999 && ny > 0.5 "
               "&& x > 0.111 && x < 1.777) ? -2 - 4*(x - 0.111)/1.666 : 0");
  double error = 0.;
  Tensor<1, 2> total;
  for (unsigned int b = 0; b < on_line.traction.size(); ++b)
  {
    error = std::max(
        {error, (on_line.traction[b] - by_expression.traction[b]).norm(),
         (on_line.traction_moment[b] - by_expression.traction_moment[b])
             .norm()});
    total += courses.boundary_edges()[b].length * on_line.traction[b];
  }
  check_error("a line and the same as an expression", error, 1e-13);
  check_error("its sum", (total - 1.666 * Tensor<1, 2>({2., -4.})).norm(),
              1e-13);

  const auto of_few_digits = loads_on(
      courses, "set Segment tractions = 0.1, 1.0000001 to 2.000001, 1: 0, -1");
  double sum = 0.;
  for (unsigned int b = 0; b < courses.boundary_edges().size(); ++b)
    sum += courses.boundary_edges()[b].length * of_few_digits.traction[b][1];
  check_error("all of a load of which the ends have few digits",
              std::abs(sum + 1.900001), 1e-12);

  // A short line on a long edge, askew by the last digit of its ends.
  const Packing<2> turned = turned_squares(3);
  const Packing<2>::BoundaryEdge &edge = turned.boundary_edges()[0];
  const Tensor<1, 2> along = edge.end - edge.start;
  const Tensor<1, 2> askew = 5e-7 * edge.length * edge.normal;
  const Point<2> start = edge.start + 0.4 * along;
  const Point<2> end = edge.start + 0.402 * along + askew;
  const auto short_line = loads_on(
      turned, text(std::setprecision(16), "set Segment tractions = ", start[0],
                   ", ", start[1], " to ", end[0], ", ", end[1], ": 0, -1"));
  check_error("a short line on a long edge",
              std::abs(short_line.traction[0][1] / 0.002 + 1.), 1e-6);

  const Packing<2> on_ground = block_on_ground();
  for (const char *const bad :
       {"0.5, 1 to 1.5, 1: 0, -1", "0, 0.5 to 1, 0.5: 0, -1",
        "0, 0 to 1, 0: 0, -1", "0, 1 to 1, 1", "0, 1 to 1: 0, -1",
        "0, 1 to 1, 1: 0, nan", "0, 1 to 0, 1: 0, 1", "0, 1; 1, 1: 0, 1"})
    show_refusal([&] {
      loads_on(on_ground, std::string("set Segment tractions = ") + bad);
    });
  const std::string blanks(1000000, ' ');
  check("far apart",
        segment_tractions_of_text(
            "0, 1" + blanks + "to" + blanks + "1, 1: 0, -1", "here")[0]
                .end == Point<2>(1., 1.));
}

void check_warnings()
{
  // Rounding decides on which side of 0.1 + 0.2 the joint at 0.3 is.
  const Packing<2> courses = wall(10, 1);
  for (const std::string &warning :
       strengths_of(courses, "y < 0.1 + 0.2 ? 1 : 2").warnings)
    std::cout << warning << std::endl;
  check("none where the jump is beside it",
        strengths_of(courses, "y < 0.3 + 1e-9 ? 1 : 2").warnings.empty());
  const Packing<2> packing = block_on_ground();
  for (const char *const settings :
       {"set Traction = 0; ny > 0.5 ? x*sin(1/x) : 0",
        "set Traction = 0; y > 1 - 1e-16 ? 1 : 0"})
    for (const std::string &warning : loads_on(packing, settings).warnings)
      std::cout << warning << std::endl;
  show_refusal([&] { loads_on(packing, "set Traction = 0; sin(1e9*x)"); });
  show_refusal([&] { loads_on(packing, "set Body force = 0; sin(1e7*x)"); });
}

void run()
{
  check_sliding();
  check_body_forces();
  check_strength();
  check_segments();
  check_warnings();
}

const RoomTest test("loads_that_jump", run);
} // namespace test_loads_that_jump
