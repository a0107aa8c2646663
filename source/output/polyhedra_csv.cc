// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/csv_table.h>
#include <voussoir/output/fields/polyhedra.h>
#include <voussoir/output/polyhedra_csv.h>

#include <limits>
#include <ostream>

namespace Voussoir
{
void write_interfaces_csv(std::ostream &out, const SpaceAnswer &answer)
{
  write_table(out, face_interface_fields().columns(answer),
              answer.scene.packing().interfaces().size());
}

void write_boundary_csv(std::ostream &out, const Packing<3> &packing)
{
  write_table(out, boundary_face_fields().columns(packing),
              packing.boundary_faces().size());
}

void write_cells_csv(std::ostream &out, const SpaceAnswer &answer)
{
  write_table(out, polyhedron_fields().columns(answer),
              answer.scene.packing().polyhedra().n_cells());
}

void write_corner_forces_csv(std::ostream &out, const FaceForces &forces)
{
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "interface,x,y,z,force_x,force_y,force_z\n";
  for (unsigned int e = 0; e + 1 < forces.first.size(); ++e)
    for (unsigned int k = forces.first[e]; k < forces.first[e + 1]; ++k)
    {
      out << e;
      for (unsigned int i = 0; i < 3; ++i)
        out << ',' << forces.list[k].place[i];
      for (unsigned int i = 0; i < 3; ++i)
        out << ',' << forces.list[k].force[i];
      out << '\n';
    }
}
} // namespace Voussoir
