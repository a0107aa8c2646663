// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/fields/forces.h>

namespace Voussoir
{
namespace
{
/** Interface @p e of the scene. */
const Packing<2>::Interface &interface_of(const Results &r,
                                          const unsigned int e)
{
  return r.scene.packing.interfaces()[e];
}
} // namespace

Fields<Results> interface_forces()
{
  const std::string stress = "the forces over |e|";
  return {
      {"normal_force", "S L",
       "f_e^n, negative in compression: the force on c- along n_e",
       [](const Results &r) { return Stored(r.forces.normal); }},
      {"tangential_force", "S L", "f_e^t: the force on c- along t_e",
       [](const Results &r) { return Stored(r.forces.tangential); }},
      Field<Results>("force", "S L", "f_e^n n_e + f_e^t t_e, the force on c-",
                     [](const Results &r, const unsigned int e) {
                       return r.forces.on_cell_minus(interface_of(r, e), e);
                     })
          .only_in_grid(),
      Field<Results>("normal_stress", "S", stress,
                     [](const Results &r, const unsigned int e) {
                       return r.forces.normal[e] / interface_of(r, e).length;
                     })
          .only_in_grid(),
      Field<Results>("tangential_stress", "S", stress,
                     [](const Results &r, const unsigned int e) {
                       return r.forces.tangential[e] /
                              interface_of(r, e).length;
                     })
          .only_in_grid()};
}

Fields<Results> forces_at_ends()
{
  return when(
      where_blocks_turn<Results>(
          [](const Results &r) { return r.scene.turns(); }),
      {Field<Results>("end_forces", "S L",
                      "what of f_e^n acts at (x0, y0) and at (x1, y1), each "
                      "negative in compression",
                      [](const Results &r) { return Stored(r.forces.at_ends); })
           .with_columns({"normal_force_0", "normal_force_1"}),
       {"eccentricity", "",
        "the place of the resultant over the length, from -1/2 at (x0, "
        "y0) to 1/2 at (x1, y1); 0 in the middle and where nothing "
        "presses",
        [](const Results &r, const unsigned int e) {
          return r.forces.eccentricity(interface_of(r, e), e);
        }}});
}

Fields<Results> marks_of_all_states()
{
  return when<Results>(
      {"with `analytic centre`",
       [](const Results &r) { return !r.never_pressed.empty(); }},
      {{"never_pressed", "",
        "1 where every admissible and balanced state has f_e^n = 0",
        [](const Results &r, const unsigned int e) {
          return bool(r.never_pressed[e]);
        }},
       {"always_sliding", "", "1 where every one has |f_e^t| = s_e |e|",
        [](const Results &r, const unsigned int e) {
          return bool(r.always_sliding[e]);
        }}});
}
} // namespace Voussoir
