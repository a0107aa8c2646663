// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/fields/links.h>

namespace Voussoir
{
Fields<Scene> link_ends()
{
  const std::string cells = "the cells c- and c+; -1 is the ground";
  const auto member = [](const auto of) {
    return [of](const Scene &s) { return Stored(s.links, of); };
  };
  return {Field<Scene>(
              "link", "", "its name",
              [](const Scene & /*s*/, const unsigned int k) { return int(k); })
              .numbering(
                  [](const Scene &s) -> const auto & { return s.link_names; })
              .only_in_table()
              .with_attribute("link_names"),
          Field<Scene>("cell_minus", "", cells,
                       [](const Scene &s, const unsigned int k) {
                         return int(s.links[k].cell_minus);
                       })
              .with_attribute("link_cell_minus"),
          Field<Scene>("cell_plus", "", cells,
                       [](const Scene &s, const unsigned int k) {
                         const unsigned int plus = s.links[k].cell_plus;
                         return plus == s.packing.ground() ? -1 : int(plus);
                       })
              .with_attribute("link_cell_plus"),
          Field<Scene>("on_minus", "L", "where it acts on c-",
                       member(&Link::on_minus))
              .with_columns({"x0", "y0"})
              .only_in_table()
              .with_attribute("link_starts"),
          Field<Scene>("on_plus", "L", "where it acts on c+",
                       member(&Link::on_plus))
              .with_columns({"x1", "y1"})
              .only_in_table()
              .with_attribute("link_ends"),
          Field<Scene>("direction", "",
                       "the unit vector along which tension acts on c-, and "
                       "against which on c+",
                       member(&Link::direction))
              .with_columns({"dx", "dy"})
              .only_in_table()
              .with_attribute("link_directions"),
          Field<Scene>("least", "S L",
                       "the least force that it admits, negative in "
                       "compression",
                       member(&Link::least))
              .with_attribute("link_least"),
          Field<Scene>("most", "S L", "the most", member(&Link::most))
              .with_attribute("link_most")};
}

Fields<Results> link_forces()
{
  return {
      Field<Results>("link_force", "S L", "its force, positive in tension",
                     [](const Results &r) { return Stored(r.forces.in_links); })
          .with_columns({"force"})
          .with_attribute("link_forces"),
      Field<Results>(
          "link_utilisation", "", "the force over the bound in its direction",
          [](const Results &r, const unsigned int k) {
            return r.scene.links[k].utilisation(r.forces.in_links[k]);
          })
          .with_columns({"utilisation"})
          .with_attribute("link_utilisations")};
}

Fields<MovingScene> link_elongations()
{
  return {Field<MovingScene>(
              "elongation", "L",
              "how much further apart the ends are drawn along the link",
              [](const MovingScene &m, const unsigned int k) {
                return elongation(m.scene, k, m.motion);
              })
              .with_attribute("link_elongations"),
          Field<MovingScene>(
              "dissipation", "S L^2",
              "what the link can take out of the motion, beside the work of "
              "the force that is nearest to zero",
              [](const MovingScene &m, const unsigned int k) {
                return m.scene.links[k].dissipation(
                    elongation(m.scene, k, m.motion));
              })
              .with_attribute("link_dissipations")};
}
} // namespace Voussoir
