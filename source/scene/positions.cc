// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/scene/positions.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
Tensor<1, 2> turned(const Tensor<1, 2> &arm, const double angle)
{
  const double c = std::cos(angle), s = std::sin(angle);
  return Tensor<1, 2>({c * arm[0] - s * arm[1], s * arm[0] + c * arm[1]});
}

/**
 * The arm of a single force that has the torque of others about a point and
 * their virial, the sum of arm . force: these others turn with the cell as it
 * does.
 */
Tensor<1, 2>
arm_of(const Tensor<1, 2> &force, const double torque, const double virial)
{
  const double square = force.norm_square();
  if (!(square > 0.))
    return {};
  return (virial * force - torque * Tensor<1, 2>({-force[1], force[0]})) /
         square;
}

/** The loads inside the cells, where these have turned. */
BodyForce moved_body(const Scene &at_rest,
                     const Packing<2> &moved,
                     const Positions &positions)
{
  BodyForce body;
  if (at_rest.body.empty())
    return body;
  for (unsigned int c = 0; c < moved.n_cells(); ++c)
  {
    const Tensor<1, 2> force = at_rest.body.force(at_rest.packing, c);
    const Tensor<1, 2> arm =
        arm_of(force, at_rest.body.torque(c), trace(at_rest.body.moment(c)));
    body.add(moved, c, force,
             moved.centre(c) + turned(arm, positions.angle[c]));
  }
  return body;
}

std::vector<Link> moved_links(const Scene &at_rest, const Positions &positions)
{
  std::vector<Link> links = at_rest.links;
  for (Link &link : links)
  {
    link.on_minus =
        positions.of(at_rest.packing, link.cell_minus, link.on_minus);
    link.on_plus = link.is_of_fill ? Point<2>(link.on_minus + link.direction)
                                   : positions.of(at_rest.packing,
                                                  link.cell_plus, link.on_plus);
    if (!link.is_of_fill)
      link.direction =
          (link.on_plus - link.on_minus) / link.on_minus.distance(link.on_plus);
  }
  return links;
}
} // namespace

Point<2> Positions::of(const Packing<2> &packing,
                       const unsigned int cell,
                       const Point<2> &x) const
{
  if (cell == packing.ground())
    return x;
  const Point<2> &centre = packing.centre(cell);
  return centre + displacement[cell] + turned(x - centre, angle[cell]);
}

Positions Positions::advanced(const Motion &motion, const double step) const
{
  Positions further = *this;
  for (unsigned int c = 0; c < displacement.size(); ++c)
  {
    further.displacement[c] += step * motion.displacement[c];
    if (!motion.rotation.empty())
      further.angle[c] += step * motion.rotation[c];
  }
  return further;
}

std::vector<MovedJoint> moved_joints(const Packing<2> &packing,
                                     const Positions &positions)
{
  std::vector<MovedJoint> joints;
  for (const Packing<2>::Interface &i : packing.interfaces())
  {
    std::array<Tensor<1, 2>, 2> apart;
    Tensor<1, 2> along;
    for (unsigned int k = 0; k < 2; ++k)
    {
      const Point<2> &x = k == 0 ? i.start : i.end;
      const Point<2> minus = positions.of(packing, i.cell_minus, x);
      apart[k] = positions.of(packing, i.cell_plus, x) - minus;
      along += (k == 0 ? -1. : 1.) * (minus + 0.5 * apart[k]);
    }
    along /= along.norm();
    const Tensor<1, 2> normal({along[1], -along[0]});
    joints.push_back({{{apart[0] * normal, apart[1] * normal}},
                      0.5 * ((apart[0] + apart[1]) * along)});
  }
  return joints;
}

Scene moved_scene(const Scene &at_rest,
                  const Positions &positions,
                  std::vector<std::array<bool, 2>> open_ends)
{
  const Packing<2> &packing = at_rest.packing;
  Packing<2> moved =
      packing.moved([&](const unsigned int c, const Point<2> &x) {
        return positions.of(packing, c, x);
      });
  Loads loads;
  loads.traction = at_rest.traction;
  loads.traction_moment = at_rest.traction_moment;
  loads.body = moved_body(at_rest, moved, positions);
  Scene scene(std::move(moved), at_rest.strength, std::move(loads),
              *at_rest.kinematics, moved_links(at_rest, positions));
  scene.coefficient = at_rest.coefficient;
  scene.dilates = at_rest.dilates;
  scene.friction_law = at_rest.friction_law;
  scene.tensile_strength = at_rest.tensile_strength;
  scene.compressive_strength = at_rest.compressive_strength;
  scene.open_ends = std::move(open_ends);
  return scene;
}

Scene with_live_loads(Scene scene, const Scene &live, const double factor)
{
  for (unsigned int b = 0; b < scene.traction.size(); ++b)
  {
    scene.traction[b] += factor * live.traction[b];
    scene.traction_moment[b] += factor * live.traction_moment[b];
  }
  scene.body.add(factor, live.body);
  for (unsigned int c = 0; c < scene.load.size(); ++c)
  {
    scene.load[c] += factor * live.load[c];
    scene.load_size[c] += std::abs(factor) * live.load_size[c];
  }
  for (unsigned int c = 0; c < scene.load_torque.size(); ++c)
    scene.load_torque[c] += factor * live.load_torque[c];
  return scene;
}
} // namespace Voussoir
