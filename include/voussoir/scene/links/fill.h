// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_links_fill_h
#define voussoir_scene_links_fill_h

#include <voussoir/scene/links/link.h>
#include <voussoir/scene/loads/loads.h>

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace Voussoir
{
/** The section whose sections users name: each is a body of soil. */
inline const std::string fill_section = "Fill";

/** What soil on a packing does to it. */
struct FillOnBlocks
{
  /** Its weight, as tractions on the edges that it lies on. */
  Loads loads;
  /** Its horizontal pressure, a link to the ground for each edge. */
  std::vector<Link> links;
  /** What stands on edges that face upwards; lengths. */
  std::vector<std::array<dealii::Point<2>, 4>> columns;
  /** How each body spreads loads on its surface. */
  std::vector<Spreading> spreading;
};

/**
 * The section `Fill`: soil between the blocks and a surface above. With the
 * vertical stress
 *
 *     sigma(x, y) = gamma (top(x) - y) + surcharge
 *
 * below its surface, it lies with sigma |n_y| on edges that face upwards, and
 * pushes horizontally with a pressure p |n_x| on edges that face sidewards,
 * where K_a sigma <= p <= K_p sigma: what blocks yield to is active, and what
 * they push is passive. Each edge has one p over sigma, so that the pressure is
 * an unknown of the balance between two bounds. There is no friction between
 * soil and blocks.
 */
class Fill
{
public:
  /** Declare the bodies of soil of these @p names, and bind their entries. */
  void add_parameters(dealii::ParameterHandler &prm,
                      const std::set<std::string> &names);

  /** True if there are none. */
  bool empty() const { return of_name.empty(); }
  /**
   * What all of them do, in the order of their names.
   *
   * @throws InputError as set_expressed_tractions() does, or if a body has no
   *   edge or its coefficients are not ascending.
   */
  FillOnBlocks on(const Packing<2> &packing) const;

private:
  /** The entries of one. */
  struct Entries
  {
    std::string where = "0", top = "0";
    double unit_weight = 0., surcharge = 0., active = 0., passive = 0.;
    Spreading::Law law = Spreading::Law::none;
    double angle = 26.565;

    std::string vertical_stress() const;
  };
  void add(const std::string &name,
           const Entries &soil,
           const Packing<2> &packing,
           FillOnBlocks &all) const;
  static void add_sides(const std::string &name,
                        const Entries &soil,
                        const Loads &sidewards,
                        const Packing<2> &packing,
                        std::vector<Link> &links);

  std::map<std::string, Entries> of_name;
};
} // namespace Voussoir

#endif
