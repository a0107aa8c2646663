// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/summary/ground_summary.h>
#include <voussoir/output/summary/link_summary.h>
#include <voussoir/output/summary/scene_summary.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace Voussoir
{
namespace
{
using dealii::Tensor;

/** The most groups, and pairs of them, that are shown. */
constexpr unsigned int n_shown = 30;

/** The bounds of numbers, and their sum. */
struct Spread
{
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();
  double sum = 0.;
  unsigned int n = 0;

  void add(const double value)
  {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
    sum += value;
    ++n;
  }
  /** "0.5", or "0.5 to 2" for numbers that differ in the digits shown. */
  std::string words() const
  {
    const std::string low = text(least), high = text(greatest);
    return low == high ? low : low + " to " + high;
  }
};

/** Show the lines of a list by @p name, and how many are left out. */
void show(Terminal &terminal,
          const std::string &name,
          const std::vector<std::string> &lines)
{
  for (unsigned int k = 0; k < lines.size() && k < n_shown; ++k)
    terminal.stage(name, lines[k]);
  if (lines.size() > n_shown)
    terminal.stage(name, text("and ", lines.size() - n_shown, " more"));
}

void show_units(Terminal &terminal, const UnitNames &units)
{
  std::string words;
  for (const auto &[what, unit] :
       {std::pair("lengths", units.length), std::pair("stresses", units.stress),
        std::pair("forces", units.force)})
    if (!unit.empty())
      words += text(words.empty() ? "" : ", ", what, " in ", unit);
  terminal.stage("Units", words.empty()
                              ? "not named: one consistent set, with forces "
                                "per unit thickness"
                              : words);
}

void show_groups(Terminal &terminal, const Scene &scene)
{
  const Packing<2> &packing = scene.packing;
  struct Group
  {
    Spread area;
    Tensor<1, 2> weight;
  };
  std::vector<Group> groups(packing.group_names().size());
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    Group &group = groups[packing.group(c)];
    group.area.add(packing.area(c));
    if (!scene.body.empty())
      group.weight += scene.body.force(packing, c);
  }
  std::vector<std::string> lines;
  for (unsigned int g = 0; g < groups.size(); ++g)
    if (const Spread &area = groups[g].area; area.n > 0)
      lines.push_back(text(
          packing.group_names()[g], ": ", counted(area.n, "cell"), ", area ",
          area.sum, area.n > 1 ? ", each " + area.words() : "", ", weight ",
          text_of_force(groups[g].weight, groups[g].weight.norm())));
  show(terminal, "Group", lines);
}

/** The strengths of some joints; those that a scene has none of are empty. */
struct StrengthsOfPair
{
  Spread length, tangential, coefficient, tensile, compressive;

  void add(const Scene &scene, const unsigned int e)
  {
    length.add(scene.packing.interfaces()[e].length);
    tangential.add(scene.strength[e]);
    for (const auto &[values, spread] :
         {std::pair(&scene.coefficient, &coefficient),
          std::pair(&scene.tensile_strength, &tensile),
          std::pair(&scene.compressive_strength, &compressive)})
      if (!values->empty())
        spread->add((*values)[e]);
  }

  std::string words() const
  {
    std::string words =
        text(counted(length.n, "joint"), ", length ", length.sum);
    if (length.n > 1)
      words += ", each " + length.words();
    const bool is_coulomb = coefficient.n > 0;
    for (const auto &[name, of] :
         {std::pair(is_coulomb ? "cohesion" : "strength", &tangential),
          std::pair("coefficient", &coefficient),
          std::pair("tensile strength", &tensile),
          std::pair("compressive strength", &compressive)})
      if (of->n > 0)
        words += text(", ", name, ' ', of->words());
    return words;
  }
};

void show_joints(Terminal &terminal, const Scene &scene)
{
  const Packing<2> &packing = scene.packing;
  std::map<std::array<unsigned int, 2>, StrengthsOfPair> pairs;
  for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
  {
    const Packing<2>::Interface &interface = packing.interfaces()[e];
    std::array<unsigned int, 2> pair = {{packing.group(interface.cell_minus),
                                         packing.group(interface.cell_plus)}};
    std::sort(pair.begin(), pair.end());
    pairs[pair].add(scene, e);
  }
  std::vector<std::string> lines;
  for (const auto &[pair, of] : pairs)
    lines.push_back(packing.group_names()[pair[0]] + " - " +
                    packing.group_names()[pair[1]] + ": " + of.words());
  show(terminal, "Joints", lines);
}

void show_tractions(Terminal &terminal, const Scene &scene)
{
  Tensor<1, 2> sum;
  unsigned int n = 0;
  for (unsigned int b = 0; b < scene.traction.size(); ++b)
    if (scene.traction[b].norm() > 0.)
    {
      sum += scene.packing.boundary_edges()[b].length * scene.traction[b];
      ++n;
    }
  if (n > 0)
    terminal.stage("Tractions",
                   text(text_of_force(sum, sum.norm()), " in all, on ",
                        counted(n, "boundary edge")));
}
} // namespace

void show_scene(Terminal &terminal, const Scene &scene, const UnitNames &units)
{
  show_units(terminal, units);
  show_groups(terminal, scene);
  show_joints(terminal, scene);
  show_tractions(terminal, scene);
  show_links(terminal, scene);
}

std::string description_of_law(const Scene &scene)
{
  return scene.dilates
             ? "Coulomb, associated: joints that slide open, too"
             : "Coulomb, without dilatancy: this state carries the loads, but "
               "no theorem says that the blocks stay in it";
}
} // namespace Voussoir
