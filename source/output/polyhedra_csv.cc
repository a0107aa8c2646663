// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/csv_table.h>
#include <voussoir/output/fields/polyhedra.h>
#include <voussoir/output/polyhedra_csv.h>

namespace Voussoir
{
void write_interfaces_csv(std::ostream &out, const Packing<3> &packing)
{
  write_table(out, face_interface_fields().columns(packing),
              packing.interfaces().size());
}

void write_boundary_csv(std::ostream &out, const Packing<3> &packing)
{
  write_table(out, boundary_face_fields().columns(packing),
              packing.boundary_faces().size());
}

void write_cells_csv(std::ostream &out, const Packing<3> &packing)
{
  write_table(out, polyhedron_fields().columns(packing),
              packing.polyhedra().n_cells());
}
} // namespace Voussoir
