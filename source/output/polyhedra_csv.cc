// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/csv_table.h>
#include <voussoir/output/fields/force_points.h>
#include <voussoir/output/fields/polyhedra.h>
#include <voussoir/output/polyhedra_csv.h>

#include <ostream>

namespace Voussoir
{
void write_interfaces_csv(std::ostream &out, const SpaceResults &answer)
{
  write_table(out, face_interface_fields().columns(answer),
              answer.scene.packing().interfaces().size());
}

void write_boundary_csv(std::ostream &out, const SpaceResults &answer)
{
  write_table(out, boundary_face_fields().columns(answer),
              answer.scene.packing().boundary_faces().size());
}

void write_cells_csv(std::ostream &out, const SpaceResults &answer)
{
  write_table(out, polyhedron_fields().columns(answer),
              answer.scene.packing().polyhedra().n_cells());
}

void write_interface_points_csv(std::ostream &out, const SpaceResults &answer)
{
  const ForcePoints points(answer);
  write_table(out, force_point_fields().columns(points), points.list.size());
}
} // namespace Voussoir
