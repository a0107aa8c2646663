// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_loads_load_cases_h
#define voussoir_scene_loads_load_cases_h

#include <voussoir/packing/packing.h>
#include <voussoir/scene/loads/loads.h>

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace Voussoir
{
/** The section whose sections users name: each is a load case. */
inline const std::string load_cases_section = "Load cases";

/** A load case in a combination. */
struct CombinedCase
{
  /** What its loads are multiplied with. */
  double factor;
  /** Its name. */
  std::string name;
};

/**
 * Read a combination such as "1.35 dead + 1.5 lorry - wind".
 *
 * @param parameter its name, for messages.
 * @throws InputError if it is of another form or a factor is not finite.
 */
std::vector<CombinedCase> combination_of_text(const std::string &combination,
                                              const std::string &parameter);

/**
 * The section `Load cases`: loads by name, of which the entries `Combination`
 * of `Loads` and `Live loads` add some.
 */
class LoadCases
{
public:
  /**
   * Declare the cases of these @p names, and the entries, and bind them.
   *
   * @throws InputError if a name cannot stand in a combination.
   */
  void add_parameters(dealii::ParameterHandler &prm,
                      const std::set<std::string> &names);

  /**
   * Add the combination of the @p section to @p loads on a packing with
   * @p soil.
   *
   * @throws InputError as LoadParameters::loads() does, or if the combination
   *   cannot be read or names a case that is not there.
   */
  void add_combination(const std::string &section,
                       const Packing<2> &packing,
                       Loads &loads,
                       const std::vector<Spreading> &soil = {}) const;

  /** True if there are cases, and no combination has any. */
  bool forgotten() const;

private:
  std::map<std::string, LoadParameters> of_name;
  std::map<std::string, std::string> combinations;
};
} // namespace Voussoir

#endif
