// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/csv.h>
#include <voussoir/output/csv_table.h>
#include <voussoir/output/fields/tables.h>

namespace Voussoir
{
void write_interfaces_csv(std::ostream &out, const Results &results)
{
  write_table(out, interface_fields().columns(results),
              results.scene.packing.interfaces().size());
}

void write_boundary_csv(std::ostream &out, const Results &results)
{
  write_table(out, boundary_fields().columns(results.scene),
              results.scene.packing.boundary_edges().size());
}

void write_cells_csv(std::ostream &out, const Results &results)
{
  write_table(out, cell_fields().columns(results),
              results.scene.packing.n_cells());
}

void write_mechanism_csv(std::ostream &out,
                         const Scene &scene,
                         const Motion &motion,
                         const LiveLoads *const live)
{
  const MovingScene moving(scene, motion, live);
  write_table(out, mechanism_fields().columns(moving), scene.packing.n_cells());
}

void write_mechanism_joints_csv(std::ostream &out,
                                const Scene &scene,
                                const Motion &motion)
{
  const MovingScene moving(scene, motion);
  write_table(out, mechanism_joint_fields().columns(moving),
              scene.packing.interfaces().size());
}

void write_capacity_csv(std::ostream &out, const Results &results)
{
  const CapacityCurve &curve = *results.data<CapacityCurve>();
  write_table(out, capacity_fields().columns(curve), curve.points.size());
}

void write_links_csv(std::ostream &out, const Results &results)
{
  write_table(out, link_fields().columns(results), results.scene.links.size());
}

void write_mechanism_links_csv(std::ostream &out,
                               const Scene &scene,
                               const Motion &motion)
{
  const MovingScene moving(scene, motion);
  write_table(out, mechanism_link_fields().columns(moving), scene.links.size());
}
} // namespace Voussoir
