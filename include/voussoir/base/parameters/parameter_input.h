// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_parameters_parameter_input_h
#define voussoir_base_parameters_parameter_input_h

#include <deal.II/base/parameter_handler.h>

#include <boost/property_tree/ptree.hpp>

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace Voussoir
{
/**
 * Parameters as somebody has written them, in one of deal.II's formats: lines
 * as in a .prm file, JSON or XML. In these two sections are nested and a value
 * is text, a number, true or false; it may also be the member "value" of an
 * object that documents the entry, as in deal.II's listings.
 */
class ParameterInput
{
public:
  /**
   * Read a file: JSON if its name ends in .json, XML if in .xml, and .prm
   * otherwise.
   *
   * @throws InputError if it cannot be read, is not in UTF-8 but for comments,
   *   or is no valid JSON or XML.
   */
  explicit ParameterInput(const std::filesystem::path &file);
  /**
   * @param lines as in a .prm file.
   * @param name of them, for messages.
   * @throws InputError if they are not in UTF-8 but for comments.
   */
  ParameterInput(const std::string &lines, const std::string &name);

  /** The names of the sections directly in @p section, which need not exist. */
  std::set<std::string> sections_in(const std::string &section) const;

  /** Names and values. */
  using Entries = std::vector<std::pair<std::string, std::string>>;
  /**
   * The entries directly in @p section, or outside all sections if it is empty,
   * as they are assigned one after the other; all may be undeclared.
   */
  Entries entries_in(const std::string &section) const;

  /**
   * Replace all values but those of a section.
   *
   * @param section whose values stay as they are.
   * @param replaced takes a value, or a line with it but without a comment, and
   *   its place for messages, and returns what stands for it.
   */
  void replace_values(
      const std::string &section,
      const std::function<std::string(const std::string &value,
                                      const std::string &place)> &replaced);

  /**
   * Assign all to @p prm.
   *
   * @return true if it is a listing, which assigns every entry and does not say
   *   which of them somebody has set: parameters.prm, or what
   *   --print-parameters prints.
   * @throws InputError if there is an entry that is not declared or a value
   *   that its pattern refuses; the message names the line or the entry.
   */
  bool assign_to(dealii::ParameterHandler &prm) const;

private:
  void check_encoding() const;

  /** Sections and entries by their names, of JSON or XML. */
  using Nested = boost::property_tree::ptree;

  std::string name;
  /** Lines as in a .prm file, or what is nested. */
  std::variant<std::string, Nested> content;
};

/**
 * The line that a listing of all parameters begins with, parameters.prm or what
 * --print-parameters prints: deal.II's.
 */
std::string listing_title();
} // namespace Voussoir

#endif
