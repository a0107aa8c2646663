// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters.h>
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
/** What a joint is given by two parameters: everywhere, and for pairs. */
struct Quantity
{
  /** The word for it, behind "a". */
  std::string word;
  std::string everywhere;
  /** The name of the parameter, behind "Friction/". */
  std::string parameter;
  std::string of_pairs;
  std::string parameter_of_pairs;
};

/** A quantity as an expression, from one of the parameters. */
class QuantityFormula
{
public:
  QuantityFormula(const std::string &formula,
                  const std::string &parameter,
                  const std::string &word)
      : value(formula, {"x", "y", "nx", "ny"}, parameter),
        jumps({value.formula()}, {0., 0.}), formula(formula),
        parameter(parameter), word(word), inaccuracies(parameter)
  {}

  /** The mean over the interface @p i. */
  double mean(const Packing &packing, const Packing::Interface &i)
  {
    const auto value_at = [&](const dealii::Point<2> &p) {
      const double at_p = value({p[0], p[1], i.normal[0], i.normal[1]});
      if (!std::isfinite(at_p) || at_p < 0.)
        throw InputError(text("'", parameter, "' = '", formula, "' is ",
                              text_of_number(at_p), " at ", text_of_point(p),
                              ", on the interface of ",
                              packing.describe(i.cell_minus), " and ",
                              packing.describe(i.cell_plus), "; a ", word,
                              " must be finite and not negative."));
      return at_p;
    };
    if (value.is_constant())
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
  Expression value;
  Jumps jumps;
  std::string formula, parameter, word;
  Inaccuracies inaccuracies;
};

/** What a user prescribes for a pair of groups. */
struct OfPair
{
  std::string names;
  QuantityFormula formula;
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

/** The means over all interfaces. */
std::vector<double> means(const Packing &packing,
                          const Quantity &quantity,
                          std::vector<std::string> &warnings)
{
  QuantityFormula everywhere(quantity.everywhere,
                             "Friction/" + quantity.parameter, quantity.word);
  const std::string parameter = "Friction/" + quantity.parameter_of_pairs;
  std::map<GroupPair, OfPair> of_pair;
  for (const auto &[names, formula] :
       split_named_list(quantity.of_pairs, parameter))
  {
    const GroupPair pair = pair_of_names(packing, names, parameter);
    OfPair prescribed = {
        names, QuantityFormula(formula, parameter, quantity.word), false};
    const bool is_new = of_pair.emplace(pair, std::move(prescribed)).second;
    if (!is_new)
      throw InputError("The parameter '" + parameter + "' has the pair '" +
                       names + "' twice; give it once.");
  }

  std::vector<double> result;
  result.reserve(packing.interfaces().size());
  for (const Packing::Interface &i : packing.interfaces())
  {
    const auto found =
        of_pair.empty()
            ? of_pair.end()
            : of_pair.find(std::minmax(
                  {packing.group(i.cell_minus), packing.group(i.cell_plus)}));
    if (found == of_pair.end())
      result.push_back(everywhere.mean(packing, i));
    else
    {
      result.push_back(found->second.formula.mean(packing, i));
      found->second.is_met = true;
    }
  }
  for (const auto &[pair, prescribed] : of_pair)
    if (!prescribed.is_met)
      throw InputError("The parameter '" + parameter + "' gives a " +
                       quantity.word + " to the pair '" + prescribed.names +
                       "', but there is no cell of one of these groups that "
                       "touches one of the other; correct the names or leave "
                       "it out.");
  for (std::string &warning : everywhere.warnings())
    warnings.push_back(std::move(warning));
  for (const auto &[pair, prescribed] : of_pair)
    for (std::string &warning : prescribed.formula.warnings())
      warnings.push_back(std::move(warning));
  return result;
}
} // namespace

void FrictionParameters::add_parameters(dealii::ParameterHandler &prm)
{
  using dealii::Patterns::Anything;
  prm.enter_subsection("Friction");
  add_choice<Law>(
      prm, "Law", law,
      {{Law::tresca, "Tresca", "|f_t| <= s_T |e|, whatever the pressure.",
        "Strength, Pair strengths"},
       {Law::associated_coulomb, "associated Coulomb",
        "|f_t| <= c |e| + mu p with the compressive force p. Joints that "
        "slide open by mu times the sliding, so that the theorems of limit "
        "analysis hold.",
        "Coefficient, Pair coefficients, Cohesion, Pair cohesions"}},
      "The largest tangential force f_t on an interface of the length |e|.");
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
                    Anything());
  prm.add_parameter("Coefficient", coefficient,
                    "The coefficient mu of Coulomb's friction, not negative; "
                    "an expression as for 'Strength'.",
                    Anything());
  prm.add_parameter("Pair coefficients", pair_coefficients,
                    "Other coefficients where two groups of cells meet, as for "
                    "'Pair strengths'.",
                    Anything());
  prm.add_parameter("Cohesion", cohesion,
                    "The cohesion c of Coulomb's friction, the shear stress at "
                    "which interfaces slide without pressure. A stress, not "
                    "negative; an expression as for 'Strength'.",
                    Anything());
  prm.add_parameter("Pair cohesions", pair_cohesions,
                    "Other cohesions where two groups of cells meet, as for "
                    "'Pair strengths'.",
                    Anything());
  prm.leave_subsection();
}

Strengths FrictionParameters::strengths(const Packing &packing) const
{
  Strengths result;
  if (law == Law::tresca)
    result.of_interface = means(
        packing,
        {"strength", strength, "Strength", pair_strengths, "Pair strengths"},
        result.warnings);
  else
  {
    result.of_interface = means(
        packing,
        {"cohesion", cohesion, "Cohesion", pair_cohesions, "Pair cohesions"},
        result.warnings);
    result.coefficient = means(packing,
                               {"coefficient", coefficient, "Coefficient",
                                pair_coefficients, "Pair coefficients"},
                               result.warnings);
  }
  return result;
}
} // namespace Voussoir
