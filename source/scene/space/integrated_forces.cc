// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/face_triangles.h>
#include <voussoir/scene/space/integrated_forces.h>

#include <utility>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

void add_integral(const SimplexIntegral &integral,
                  const unsigned int cell,
                  SpaceLoads &loads)
{
  const IntegratedForce of(integral);
  loads.force[cell] += of.force;
  loads.torque[cell] += of.torque;
  loads.first_moment[cell] += of.first_moment;
  loads.size[cell] += integral.size;
}

void add_warnings(std::vector<std::string> &warnings,
                  const Inaccuracies &inaccuracies)
{
  for (std::string &warning : inaccuracies.warnings())
    warnings.push_back(std::move(warning));
}

void add_body_force(const Packing<3> &packing,
                    const std::vector<unsigned int> &cells,
                    const VectorExpression &b,
                    const std::string &parameter,
                    SpaceLoads &loads,
                    std::vector<std::string> &warnings)
{
  if (b.is_zero())
    return;
  Inaccuracies inaccuracies(parameter, largest_error_in_space);
  const CellFaces &mesh = packing.polyhedra();
  for (const unsigned int c : cells)
  {
    const Point<3> &centre = packing.centre(c);
    const Point<3> &centroid = packing.moments(c).centroid;
    const std::string where =
        text(", in cell ", c, "; a force must be finite.");
    const ForceDensity density(b, centre, {}, where);
    if (b.is_constant())
    {
      IntegratedValues values;
      density(centroid, values);
      loads.add(c,
                packing.volume(c) *
                    Tensor<1, 3>({values[0], values[1], values[2]}),
                centroid - centre);
      continue;
    }
    // Tetrahedra from the centroid, which count as holes where they are.
    SimplexIntegral sum;
    for (unsigned int f = mesh.first_face[c]; f < mesh.first_face[c + 1]; ++f)
      for (const auto &triangle : triangles_of(mesh, f))
      {
        std::vector<Point<3>> corners = {centroid};
        for (const unsigned int k : triangle)
          corners.push_back(mesh.vertex(f, k));
        SimplexIntegral part = integral_over_simplex(corners, density);
        const double volume =
            cross_product_3d(corners[2] - corners[1], corners[3] - corners[1]) *
            (corners[1] - centroid);
        if (volume < 0.)
          for (double &value : part.values)
            value = -value;
        sum.add(part);
      }
    inaccuracies.look_at(sum.error, sum.size, 0.,
                         [&] { return text("in cell ", c); });
    add_integral(sum, c, loads);
  }
  add_warnings(warnings, inaccuracies);
}
} // namespace Voussoir
