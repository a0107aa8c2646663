// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/generators/bay_crown.h>

namespace Voussoir
{
using dealii::Point;

namespace
{
unsigned int web_before(const unsigned int web)
{
  return (web + n_webs - 1) % n_webs;
}
} // namespace

BayCrown::BayCrown(const HalfArch &arch, const BayPlaces &places)
    : places(places), has_ridge(arch.apex.has_value())
{
  const ArchJoint &joint = arch.joints.back();
  inner = {-joint.intrados[0], joint.intrados[1]};
  outer = {-joint.extrados[0], joint.extrados[1]};
  inner_top = {0., inner[1]};
  outer_top = {0., has_ridge ? (*arch.apex)[1] : outer[1]};
}

BayPlaces::Loop BayCrown::section(const unsigned int web,
                                  const double out) const
{
  BayPlaces::Loop loop = {places.place(web, Flank::right, inner, out),
                          places.place(web, Flank::left, inner, out),
                          places.place(web, Flank::left, outer, out)};
  if (has_ridge)
    loop.push_back(places.place(web, Flank::left, outer_top, out));
  loop.push_back(places.place(web, Flank::right, outer, out));
  return loop;
}

BlockFaces BayCrown::keystone(const double out) const
{
  const auto cross = [&](const Point<2> &p) {
    BayPlaces::Loop loop;
    for (unsigned int web = 0; web < n_webs; ++web)
      loop.insert(loop.end(), {places.place(web, Flank::right, p, out),
                               places.place(web, Flank::left, p, out),
                               places.on_groin(web, p)});
    return loop;
  };
  BlockFaces block;
  for (unsigned int web = 0; web < n_webs; ++web)
    add_arm(block, web, out);
  const BayPlaces::Loop intrados = cross(inner);
  block.add({intrados.rbegin(), intrados.rend()});
  if (!has_ridge)
    block.add(cross(outer));
  return block;
}

BlockFaces BayCrown::quarter(const unsigned int web, const double out) const
{
  const auto outline = [&](const Point<2> &p,
                           const Point<2> &middle) -> BayPlaces::Loop {
    return {places.place(web, Flank::right, p, out),
            places.place(web, Flank::left, p, out), places.on_groin(web, p),
            places.on_groin(web, middle), places.on_groin(web_before(web), p)};
  };
  const BayPlaces::Loop lower = outline(inner, inner_top);
  const BayPlaces::Loop upper = outline(outer, outer_top);
  BlockFaces block;
  add_arm(block, web, out);
  for (const unsigned int i : {2, 3}) // in the planes of the groins
    block.add({lower[i], lower[i + 1], upper[i + 1], upper[i]});
  block.add({lower.rbegin(), lower.rend()});
  if (!has_ridge)
    block.add(upper);
  return block;
}

void BayCrown::add_arm(BlockFaces &block,
                       const unsigned int web,
                       const double out) const
{
  const Point<3> left = places.place(web, Flank::left, outer, out);
  const Point<3> right = places.place(web, Flank::right, outer, out);
  const Point<3> left_groin = places.on_groin(web, outer);
  const Point<3> right_groin = places.on_groin(web_before(web), outer);
  block.add(section(web, out));
  block.add({places.place(web, Flank::left, inner, out),
             places.on_groin(web, inner), left_groin, left});
  block.add({places.on_groin(web_before(web), inner),
             places.place(web, Flank::right, inner, out), right, right_groin});
  if (!has_ridge)
    return;
  const Point<3> ridge = places.place(web, Flank::left, outer_top, out);
  const Point<3> top = places.on_groin(web, outer_top);
  block.add({ridge, left, left_groin, top});
  block.add({right, ridge, top, right_groin});
}
} // namespace Voussoir
