// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_parameters_faulty_assignment_h
#define voussoir_base_parameters_faulty_assignment_h

#include <voussoir/base/parameters/parameter_path.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace Voussoir
{
/** A value of a user's, not longer than a message can show. */
std::string shortened(const std::string &words);

/**
 * What is wrong with an assignment, in words that a user knows: there is no
 * such section or entry, or it does not accept the value.
 */
class FaultyAssignment
{
public:
  /**
   * @param prm outside of all sections; its values are of no use afterwards.
   * @param section in which the assignment is; it exists.
   */
  FaultyAssignment(dealii::ParameterHandler &prm, const SectionPath &section)
      : prm(prm), section(section)
  {}

  /** @{ */
  /** Sentences that begin behind a place and a colon. */
  std::string unknown_section(const std::string &name) const;
  std::string unknown_entry(const std::string &name) const;
  std::string unaccepted_value(const std::string &name,
                               const std::string &value,
                               const std::string &pattern) const;
  /** The value of an entry that exists is refused. */
  std::string unaccepted_value(const std::string &name,
                               const std::string &value) const;
  /** @} */

  /** The paths of all entries, or of all sections. */
  std::vector<std::string> paths(bool of_sections) const;

private:
  bool accepts(const std::string &name, const std::string &value) const;
  std::string did_you_mean(const std::string &name,
                           const std::vector<std::string> &paths) const;

  dealii::ParameterHandler &prm;
  const SectionPath section;
};
} // namespace Voussoir

#endif
