// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameter_path.h>
#include <voussoir/base/parameters/parameter_tree.h>
#include <voussoir/base/parameters/print_parameters.h>

#include <deal.II/base/patterns.h>

#include <map>
#include <memory>

namespace Voussoir
{
namespace
{
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

/** Declare an entry anew, with the description of its pattern that users see.
 */
void declare(dealii::ParameterHandler &part,
             const std::string &path,
             const nlohmann::ordered_json &entry)
{
  const auto &[section, name] = entry_path_of(path);
  const InSection in_section(part, section);
  part.declare_entry(name, entry.at("default_value"),
                     DescribedPattern(description_of_pattern(entry)),
                     entry.at("documentation"));
  part.set(name, entry.at("value").get<std::string>());
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
  const nlohmann::ordered_json tree = tree_of(prm);
  for_each_entry(tree, [&](const std::string &path, const auto &entry) {
    if (is_wanted(path))
      declare(part, path, entry);
  });
  part.print_parameters(out,
                        style_of(format, detail) | Style::KeepDeclarationOrder);
}
} // namespace Voussoir
