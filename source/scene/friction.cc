// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/formula/edge_integral.h>
#include <voussoir/formula/expression.h>
#include <voussoir/formula/inaccuracies.h>
#include <voussoir/packing/cell_groups.h>
#include <voussoir/packing/group_names.h>
#include <voussoir/scene/friction.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace Voussoir
{
namespace
{
/** s_T as an expression, from one of the parameters. */
class StrengthFormula
{
public:
  StrengthFormula(const std::string &formula, const std::string &parameter)
      : s_T(formula, {"x", "y", "nx", "ny"}, parameter),
        jumps({s_T.formula()}, {0., 0.}), formula(formula),
        parameter(parameter), inaccuracies(parameter)
  {}

  /** The mean of s_T over the interface @p i. */
  double mean(const Packing &packing, const Packing::Interface &i)
  {
    const auto value_at = [&](const dealii::Point<2> &p) {
      const double value = s_T({p[0], p[1], i.normal[0], i.normal[1]});
      if (!std::isfinite(value) || value < 0.)
        throw InputError(text("'", parameter, "' = '", formula, "' is ",
                              text_of_number(value), " at ", text_of_point(p),
                              ", on the interface of ",
                              packing.describe(i.cell_minus), " and ",
                              packing.describe(i.cell_plus),
                              "; a strength must be finite and not negative."));
      return value;
    };
    if (s_T.is_constant())
      return value_at(i.midpoint());
    jumps.set_constants({i.normal[0], i.normal[1]});
    const EdgeIntegral integral =
        edge_integral(i.start, i.end, value_at, jumps);
    inaccuracies.look_at(integral.error, integral.size, integral.uncertain,
                         [&] { return along_edge(i.start, i.end); });
    return integral.mean;
  }

  /** Warnings on the means computed so far. */
  std::vector<std::string> warnings() const { return inaccuracies.warnings(); }

private:
  Expression s_T;
  Jumps jumps;
  std::string formula, parameter;
  Inaccuracies inaccuracies;
};

/** The strength that a user prescribes for a pair of groups. */
struct PairStrength
{
  std::string names;
  StrengthFormula formula;
  /** True if there is an interface between the two. */
  bool is_met;
};

/** Two groups of cells, the lower number first. */
using GroupPair = std::pair<unsigned int, unsigned int>;

/** The groups that a user names as "one, other". */
GroupPair pair_of_names(const Packing &packing,
                        const std::string &names,
                        const std::string &parameter)
{
  const std::vector<std::string> words =
      dealii::Utilities::split_string_list(names, ',');
  if (words.size() != 2)
    throw InputError("The parameter '" + parameter + "' has '" + names +
                     "' where the names of two groups are expected, as in "
                     "\"brick, lintel: 0.5\".");
  return std::minmax({group_of_name(packing, words[0], parameter),
                      group_of_name(packing, words[1], parameter)});
}
} // namespace

void FrictionParameters::add_parameters(dealii::ParameterHandler &prm)
{
  prm.enter_subsection("Friction");
  prm.add_parameter("Strength", strength,
                    "The Tresca strength s_T of the interfaces: the shear "
                    "stress at which they slide, whatever the normal stress. "
                    "A stress, not negative; an expression in x, y and the "
                    "unit normal nx, ny of the interface, whose sign is "
                    "arbitrary: abs(ny) > 0.5 ? 1 : 0.2 is one strength for "
                    "bed joints and another for head joints.");
  prm.add_parameter("Pair strengths", pair_strengths,
                    "Other strengths where two groups of cells meet, \"name, "
                    "name: expression; name, name: expression\", as in brick, "
                    "brick: 0.3; brick, ground: 1 + x. What supports the "
                    "packing is called ground.",
                    dealii::Patterns::Anything());
  prm.leave_subsection();
}

Strengths FrictionParameters::strengths(const Packing &packing) const
{
  StrengthFormula everywhere(strength, "Friction/Strength");
  const std::string parameter = "Friction/Pair strengths";
  std::map<GroupPair, PairStrength> of_pair;
  for (const auto &[names, formula] :
       split_named_list(pair_strengths, parameter))
  {
    const GroupPair pair = pair_of_names(packing, names, parameter);
    PairStrength pair_strength = {names, StrengthFormula(formula, parameter),
                                  false};
    const bool is_new = of_pair.emplace(pair, std::move(pair_strength)).second;
    if (!is_new)
      throw InputError("The parameter '" + parameter + "' has the pair '" +
                       names + "' twice; give it once.");
  }

  Strengths strengths;
  strengths.of_interface.reserve(packing.interfaces().size());
  for (const Packing::Interface &i : packing.interfaces())
  {
    const auto found =
        of_pair.empty()
            ? of_pair.end()
            : of_pair.find(std::minmax(
                  {packing.group(i.cell_minus), packing.group(i.cell_plus)}));
    if (found == of_pair.end())
      strengths.of_interface.push_back(everywhere.mean(packing, i));
    else
    {
      strengths.of_interface.push_back(found->second.formula.mean(packing, i));
      found->second.is_met = true;
    }
  }
  for (const auto &[pair, strength] : of_pair)
    if (!strength.is_met)
      throw InputError("The parameter '" + parameter +
                       "' gives a strength to the pair '" + strength.names +
                       "', but there is no cell of one of these groups that "
                       "touches one of the other; correct the names or leave "
                       "it out.");
  strengths.warnings = everywhere.warnings();
  for (const auto &[pair, strength] : of_pair)
    for (std::string &warning : strength.formula.warnings())
      strengths.warnings.push_back(std::move(warning));
  return strengths;
}
} // namespace Voussoir
