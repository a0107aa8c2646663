// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_generators_bay_places_h
#define voussoir_packing_polyhedra_generators_bay_places_h

#include <voussoir/packing/polyhedra/generators/block_builder.h>

#include <array>
#include <vector>

namespace Voussoir
{
/** A half of a web, which its crown divides, as seen from the middle. */
enum class Flank
{
  left, /**< counterclockwise of the crown as seen from above */
  right /**< clockwise of it */
};

/** The number of webs of a bay. */
constexpr unsigned int n_webs = 4;

/**
 * The places in a cross vault around the axis of z. Web 0 is at y > 0, the
 * others follow counterclockwise as seen from above. A point of the half arch
 * is (a, z), with the distance a from the crown; "out" is the distance from the
 * middle of the bay along a web, before it is stretched. Places that are the
 * same are the same to the last bit, in whatever web.
 */
class BayPlaces
{
public:
  /** A closed loop of places; lengths. */
  using Loop = BlockBuilder::Loop;
  /** A polygon of points (a, z) of the half arch; lengths. */
  using Section = std::vector<dealii::Point<2>>;

  /** @param stretch the factor by which all is stretched along y. */
  explicit BayPlaces(const double stretch) : stretch(stretch) {}

  /** The place of a point of the half arch, @p out along a web; lengths. */
  dealii::Point<3> place(const unsigned int web,
                         const Flank flank,
                         const dealii::Point<2> &p,
                         const double out) const
  {
    const double across = flank == Flank::left ? -p[0] : p[0];
    const std::array<double, n_webs> cycle = {{across, -out, -across, out}};
    // The zero that is added turns -0 into 0.
    return {cycle[web] + 0., stretch * cycle[(web + 3) % n_webs] + 0., p[1]};
  }

  /** The place of a point in the groin between a web and the next; lengths. */
  dealii::Point<3> on_groin(const unsigned int web,
                            const dealii::Point<2> &p) const
  {
    return place(web, Flank::left, p, p[0]);
  }

  /** The polygon at a head joint, @p out along a web; lengths. */
  Loop section(const unsigned int web,
               const Flank flank,
               const Section &points,
               const double out) const
  {
    Loop loop;
    for (const dealii::Point<2> &p : points)
      loop.push_back(place(web, flank, p, out));
    return loop;
  }

  /** The polygon in the groin between a web and the next; lengths. */
  Loop mitre(const unsigned int web, const Section &points) const
  {
    Loop loop;
    for (const dealii::Point<2> &p : points)
      loop.push_back(on_groin(web, p));
    return loop;
  }

private:
  double stretch;
};
} // namespace Voussoir

#endif
