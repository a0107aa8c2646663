// SPDX-License-Identifier: LGPL-2.1-or-later

// Verification 1 and 2 (Marazzato and Venkataramani): four squares and four
// triangles that meet in a point, under the uniform stress S = -[[1,1],[1,1]].
// The forces are those of S, f_e = |e| S n_e, with either kind of contact.

#include "tests.h"

using namespace Voussoir;

void verify(const std::string &name,
            const std::vector<dealii::Point<2>> &points,
            const std::string &contact)
{
  const auto S = tensor(-1, -1, -1, -1);
  PointList list;
  list.points = points;
  const Scene scene =
      scene_under_stress(Packing(voronoi_cells(list, {{0, 0}, {1, 1}})), 10, S);
  const InterfaceForces forces = Solver(contact).forces(scene);

  double error = 0.;
  for (unsigned int e = 0; e < forces.normal.size(); ++e)
  {
    const auto &i = scene.packing.interfaces()[e];
    error = std::max(
        error, (forces.on_cell_minus(i, e) / i.length - S * i.normal).norm());
  }
  std::cout << name << ", " << contact << ": " << forces.normal.size()
            << " interfaces" << std::endl;
  check_error("  error of the tractions", error, 1e-9);
  check_error("  equilibrium", certify(scene, forces).equilibrium_residual,
              1e-9);
  check_error("  admissibility", certify(scene, forces).admissibility_violation,
              1e-9);
}

int main()
{
  for (const std::string &contact : {compliant, hard})
  {
    verify("verification 1",
           {{0.25, 0.25}, {0.25, 0.75}, {0.75, 0.25}, {0.75, 0.75}}, contact);
    verify("verification 2",
           {{0.5, 1. / 6}, {0.5, 5. / 6}, {1. / 6, 0.5}, {5. / 6, 0.5}},
           contact);
  }
}
