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

namespace
{
void write_vector(std::ostream &out, const dealii::Tensor<1, 3> &v)
{
  for (unsigned int d = 0; d < 3; ++d)
    out << ',' << v[d];
}
} // namespace

void write_interface_points_csv(std::ostream &out, const SpaceAnswer &answer)
{
  const FaceForces &forces = answer.forces;
  const auto &points = answer.scene.blocks->points;
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "interface,pressure,share,x,y,z"
      << (forces.empty() ? "" : ",force_x,force_y,force_z") << '\n';
  for (unsigned int e = 0; e < points.size(); ++e)
  {
    unsigned int k = forces.empty() ? 0 : forces.first[e];
    for (const bool presses : {true, false})
      for (const FacePoint &point :
           presses ? points[e].pressure : points[e].friction)
      {
        out << e << ',' << presses << ',' << point.share;
        write_vector(out, point.place);
        // Without a strength the points of friction have no forces.
        if (!forces.empty())
          write_vector(out, k < forces.first[e + 1] ? forces.list[k++].force
                                                    : dealii::Tensor<1, 3>());
        out << '\n';
      }
  }
}
} // namespace Voussoir
