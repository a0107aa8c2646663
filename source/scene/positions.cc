// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/scene/positions.h>

#include <utility>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/** Where a rigid body has @p x that goes by u at a centre and turns. */
Point<2> moved(const Point<2> &x,
               const Point<2> &centre,
               const Tensor<1, 2> &u,
               const double angle)
{
  return centre + u + rotation_by(angle) * (x - centre);
}

/** The loads of a scene whose cells have turned. */
Loads moved_loads(const Scene &at_rest, const Positions &positions)
{
  Loads loads;
  loads.traction = at_rest.traction;
  loads.traction_moment = at_rest.traction_moment;
  // Forces at places are spread in the body force, and are put there anew.
  const Packing<2> &packing = at_rest.packing;
  BodyForce spread = at_rest.body;
  loads.on_cells = at_rest.on_cells;
  for (CellForce &of : loads.on_cells)
    if (of.place)
    {
      const unsigned int c = of.cells.front();
      spread.add(packing, c, -of.force, *of.place);
      of.place = positions.of(packing, c, *of.place);
    }
    else
      for (const unsigned int c : of.cells)
        spread.add(packing, c, -of.force);
  loads.body = spread.turned(positions.angle);
  return loads;
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
  return moved(x, packing.centre(cell), displacement[cell], angle[cell]);
}

Point<2> Positions::of_ground(const Packing<2> &packing,
                              const unsigned int interface,
                              const Point<2> &x) const
{
  if (of_supports.empty())
    return x;
  const unsigned int first = packing.interfaces().size() - packing.n_supports();
  const SupportMotion &of = of_supports[interface - first];
  return moved(x, packing.interfaces()[interface].midpoint(), of.displacement,
               of.rotation);
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
  for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
  {
    const Packing<2>::Interface &i = packing.interfaces()[e];
    std::array<Tensor<1, 2>, 2> apart;
    Tensor<1, 2> along;
    for (unsigned int k = 0; k < 2; ++k)
    {
      const Point<2> &x = k == 0 ? i.start : i.end;
      const Point<2> minus = positions.of(packing, i.cell_minus, x);
      const Point<2> plus = i.cell_plus == packing.ground()
                                ? positions.of_ground(packing, e, x)
                                : positions.of(packing, i.cell_plus, x);
      apart[k] = plus - minus;
      along += (k == 0 ? -1. : 1.) * (minus + 0.5 * apart[k]);
    }
    along /= along.norm();
    const Tensor<1, 2> normal({along[1], -along[0]});
    joints.push_back({{{apart[0] * normal, apart[1] * normal}},
                      0.5 * ((apart[0] + apart[1]) * along)});
  }
  return joints;
}

Packing<2> moved_packing(const Packing<2> &at_rest, const Positions &positions)
{
  return at_rest.moved(
      [&](const unsigned int c, const Point<2> &x) {
        return positions.of(at_rest, c, x);
      },
      [&](const unsigned int e, const Point<2> &x) {
        return positions.of_ground(at_rest, e, x);
      });
}

Scene moved_scene(const Scene &at_rest,
                  const Positions &positions,
                  std::vector<std::array<bool, 2>> open_ends,
                  const Scene *const live,
                  const double factor)
{
  Loads loads = moved_loads(at_rest, positions);
  if (live != nullptr)
    loads.add(factor, moved_loads(*live, positions));
  Scene scene(moved_packing(at_rest.packing, positions), at_rest.strength,
              std::move(loads), *at_rest.kinematics,
              moved_links(at_rest, positions));
  scene.coefficient = at_rest.coefficient;
  scene.dilates = at_rest.dilates;
  scene.friction_law = at_rest.friction_law;
  scene.tensile_strength = at_rest.tensile_strength;
  scene.compressive_strength = at_rest.compressive_strength;
  scene.open_ends = std::move(open_ends);
  return scene;
}
} // namespace Voussoir
