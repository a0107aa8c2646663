// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/fields/capacity.h>
#include <voussoir/output/fields/cells.h>
#include <voussoir/output/fields/edges.h>
#include <voussoir/output/fields/forces.h>
#include <voussoir/output/fields/links.h>
#include <voussoir/output/fields/mobilised_friction.h>
#include <voussoir/output/fields/motion.h>
#include <voussoir/output/fields/state_ranges.h>
#include <voussoir/output/fields/strengths.h>
#include <voussoir/output/fields/tables.h>

namespace Voussoir
{
const FieldTable<Results> &interface_fields()
{
  static const FieldTable<Results> table(
      "force normal_force tangential_force normal_stress "
      "tangential_stress end_forces eccentricity strength utilisation "
      "cell_minus cell_plus p_min p_max q_min q_max e_min e_max "
      "determined unbounded p_mean p_mean_error p_deviation "
      "q_mean q_mean_error q_deviation",
      interface_edges(), interface_forces(), strengths(), utilisations(),
      marks_of_all_states(), forces_at_ends(), further_limits(),
      crushing_utilisations(), mobilised_friction(), state_ranges(),
      sample_moments(), branch_vectors());
  return table;
}

const FieldTable<Results> &cell_fields()
{
  static const FieldTable<Results> table(
      "cell group load stress principal_stress_1 principal_stress_2 "
      "von_mises torque",
      cell_centres(), cell_areas(), cell_loads(),
      cell_displacements(
          "displacement, from the ground or with zero mean in each "
          "connected group without support: in units of eps with "
          "smoothed friction, of joints of the given modulus with "
          "least energy, else zero"),
      cell_stresses(), cell_groups(), cell_load_torques(), cell_rotations());
  return table;
}

const FieldTable<Scene> &boundary_fields()
{
  static const FieldTable<Scene> table("", boundary_edges());
  return table;
}

const FieldTable<MovingScene> &mechanism_joint_fields()
{
  static const FieldTable<MovingScene> table(
      "", only_in_table(interface_edges()), only_in_table(strengths()),
      interface_jumps(), further_limits());
  return table;
}

const FieldTable<Results> &link_fields()
{
  static const FieldTable<Results> table("link_force link_utilisation",
                                         link_ends(), link_forces());
  return table;
}

const FieldTable<MovingScene> &mechanism_link_fields()
{
  static const FieldTable<MovingScene> table("elongation", link_ends(),
                                             link_elongations());
  return table;
}

const FieldTable<CapacityCurve> &capacity_fields()
{
  static const FieldTable<CapacityCurve> table("", capacity_points());
  return table;
}

const FieldTable<MovingScene> &mechanism_fields()
{
  static const FieldTable<MovingScene> table(
      "", cell_centres(), only_in_table(cell_loads()),
      cell_displacements(
          "displacement along the motion; of a mechanism the largest "
          "component is 1, where a rotation counts times the root of the mean "
          "area of a cell"),
      cell_groups(), cell_load_torques(), cell_rotations(), live_loads());
  return table;
}

const FieldTable<Packing<2>> &packing_interface_fields()
{
  static const FieldTable<Packing<2>> table("", interface_edges(),
                                            branch_vectors());
  return table;
}

const FieldTable<Packing<2>> &packing_cell_fields()
{
  static const FieldTable<Packing<2>> table("", cell_centres(), cell_areas(),
                                            cell_groups());
  return table;
}
} // namespace Voussoir
