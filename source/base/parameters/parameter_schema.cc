// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameter_tree.h>
#include <voussoir/base/parameters/pattern_description.h>
#include <voussoir/base/parameters/print_parameters.h>

#include <ostream>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;

/** A number in a text, as deal.II writes all values. */
const char *const number_in_text =
    "^\\s*[-+]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)?\\s*$";

/** Numbers of a type between bounds, and texts of numbers. */
Json schema_of_number(const std::string &type, const PatternDescription &of)
{
  Json number = {{"type", type}};
  if (of.low)
    number["minimum"] = std::stod(*of.low);
  if (of.high)
    number["maximum"] = std::stod(*of.high);
  return Json::array(
      {number, {{"type", "string"}, {"pattern", number_in_text}}});
}

/** The values that an entry accepts, in the formats in which they may stand. */
Json schemas_of_value(const PatternDescription &of)
{
  using Kind = PatternDescription::Kind;
  switch (of.kind)
  {
  case Kind::truth:
    return Json::array({{{"enum", {true, false, "true", "false"}}}});
  case Kind::selection: return Json::array({{{"enum", of.choices}}});
  case Kind::number: return schema_of_number("number", of);
  case Kind::integer: return schema_of_number("integer", of);
  default: return Json::array({{{"type", {"string", "number"}}}});
  }
}

Json schema_of_entry(const Json &entry)
{
  const std::string description = entry.at("pattern_description");
  Json values = schemas_of_value(read_pattern(description));
  values.push_back({{"$ref", "#/definitions/listed entry"}});
  values.push_back({{"$ref", "#/definitions/variable"}});
  return {{"description", entry.at("documentation").get<std::string>() +
                              " Accepts " + text_of_pattern(description) + "."},
          {"default", entry.at("default_value")},
          {"anyOf", values}};
}

Json schema_of_section(const Json &section)
{
  Json properties = Json::object();
  if (section.is_object()) // boost writes a section without entries as ""
    for (const auto &[name, node] : section.items())
      properties[name] =
          is_entry(node) ? schema_of_entry(node) : schema_of_section(node);
  return {{"type", "object"},
          {"properties", properties},
          {"additionalProperties", false}};
}
} // namespace

void print_schema(std::ostream &out,
                  const dealii::ParameterHandler &prm,
                  const std::vector<std::string> &of_users)
{
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                 {"title", "Parameters of Voussoir"}};
  schema.update(schema_of_section(tree_of(prm)));
  Json &properties = schema["properties"];
  properties["$schema"] = {{"type", "string"}};
  for (const std::string &section : of_users)
  {
    Json &named = properties.at(section);
    named["additionalProperties"] = named.at("properties").front();
    named.erase("properties");
  }
  schema["definitions"] = {
      {"listed entry",
       {{"description", "An entry as --print-parameters --as json prints it."},
        {"type", "object"},
        {"required", {"value"}}}},
      {"variable",
       {{"description", "A text with variables, such as $h or $(2 * h)."},
        {"type", "string"},
        {"pattern", "\\$[A-Za-z_(]"}}}};
  out << schema.dump(2) << '\n';
}
} // namespace Voussoir
