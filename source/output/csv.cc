// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/csv.h>

#include <cmath>
#include <ostream>

namespace Voussoir
{
namespace
{
/** All but the end of the line. */
template <typename First, typename... Others>
void write_row(std::ostream &out, const First &first, const Others &...others)
{
  out << first;
  ((out << ',' << others), ...);
}

/** The number of cell c+ of an interface: of the ground, -1. */
int number_of_plus(const Packing &packing, const Packing::Interface &interface)
{
  return interface.cell_plus == packing.ground() ? -1 : interface.cell_plus;
}
} // namespace

void write_interfaces_csv(std::ostream &out, const Results &results)
{
  use_all_digits(out);
  const bool marked = !results.never_pressed.empty();
  out << "cell_minus,cell_plus,x0,y0,x1,y1,nx,ny,length,normal_force,"
         "tangential_force,strength,utilisation"
      << (marked ? ",never_pressed,always_sliding\n" : "\n");
  const Scene &scene = results.scene;
  for (unsigned int e = 0; e < scene.packing.interfaces().size(); ++e)
  {
    const Packing::Interface &i = scene.packing.interfaces()[e];
    write_row(out, i.cell_minus, number_of_plus(scene.packing, i), i.start[0],
              i.start[1], i.end[0], i.end[1], i.normal[0], i.normal[1],
              i.length, results.forces.normal[e], results.forces.tangential[e],
              scene.strength[e], utilisation(scene, results.forces, e));
    if (marked)
      out << ',' << results.never_pressed[e] << ','
          << results.always_sliding[e];
    out << '\n';
  }
}

void write_cells_csv(std::ostream &out, const Results &results)
{
  use_all_digits(out);
  out << "id,x,y,area,load_x,load_y,ux,uy,torque,sxx,sxy,syx,syy,group\n";
  const Packing &packing = results.scene.packing;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    const dealii::Tensor<2, 2> &s = results.mean_stresses[c];
    write_row(out, c, packing.centre(c)[0], packing.centre(c)[1],
              packing.area(c), results.scene.load[c][0],
              results.scene.load[c][1], results.displacement[c][0],
              results.displacement[c][1], results.torques[c], s[0][0], s[0][1],
              s[1][0], s[1][1], packing.group_name(c));
    out << '\n';
  }
}

void write_mechanism_csv(std::ostream &out, const Collapse &collapse)
{
  use_all_digits(out);
  out << "id,x,y,load_x,load_y,ux,uy,group\n";
  const Scene &scene = collapse.scene;
  for (unsigned int c = 0; c < scene.packing.n_cells(); ++c)
  {
    const dealii::Point<2> &x = scene.packing.centre(c);
    const dealii::Tensor<1, 2> &F = scene.load[c];
    const dealii::Tensor<1, 2> &u = collapse.displacement[c];
    write_row(out, c, x[0], x[1], F[0], F[1], u[0], u[1],
              scene.packing.group_name(c));
    out << '\n';
  }
}

void write_mechanism_joints_csv(std::ostream &out, const Collapse &collapse)
{
  use_all_digits(out);
  out << "cell_minus,cell_plus,nx,ny,length,strength,opening,sliding,"
         "dissipation\n";
  const Scene &scene = collapse.scene;
  for (unsigned int e = 0; e < scene.packing.interfaces().size(); ++e)
  {
    const Packing::Interface &i = scene.packing.interfaces()[e];
    dealii::Tensor<1, 2> jump = -collapse.displacement[i.cell_minus];
    if (i.cell_plus != scene.packing.ground())
      jump += collapse.displacement[i.cell_plus];
    write_row(out, i.cell_minus, number_of_plus(scene.packing, i), i.normal[0],
              i.normal[1], i.length, scene.strength[e], jump * i.normal,
              jump * i.tangent(),
              scene.strength[e] * i.length * std::abs(jump * i.tangent()));
    out << '\n';
  }
}
} // namespace Voussoir
