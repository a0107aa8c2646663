// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_parameters_parameter_path_h
#define voussoir_base_parameters_parameter_path_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <string>
#include <vector>

namespace Voussoir
{
/** A section behind those around it; none outside of all sections. */
using SectionPath = std::vector<std::string>;

/** "Loads/Live/", with a slash at its end; nothing outside of all sections. */
inline std::string text_of_section(const SectionPath &section)
{
  std::string text;
  for (const std::string &name : section)
    text += name + '/';
  return text;
}

/** The place of an entry. */
struct EntryPath
{
  /** Where it is. */
  SectionPath section;
  /** Its name. */
  std::string entry;

  /** True if both are those of @p other. */
  bool operator==(const EntryPath &other) const
  {
    return section == other.section && entry == other.entry;
  }
};

/** @param text such as "Packing/wall/Courses". */
inline EntryPath entry_path_of(const std::string &text)
{
  SectionPath names = dealii::Utilities::split_string_list(text, '/');
  if (names.empty())
    return {};
  const std::string entry = names.back();
  names.pop_back();
  return {names, entry};
}

/** While it lives, a ParameterHandler is in a section, which exists. */
class InSection
{
public:
  /** @param prm outside of all sections. */
  InSection(dealii::ParameterHandler &prm, const SectionPath &section)
      : prm(prm), depth(section.size())
  {
    for (const std::string &name : section)
      prm.enter_subsection(name);
  }
  /** @{ */
  /** Not copied: each leaves once what it has entered. */
  InSection(const InSection &) = delete;
  InSection &operator=(const InSection &) = delete;
  /** @} */
  ~InSection()
  {
    for (std::size_t k = 0; k < depth; ++k)
      prm.leave_subsection();
  }

private:
  dealii::ParameterHandler &prm;
  const std::size_t depth;
};
} // namespace Voussoir

#endif
