// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/faulty_assignment.h>
#include <voussoir/base/parameter_tree.h>
#include <voussoir/base/print_parameters.h>

#include <deal.II/base/patterns.h>

#include <map>
#include <memory>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;
using Style = dealii::ParameterHandler::OutputStyle;
using IsWanted = std::function<bool(const std::string &)>;

/** A pattern of which the description alone is used. */
class DescribedPattern : public dealii::Patterns::PatternBase
{
public:
  explicit DescribedPattern(const std::string &words) : words(words) {}

  bool match(const std::string &) const override { return true; }
  std::string description(OutputStyle) const override { return words; }
  std::unique_ptr<PatternBase> clone() const override
  {
    return std::make_unique<DescribedPattern>(words);
  }

private:
  const std::string words;
};

/**
 * Declare the wanted entries of a section anew, with the descriptions of their
 * patterns that users see.
 *
 * @param path of the section.
 */
void declare_wanted(dealii::ParameterHandler &part,
                    const Json &section,
                    const SectionPath &path,
                    const IsWanted &is_wanted)
{
  if (!section.is_object()) // boost writes a section without entries as ""
    return;
  for (const auto &[name, node] : section.items())
    if (!is_entry(node))
    {
      SectionPath inner = path;
      inner.push_back(name);
      declare_wanted(part, node, inner, is_wanted);
    }
    else if (is_wanted(text_of_section(path) + name))
    {
      for (const std::string &around : path)
        part.enter_subsection(around);
      part.declare_entry(name, node.at("default_value"),
                         DescribedPattern(description_of_pattern(node)),
                         node.at("documentation"));
      part.set(name, node.at("value").get<std::string>());
      for (std::size_t k = 0; k < path.size(); ++k)
        part.leave_subsection();
    }
}

Style style_of(const ParameterFormat format, const Detail detail)
{
  const bool is_short = detail == Detail::value;
  switch (format)
  {
  case ParameterFormat::json: return is_short ? Style::ShortJSON : Style::JSON;
  case ParameterFormat::xml: return is_short ? Style::ShortXML : Style::XML;
  default: return is_short ? Style::ShortPRM : Style::PRM;
  }
}
} // namespace

ParameterFormat parameter_format_of(const std::string &name)
{
  static const std::map<std::string, ParameterFormat> formats = {
      {"prm", ParameterFormat::prm},
      {"json", ParameterFormat::json},
      {"xml", ParameterFormat::xml}};
  const auto found = formats.find(name);
  if (found == formats.end())
    throw InputError("--as is '" + name + "'; give prm, json or xml.");
  return found->second;
}

void print_parameters(std::ostream &out,
                      const dealii::ParameterHandler &prm,
                      const IsWanted &is_wanted,
                      const ParameterFormat format,
                      const Detail detail)
{
  dealii::ParameterHandler part;
  declare_wanted(part, tree_of(prm), {}, is_wanted);
  part.print_parameters(out,
                        style_of(format, detail) | Style::KeepDeclarationOrder);
}
} // namespace Voussoir
