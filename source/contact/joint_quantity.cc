// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/contact/joint_quantity.h>
#include <voussoir/formula/expression.h>
#include <voussoir/formula/integrals/edge_integral.h>
#include <voussoir/formula/integrals/inaccuracies.h>
#include <voussoir/formula/integrals/simplex_integral.h>
#include <voussoir/formula/place_variables.h>
#include <voussoir/formula/value_list.h>
#include <voussoir/packing/cell_groups.h>
#include <voussoir/packing/group_names.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace Voussoir
{
namespace
{
/** True of a value that a joint may have; not a number is none. */
bool admits(const JointQuantity &quantity, const double value)
{
  const bool is_finite =
      std::isfinite(value) || (quantity.may_be_empty && std::isinf(value));
  return is_finite && !(value < 0.) && !(quantity.is_positive && value == 0.);
}

/** Where interface @p e is, and what its value must be. */
template <int dim>
std::string on_interface(const Packing<dim> &packing,
                         const unsigned int e,
                         const JointQuantity &quantity)
{
  const auto &i = packing.interfaces()[e];
  return text("on the interface of ", packing.describe(i.cell_minus), " and ",
              packing.describe(i.cell_plus), "; a ", quantity.word,
              " must be finite and ",
              quantity.is_positive ? "positive." : "not negative.");
}

/** The values that a user lists for the interfaces, one by one. */
template <int dim>
std::vector<double> listed_values(const Packing<dim> &packing,
                                  const JointQuantity &quantity)
{
  const std::string parameter = quantity.section + "/" + quantity.parameter;
  const std::vector<double> values = numbers_of_list(
      quantity.everywhere, parameter, packing.interfaces().size(), "interface");
  for (unsigned int e = 0; e < values.size(); ++e)
    if (!admits(quantity, values[e]))
      throw InputError(text("The parameter '", parameter, "' lists ",
                            text_of_number(values[e]), " for interface ", e,
                            ", ", on_interface(packing, e, quantity)));
  return values;
}

/** A quantity as an expression, from one of the parameters. */
template <int dim>
class QuantityFormula
{
public:
  QuantityFormula(const std::string &formula,
                  const std::string &parameter,
                  const JointQuantity &quantity)
      : value(formula, variables_on_sides<dim>(), parameter),
        jumps(jumps_of(value)), formula(formula), parameter(parameter),
        quantity(quantity),
        inaccuracies(parameter, dim == 2 ? 1e-6 : largest_error_in_space)
  {}

  /** The mean over interface @p e. */
  double mean(const Packing<dim> &packing, const unsigned int e)
  {
    const auto &i = packing.interfaces()[e];
    const auto value_at = [&](const dealii::Point<dim> &p) {
      std::vector<double> values(p.begin_raw(), p.end_raw());
      values.insert(values.end(), i.normal.begin_raw(), i.normal.end_raw());
      const double at_p = value(values);
      if (!std::isfinite(at_p) || !admits(quantity, at_p))
        throw InputError(text("'", parameter, "' = '", formula, "' is ",
                              text_of_number(at_p), " at ", text_of_point(p),
                              ", ", on_interface(packing, e, quantity)));
      return at_p;
    };
    if (value.is_constant())
      return value_at(i.middle());
    return integral_mean(packing, e, value_at);
  }

  /** Warnings on the means computed so far. */
  std::vector<std::string> warnings() const { return inaccuracies.warnings(); }

private:
  /** In space jumps are left to the halving of triangles. */
  static Discontinuities jumps_of(const Expression &value)
  {
    return dim == 2 ? Discontinuities({value.formula()}, {0., 0.})
                    : Discontinuities();
  }
  template <typename ValueAt>
  double integral_mean(const Packing<2> &packing,
                       const unsigned int e,
                       const ValueAt &value_at)
  {
    const Packing<2>::Interface &i = packing.interfaces()[e];
    jumps.set_constants({i.normal[0], i.normal[1]});
    const EdgeIntegral integral =
        edge_integral(i.start, i.end, value_at, jumps);
    inaccuracies.look_at(integral.error, integral.size, integral.uncertain,
                         [&] { return along_edge(i.start, i.end); });
    return integral.mean;
  }
  template <typename ValueAt>
  double integral_mean(const Packing<3> &packing,
                       const unsigned int e,
                       const ValueAt &value_at)
  {
    const auto polygon = packing.polygon(e);
    const Packing<3>::Interface &i = packing.interfaces()[e];
    SimplexIntegral sum;
    for (unsigned int k = 0; k < polygon.size(); ++k)
      sum.add(integral_over_simplex(
          {i.centroid, polygon[k], polygon[(k + 1) % polygon.size()]},
          [&](const dealii::Point<3> &x, IntegratedValues &values) {
            values = {value_at(x)};
          }));
    inaccuracies.look_at(sum.error, sum.size, 0., [&] {
      return "on the interface at " + text_of_point(i.centroid);
    });
    return sum.values[0] / i.area;
  }

  Expression value;
  Discontinuities jumps;
  std::string formula, parameter;
  const JointQuantity &quantity;
  Inaccuracies inaccuracies;
};

/** What a user prescribes for a pair of groups. */
template <int dim>
struct OfPair
{
  std::string names;
  QuantityFormula<dim> formula;
  /** True if there is an interface between the two. */
  bool is_met;
};

/** Two groups of cells, the lower number first. */
using GroupPair = std::pair<unsigned int, unsigned int>;

/** The groups that a user names as "one, other", or as one with itself. */
template <int dim>
GroupPair pair_of_names(const Packing<dim> &packing,
                        const std::string &names,
                        const std::string &parameter)
{
  const std::vector<std::string> words = split_names(names);
  if (words.size() > 2 || words.front().empty() || words.back().empty())
    throw InputError("The parameter '" + parameter + "' has '" + names +
                     "' where the names of two groups are expected, as in "
                     "\"brick, lintel: 0.5\".");
  return std::minmax({group_of_name(packing, words.front(), parameter),
                      group_of_name(packing, words.back(), parameter)});
}
} // namespace

void JointQuantity::add_parameters(dealii::ParameterHandler &prm,
                                   const std::string &documentation,
                                   const std::string &documentation_of_pairs)
{
  using dealii::Patterns::Anything;
  prm.add_parameter(parameter, everywhere, documentation, Anything());
  prm.add_parameter(parameter_of_pairs, of_pairs, documentation_of_pairs,
                    Anything());
}

template <int dim>
std::vector<double> means(const Packing<dim> &packing,
                          const JointQuantity &quantity,
                          std::vector<std::string> &warnings)
{
  std::optional<QuantityFormula<dim>> everywhere;
  std::vector<double> listed;
  if (is_value_list(quantity.everywhere))
    listed = listed_values(packing, quantity);
  else if (!quantity.everywhere.empty() || !quantity.may_be_empty)
    everywhere.emplace(quantity.everywhere,
                       quantity.section + "/" + quantity.parameter, quantity);
  const std::string parameter =
      quantity.section + "/" + quantity.parameter_of_pairs;
  std::map<GroupPair, OfPair<dim>> of_pair;
  for (const auto &[names, formula] :
       split_named_list(quantity.of_pairs, parameter))
  {
    const GroupPair pair = pair_of_names(packing, names, parameter);
    OfPair<dim> prescribed = {
        names, QuantityFormula<dim>(formula, parameter, quantity), false};
    const bool is_new = of_pair.emplace(pair, std::move(prescribed)).second;
    if (!is_new)
      throw InputError("The parameter '" + parameter + "' has the pair '" +
                       names + "' twice; give it once.");
  }

  std::vector<double> result;
  result.reserve(packing.interfaces().size());
  for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
  {
    const auto &i = packing.interfaces()[e];
    const auto found =
        of_pair.empty()
            ? of_pair.end()
            : of_pair.find(std::minmax(
                  {packing.group(i.cell_minus), packing.group(i.cell_plus)}));
    if (found == of_pair.end())
      result.push_back(!listed.empty() ? listed[e]
                       : everywhere    ? everywhere->mean(packing, e)
                                    : std::numeric_limits<double>::infinity());
    else
    {
      result.push_back(found->second.formula.mean(packing, e));
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
  if (everywhere)
    for (std::string &warning : everywhere->warnings())
      warnings.push_back(std::move(warning));
  for (const auto &[pair, prescribed] : of_pair)
    for (std::string &warning : prescribed.formula.warnings())
      warnings.push_back(std::move(warning));
  return result;
}

template std::vector<double>
means(const Packing<2> &, const JointQuantity &, std::vector<std::string> &);
template std::vector<double>
means(const Packing<3> &, const JointQuantity &, std::vector<std::string> &);
} // namespace Voussoir
