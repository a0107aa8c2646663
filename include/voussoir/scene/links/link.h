// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_links_link_h
#define voussoir_scene_links_link_h

#include <voussoir/packing/connected_groups.h>
#include <voussoir/packing/packing.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <string>
#include <vector>

namespace Voussoir
{
/**
 * A force along a line between two cells that need not touch, or a cell and the
 * ground, which lies between two bounds: a tie, a prop, the pressure of soil.
 * Tension is positive: on c- it acts along the direction, on c+ against it.
 *
 * It is one unknown of the balance, as the pressure of a contact is that
 * crushes.
 */
struct Link
{
  /** For the user. */
  std::string name;
  /** c-. */
  unsigned int cell_minus;
  /** c+, of a higher number; possibly the ground. */
  unsigned int cell_plus;
  /** @{ */
  /** Where it acts on either; lengths. */
  dealii::Point<2> on_minus, on_plus;
  /** @} */
  /** Of the force on c-, from there towards c+; a unit vector. */
  dealii::Tensor<1, 2> direction;
  /** @{ */
  /** The bounds of the force; S L. */
  double least, most;
  /** @} */
  /** True of the pressure of soil, which is no bar between two places. */
  bool is_of_fill = false;

  /**
   * The force nearest to zero, which a link that is stressed has at least; S L.
   */
  double rest() const { return std::clamp(0., least, most); }
  /**
   * The most work that it takes, beside its force at rest, where its ends draw
   * apart by @p elongation, or together; S L times the unit of that.
   */
  double dissipation(const double elongation) const
  {
    return ((elongation > 0. ? most : least) - rest()) * elongation;
  }
  /** What @p force is beyond its bounds; negative within them. S L. */
  double excess(const double force) const
  {
    return std::max(least - force, force - most);
  }
  /** The share of the bound in its direction that @p force, S L, takes. */
  double utilisation(const double force) const
  {
    const double bound = force < 0. ? least : most;
    return bound != 0. ? force / bound : 0.;
  }
};

/**
 * @throws InputError if the section @p name in @p section cannot be named so,
 *   since links are named in files.
 */
void check_link_name(const std::string &section, const std::string &name);

/** connected_groups() of a packing with links between its cells. */
std::vector<unsigned int> linked_groups(const Packing<2> &packing,
                                        const std::vector<Link> &links,
                                        Ground ground = Ground::connects);

/** These links with the forces of rest taken out: nothing stresses them. */
std::vector<Link> without_rest(std::vector<Link> links);
} // namespace Voussoir

#endif
