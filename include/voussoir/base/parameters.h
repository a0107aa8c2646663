// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_parameters_h
#define voussoir_base_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <filesystem>
#include <memory>
#include <set>
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

/**
 * The names of the subsections directly in @p section that a file and
 * command-line assignments have entries of, to declare those that a user names.
 *
 * @param file need not exist.
 */
std::set<std::string>
subsections_in(const std::string &section,
               const std::filesystem::path &file,
               const std::vector<std::string> &assignments);

/**
 * The line that a listing of all parameters begins with, parameters.prm or what
 * --print-parameters prints: deal.II's.
 */
std::string listing_title();

/**
 * Read the file @p file into @p prm.
 *
 * @return true if it has the line listing_title(): it assigns every entry, and
 *   does not say which of them somebody has set.
 * @throws InputError if the file cannot be read, or has an entry that is not
 *   declared or a value that its pattern refuses; the message names the line.
 */
bool read_parameters(dealii::ParameterHandler &prm,
                     const std::filesystem::path &file);

/**
 * Read a text of several lines as read_parameters() reads a file.
 *
 * @param name of the text, for messages.
 */
bool read_parameters_text(dealii::ParameterHandler &prm,
                          const std::string &text,
                          const std::string &name);

/**
 * Carry out one command-line assignment "Section/Subsection/Name=value".
 *
 * @throws InputError as read_parameters() does.
 */
void assign_parameter(dealii::ParameterHandler &prm,
                      const std::string &assignment);

/** The sentence that tells a user where to find every parameter. */
extern const std::string how_to_list_parameters;
} // namespace Voussoir

#endif
