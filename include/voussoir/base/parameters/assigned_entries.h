// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_parameters_assigned_entries_h
#define voussoir_base_parameters_assigned_entries_h

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json.hpp>

#include <set>
#include <string>

namespace Voussoir
{
/**
 * The entries of a ParameterHandler with their present values, and which of
 * them a file, the command line or a caller has assigned a value, be it the
 * default.
 */
class AssignedEntries
{
public:
  AssignedEntries() = default;
  /** @{ */
  /** Not copied: the ParameterHandler tells this object of its changes. */
  AssignedEntries(const AssignedEntries &) = delete;
  AssignedEntries &operator=(const AssignedEntries &) = delete;
  /** @} */

  /**
   * Note all assignments to the entries of @p prm from now on; this object must
   * outlive the last of them.
   */
  void watch(dealii::ParameterHandler &prm);

  /**
   * Count those alone as assigned that have another value than their default: a
   * listing of all parameters has been read, which assigns every entry.
   */
  void forget_unchanged();

  /** All sections and entries, as tree_of() gives them. */
  const nlohmann::ordered_json &tree() const { return entries; }
  /** True if the entry was assigned; "Friction/Strength". */
  bool contains(const std::string &path) const { return paths.count(path) > 0; }

private:
  nlohmann::ordered_json entries;
  std::set<std::string> paths;
};
} // namespace Voussoir

#endif
