// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/fields/cells.h>
#include <voussoir/stress/stress_invariants.h>

namespace Voussoir
{
namespace
{
/** A quantity in grids that follows from the mean stress. */
Field<Results> invariant(const std::string &name,
                         const std::string &words,
                         double StressInvariants::*const of)
{
  return Field<Results>(name, "S", words,
                        [of](const Results &r, const unsigned int c) {
                          return StressInvariants(r.mean_stresses[c]).*of;
                        })
      .only_in_grid();
}
} // namespace

Fields<Packing<2>> cell_centres()
{
  return {Field<Packing<2>>(
              "cell", "", "the number of the cell",
              [](const Packing<2> &, const unsigned int c) { return int(c); })
              .with_columns({"id"})
              .with_attribute(""),
          Field<Packing<2>>(
              "centre", "L", "its centre",
              [](const Packing<2> &p, const unsigned int c) -> const auto & {
                return p.centre(c);
              })
              .with_columns({"x", "y"})
              .with_attribute("centres")
              .only_in_table()};
}

Fields<Packing<2>> cell_areas()
{
  return {Field<Packing<2>>("area", "L^2", "its area",
                            [](const Packing<2> &p, const unsigned int c) {
                              return p.area(c);
                            })
              .with_attribute("areas")
              .only_in_table()};
}

Fields<Packing<2>> cell_groups()
{
  return {
      Field<Packing<2>>("group", "", "the name of the cell's group",
                        [](const Packing<2> &p, const unsigned int c) {
                          return int(p.group(c));
                        })
          .numbering([](const Packing<2> &p) -> const auto & {
            return p.group_names();
          })
          .with_attribute("groups")
          .saying_in_grid("its number in the list in `summary.json`, from 0")};
}

Fields<Scene> cell_loads()
{
  return {Field<Scene>("load", "S L", "F_c", [](const Scene &s) {
            return Stored(s.load);
          }).with_attribute("loads")};
}

Fields<Scene> cell_load_torques()
{
  return only_in_table(when(
      where_blocks_turn<Scene>([](const Scene &s) { return s.turns(); }),
      {{"load_torque", "S L^2", "T_c, the torque of the loads about the centre",
        [](const Scene &s) { return Stored(s.load_torque); }}}));
}

Fields<MovingScene> live_loads()
{
  const auto bounds_factor = [](const MovingScene &m) {
    return m.live != nullptr;
  };
  const auto bounds_factor_of_torques = [](const MovingScene &m) {
    return m.live != nullptr && m.scene.turns();
  };
  return only_in_table(together<MovingScene>(
      {when<MovingScene>(
           {"of a load factor", bounds_factor},
           {{"live_load", "S L",
             "the loads that the factor multiplies; `load` is all at the "
             "factor that is carried",
             [](const MovingScene &m) { return Stored(m.live->force); }}}),
       when<MovingScene>(
           {"of a load factor with `Rotations = true`",
            bounds_factor_of_torques},
           {{"live_load_torque", "S L^2", "their torque about the centre",
             [](const MovingScene &m) { return Stored(m.live->torque); }}})}));
}

Fields<Results> cell_stresses()
{
  const std::string principal =
      "the larger and the smaller principal stress, of the symmetric part";
  return {
      {"torque", "S L^2",
       "residual torque about the centre; with `Rotations = true` rounding",
       [](const Results &r) { return Stored(r.torques); }},
      Field<Results>(
          "stress", "S",
          "mean stress, (11) in [theory](theory.md#the-stress-inside-a-block)",
          [](const Results &r) { return Stored(r.mean_stresses); })
          .with_columns({"sxx", "sxy", "syx", "syy"}),
      invariant("principal_stress_1", principal,
                &StressInvariants::principal_1),
      invariant("principal_stress_2", principal,
                &StressInvariants::principal_2),
      invariant("von_mises", "that of the symmetric part, of plane stress",
                &StressInvariants::von_mises)};
}
} // namespace Voussoir
