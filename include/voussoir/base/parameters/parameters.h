// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_parameters_parameters_h
#define voussoir_base_parameters_parameters_h

#include <voussoir/base/parameters/parameter_path.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
/**
 * One of the values that an entry with a fixed set of values accepts: its name
 * in a .prm file and what it means.
 */
template <typename Enum>
struct Choice
{
  /** The value that the variable bound to the entry takes. */
  Enum value;
  /** Its name in a .prm file; without |. */
  std::string name;
  /** Its documentation, behind its name and a colon. */
  std::string meaning;
  /** What no other value uses; see with_uses(). */
  std::string uses = {};
};

/**
 * The pattern of an entry that decides which others a run looks at.
 *
 * @param accepted the pattern of what the entry accepts.
 * @param uses of each value the entries and sections beside the entry that no
 *   other value uses, as in "file: Points file; random: Number of points,
 *   Seed". They are added to the description, of which a ParameterHandler
 *   tells, and shown to no user.
 */
std::unique_ptr<dealii::Patterns::PatternBase>
with_uses(const dealii::Patterns::PatternBase &accepted,
          const std::string &uses);

/** Values, and the names of what no other value uses. */
using Uses = std::vector<std::pair<std::string, std::vector<std::string>>>;

/** What was given to with_uses(), from the description of any pattern. */
Uses uses_in(const std::string &description);

/**
 * Declare an entry that accepts exactly the names in @p choices, and bind it to
 * @p value, whose present state is the default. The documentation lists the
 * choices from the same table, so that it cannot go out of date.
 *
 * @param prm in the section of the entry.
 * @param entry its name.
 * @param value must outlive @p prm.
 * @param choices in the order in which they are documented.
 * @param documentation a sentence that says what the entry chooses.
 */
template <typename Enum>
void add_choice(dealii::ParameterHandler &prm,
                const std::string &entry,
                Enum &value,
                const std::vector<Choice<Enum>> &choices,
                const std::string &documentation)
{
  std::string names, meanings, uses, default_name;
  for (const Choice<Enum> &choice : choices)
  {
    names += (names.empty() ? "" : "|") + choice.name;
    meanings += " '" + choice.name + "': " + choice.meaning;
    if (choice.value == value)
      default_name = choice.name;
    if (!choice.uses.empty())
      uses += choice.name + ": " + choice.uses + "; ";
  }
  prm.declare_entry(entry, default_name,
                    *with_uses(dealii::Patterns::Selection(names), uses),
                    documentation + meanings);
  prm.add_action(entry, [&value, choices](const std::string &name) {
    for (const Choice<Enum> &choice : choices)
      if (choice.name == name)
        value = choice.value;
  });
}

/** A value for an entry. */
struct Assignment
{
  /** The entry. */
  EntryPath to;
  /** Its value as in a .prm file; white space around it does not count. */
  std::string value;
};

/**
 * The assignment "Section/Subsection/Name=value" of the command line.
 *
 * @throws InputError if it is of another form.
 */
Assignment assignment_of_text(const std::string &text);

/**
 * Check that there is a section.
 *
 * @param prm outside of all sections.
 * @param place where it is named, with which a message begins.
 * @throws InputError naming the first of @p section that is not there.
 */
void check_section(dealii::ParameterHandler &prm,
                   const SectionPath &section,
                   const std::string &place);

/**
 * Carry out an assignment.
 *
 * @param prm outside of all sections.
 * @param place of it, with which a message begins.
 * @throws InputError if there is no such entry, or its pattern refuses the
 *   value.
 */
void assign(dealii::ParameterHandler &prm,
            const Assignment &assignment,
            const std::string &place);

/** The sentence that tells a user where to find every parameter. */
extern const std::string how_to_list_parameters;
} // namespace Voussoir

#endif
