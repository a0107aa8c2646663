// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_links_ties_h
#define voussoir_scene_links_ties_h

#include <voussoir/scene/links/link.h>

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace Voussoir
{
/** The section whose sections users name: each is a tie. */
inline const std::string ties_section = "Ties";

/**
 * The section `Ties`: bars of no weight between two blocks, or a block and the
 * ground, rigid and ideally plastic, which pull or push along themselves.
 */
class Ties
{
public:
  /** Declare the ties of these @p names, and bind their entries. */
  void add_parameters(dealii::ParameterHandler &prm,
                      const std::set<std::string> &names);

  /**
   * The ties as links, in the order of their names.
   *
   * @throws InputError if an end cannot be read or is at no place of a block,
   *   both are on the ground, on the same block, or at the same place, or if
   *   the strengths of a tie are zero or its prestress is more than it bears.
   */
  std::vector<Link> links(const Packing<2> &packing) const;

private:
  /** The entries of one. */
  struct Entries
  {
    std::string from, to;
    double yield_force = 0., compressive_strength = 0., prestress = 0.;
  };
  std::map<std::string, Entries> of_name;
};
} // namespace Voussoir

#endif
