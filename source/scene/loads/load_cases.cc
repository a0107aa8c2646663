// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/scene/loads/load_cases.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/lexical_cast/try_lexical_convert.hpp>

#include <algorithm>
#include <cmath>
#include <regex>

namespace Voussoir
{
namespace
{
/** Letters, which may be those of any language, and digits behind them. */
const std::string name_pattern = "[^-+*\\s0-9.][^-+*\\s]*";
} // namespace

std::vector<CombinedCase> combination_of_text(const std::string &combination,
                                              const std::string &parameter)
{
  static const std::regex term("\\s*([-+]?)\\s*"
                               "((?:[0-9]+\\.?[0-9]*|\\.[0-9]+)"
                               "(?:[eE][-+]?[0-9]+)?)?\\s*\\*?\\s*(" +
                               name_pattern + ")\\s*");
  std::vector<CombinedCase> cases;
  auto begin = combination.cbegin();
  for (std::smatch found; begin != combination.cend(); begin = found[0].second)
  {
    const bool is_term =
        std::regex_search(begin, combination.cend(), found, term,
                          std::regex_constants::match_continuous) &&
        (cases.empty() || found[1].length() > 0);
    double factor = 1.;
    if (is_term && found[2].matched &&
        (!boost::conversion::try_lexical_convert(found[2].str(), factor) ||
         !std::isfinite(factor)))
      throw InputError("The parameter '" + parameter + "' has the factor '" +
                       found[2].str() + "'; write a finite number.");
    if (!is_term)
      throw InputError("The parameter '" + parameter + "' is '" + combination +
                       "', and cannot be read from '" +
                       std::string(begin, combination.cend()) +
                       "' on; write factors and load cases, as in 1.35 dead + "
                       "1.5 lorry.");
    cases.push_back({found[1].str() == "-" ? -factor : factor, found[3].str()});
  }
  return cases;
}

void LoadCases::add_parameters(dealii::ParameterHandler &prm,
                               const std::set<std::string> &names)
{
  for (const char *section : {"Loads", "Live loads"})
  {
    prm.enter_subsection(section);
    prm.add_parameter(
        "Combination", combinations[section],
        "Load cases that are added with factors, as in 1.35 dead + 1.5 lorry. "
        "Each is a section of that name in 'Load cases' with the entries of "
        "'Loads'.",
        dealii::Patterns::Anything());
    prm.leave_subsection();
  }
  if (names.empty())
    return;
  const std::string &section = load_cases_section;
  prm.enter_subsection(section);
  for (const std::string &name : names)
  {
    if (!std::regex_match(name, std::regex(name_pattern)))
      throw InputError("The load case '" + name + "' in '" + section +
                       "' has a name that cannot stand in a combination; take "
                       "one word without + - * that begins with a letter.");
    of_name.try_emplace(name, name, section).first->second.add_parameters(prm);
  }
  prm.leave_subsection();
}

void LoadCases::add_combination(const std::string &section,
                                const Packing<2> &packing,
                                Loads &loads,
                                const std::vector<Spreading> &soil) const
{
  const std::string parameter = section + "/Combination";
  for (const CombinedCase &term :
       combination_of_text(combinations.at(section), parameter))
  {
    const auto found = of_name.find(term.name);
    if (found == of_name.end())
    {
      std::vector<std::string> known;
      for (const auto &[name, of] : of_name)
        known.push_back("'" + name + "'");
      throw InputError("The parameter '" + parameter +
                       "' names the load case '" + term.name +
                       "', which is no section in 'Load cases'; name one of " +
                       (known.empty() ? "these, of which there are none"
                                      : boost::algorithm::join(known, ", ")) +
                       ".");
    }
    loads.add(term.factor, found->second.loads(packing, soil));
  }
}

bool LoadCases::forgotten() const
{
  return !of_name.empty() &&
         std::all_of(combinations.begin(), combinations.end(),
                     [](const auto &of) { return of.second.empty(); });
}
} // namespace Voussoir
