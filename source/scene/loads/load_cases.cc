// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/scene/loads/load_cases.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <system_error>

namespace Voussoir
{
namespace
{
constexpr const char *white_space = " \t\n\v\f\r";
constexpr const char *not_in_names = "-+* \t\n\v\f\r";

/** True if a factor begins with it, or its exponent. */
bool is_of_number(const char letter)
{
  return std::isdigit(static_cast<unsigned char>(letter)) != 0 || letter == '.';
}

/** Letters, which may be those of any language, and digits behind them. */
bool is_name_of_case(const std::string &name)
{
  return !name.empty() && !is_of_number(name.front()) &&
         name.find_first_of(not_in_names) == name.npos;
}

/** Reads "1.35 dead + 1.5 lorry"; one object, used once. */
class CombinationReader
{
public:
  CombinationReader(const std::string &combination,
                    const std::string &parameter)
      : all(combination), parameter(parameter)
  {}

  std::vector<CombinedCase> read()
  {
    std::vector<CombinedCase> cases;
    for (skip_space(); at < all.size(); skip_space())
    {
      begin = at;
      const char sign = all[at];
      const bool has_sign = sign == '-' || sign == '+';
      at += has_sign;
      skip_space();
      const double factor = read_factor();
      skip_space();
      at += at < all.size() && all[at] == '*';
      skip_space();
      const std::size_t end =
          std::min(all.find_first_of(not_in_names, at), all.size());
      const std::string name = all.substr(at, end - at);
      if (!is_name_of_case(name) || !(has_sign || cases.empty()))
        refuse();
      cases.push_back({sign == '-' ? -factor : factor, name});
      at = end;
    }
    return cases;
  }

private:
  void skip_space()
  {
    at = std::min(all.find_first_not_of(white_space, at), all.size());
  }

  /** One if none stands there. */
  double read_factor()
  {
    if (at == all.size() || !is_of_number(all[at]))
      return 1.;
    double factor = 0.;
    const char *const end = all.data() + all.size();
    const auto [stop, error] = std::from_chars(all.data() + at, end, factor);
    if (error == std::errc::invalid_argument)
      refuse();
    const std::size_t first = at;
    at = stop - all.data();
    if (error != std::errc())
      throw InputError("The parameter '" + parameter + "' has the factor '" +
                       all.substr(first, at - first) +
                       "'; write a finite number.");
    return factor;
  }

  [[noreturn]] void refuse() const
  {
    throw InputError("The parameter '" + parameter + "' is '" + all +
                     "', and cannot be read from '" + all.substr(begin) +
                     "' on; write factors and load cases, as in 1.35 dead + "
                     "1.5 lorry.");
  }

  const std::string &all, &parameter;
  std::size_t at = 0, begin = 0;
};
} // namespace

std::vector<CombinedCase> combination_of_text(const std::string &combination,
                                              const std::string &parameter)
{
  return CombinationReader(combination, parameter).read();
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
    if (!is_name_of_case(name))
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
