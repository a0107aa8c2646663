// SPDX-License-Identifier: LGPL-2.1-or-later

// Means over edges: tractions and strengths that are polynomials along an edge
// are averaged exactly; uniform stress gives S n; bad values are refused.

#include <voussoir/statics/friction.h>
#include <voussoir/statics/loads.h>

#include "tests.h"

using namespace Voussoir;

std::vector<dealii::Tensor<1, 2>> tractions(const Packing &packing,
                                            const std::string &settings)
{
  LoadParameters loads;
  dealii::ParameterHandler prm;
  loads.add_parameters(prm);
  prm.parse_input_from_string("subsection Loads\n" + settings + "\nend\n");
  return loads.tractions(packing);
}

std::vector<double> strengths(const Packing &packing,
                              const std::string &strength)
{
  FrictionParameters friction;
  dealii::ParameterHandler prm;
  friction.add_parameters(prm);
  prm.parse_input_from_string(
      "subsection Friction\nset Strength = " + strength + "\nend\n");
  return friction.strengths(packing);
}

/** The mean of x^2 over the edge from a to b. */
double mean_square(const double a, const double b)
{
  return (a * a + a * b + b * b) / 3.;
}

int main()
{
  const Packing packing = random_packing(100, 1);

  const auto g = tractions(packing, "set Traction = x^2 * nx; y^2 - ny");
  double error = 0.;
  for (unsigned int b = 0; b < g.size(); ++b)
  {
    const auto &edge = packing.boundary_edges()[b];
    error =
        std::max({error,
                  std::abs(g[b][0] - mean_square(edge.start[0], edge.end[0]) *
                                         edge.normal[0]),
                  std::abs(g[b][1] - mean_square(edge.start[1], edge.end[1]) +
                           edge.normal[1])});
  }
  check_error("mean of a quadratic traction", error, 1e-14);

  const auto S_n = tractions(
      packing, "set Boundary load = uniform stress\nset Stress = 1, 2; 2, -5");
  error = 0.;
  for (unsigned int b = 0; b < S_n.size(); ++b)
    error = std::max(error, (S_n[b] - tensor(1, 2, 2, -5) *
                                          packing.boundary_edges()[b].normal)
                                .norm());
  check_error("uniform stress", error, 1e-15);

  const auto s = strengths(packing, "1 + x^2");
  error = 0.;
  for (unsigned int e = 0; e < s.size(); ++e)
    error =
        std::max(error, std::abs(s[e] - 1. -
                                 mean_square(packing.interfaces()[e].start[0],
                                             packing.interfaces()[e].end[0])));
  check_error("mean of a quadratic strength", error, 1e-14);

  const Packing courses = wall(4, 3);
  const auto by_kind = strengths(courses, "abs(ny) > 0.5 ? 1 : 0.2");
  bool right = true;
  for (unsigned int e = 0; e < by_kind.size(); ++e)
  {
    const bool bed = courses.interfaces()[e].normal[1] > 0.5;
    right &= std::abs(by_kind[e] - (bed ? 1. : 0.2)) < 1e-15;
  }
  check("bed and head joints of different strength", right);

  const Packing bricks = wall(2, 1);
  show_refusal([&] { strengths(bricks, "-1"); });
  show_refusal([&] { strengths(bricks, "sqrt(0.25 - x)"); });
  show_refusal([&] { strengths(bricks, "1 +"); });
  show_refusal([&] { tractions(bricks, "set Traction = 1/(y-1); 0"); });
  show_refusal([&] { tractions(bricks, "set Traction = u; 0"); });
  show_refusal([&] {
    tractions(bricks, "set Boundary load = uniform stress\n"
                      "set Stress = 1, 2; 3, 4");
  });
}
