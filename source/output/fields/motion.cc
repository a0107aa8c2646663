// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/fields/motion.h>

namespace Voussoir
{
Fields<Motion> cell_displacements(const std::string &words)
{
  return {Field<Motion>("displacement", "L", words,
                        [](const Motion &m) { return Stored(m.displacement); })
              .with_columns({"ux", "uy"})
              .at(FieldDescription::Place::points)
              .saying_in_grid("with `Rotations = true` the points turn with "
                              "their block")};
}

Fields<Motion> cell_rotations()
{
  return when(where_blocks_turn<Motion>(
                  [](const Motion &m) { return !m.rotation.empty(); }),
              {{"rotation", "",
                "theta_c, counterclockwise, in units of ux and uy over L",
                [](const Motion &m) { return Stored(m.rotation); }}});
}

Fields<MovingScene> interface_jumps()
{
  return together<MovingScene>(
      {{{"opening", "L", "[u]_e . n_e at the midpoint, positive where it opens",
         [](const MovingScene &m) {
           return [&jumps = m.jumps()](const unsigned int e) {
             return 0.5 * (jumps.openings[e][0] + jumps.openings[e][1]);
           };
         }},
        {"sliding", "L", "[u]_e . t_e",
         [](const MovingScene &m) { return Stored(m.jumps().sliding); }},
        {"dissipation", "S L^2", "what the forces can take out of the motion",
         [](const MovingScene &m) {
           return [&m, &jumps = m.jumps()](const unsigned int e) {
             return m.scene.limits(e)
                 .resistance(jumps.openings[e], jumps.sliding[e])
                 .dissipation;
           };
         }}},
       when(
           where_blocks_turn<MovingScene>(
               [](const MovingScene &m) { return m.scene.turns(); }),
           {Field<MovingScene>(
                "openings", "L",
                "the opening at (x0, y0) and at (x1, y1), not negative but "
                "for rounding",
                [](const MovingScene &m) { return Stored(m.jumps().openings); })
                .with_columns({"opening_0", "opening_1"})})});
}
} // namespace Voussoir
