// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_support_displacements_h
#define voussoir_scene_support_displacements_h

#include <voussoir/packing/packing.h>
#include <voussoir/packing/polyhedra/packing.h>
#include <voussoir/scene/motion.h>
#include <voussoir/scene/space/space_motion.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <type_traits>
#include <vector>

namespace Voussoir
{
/** How a support moves. */
template <int dim>
using SupportMotionIn =
    std::conditional_t<dim == 2, SupportMotion, SpaceSupportMotion>;

/** The entries of the section `Supports` on how the ground moves. */
template <int dim>
class SupportDisplacements
{
public:
  /** Declare them in the current section and bind them. */
  void add_entries(dealii::ParameterHandler &prm);

  /**
   * How each support of @p packing moves; empty if they do not.
   *
   * @throws InputError if it cannot be evaluated, is zero everywhere, or there
   *   are no supports, or none under a group that is named.
   */
  std::vector<SupportMotionIn<dim>> motion(const Packing<dim> &packing) const;

private:
  std::string of_all, of_groups;
};
} // namespace Voussoir

#endif
