// SPDX-License-Identifier: LGPL-2.1-or-later

// The tables of doc/results.md are those of the quantities: their names, units,
// components, conditions and words. What the page lacks is printed.

#include <voussoir/output/csv.h>
#include <voussoir/output/fields/tables.h>
#include <voussoir/output/vtu/blocks_vtu.h>
#include <voussoir/output/vtu/interfaces_vtu.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/replace.hpp>

#include "tests.h"
#include <fstream>
#include <iterator>
#include <utility>

namespace test_fields_documented
{
using namespace Voussoir;
using Descriptions = std::vector<const FieldDescription *>;

/** A cell of a table with the border behind it. */
std::string cell(const std::string &text)
{
  return (text.empty() ? "" : ' ' + boost::replace_all_copy(text, "|", "\\|")) +
         " |";
}

/** The lines of a table in Markdown; those that differ in names are one. */
class MarkdownTable
{
public:
  explicit MarkdownTable(const std::string &head) : lines(head) {}

  /** @param rest the cells behind the names. */
  void add(const std::vector<std::string> &more, const std::string &rest)
  {
    if (rest != last)
      finish();
    last = rest;
    names.insert(names.end(), more.begin(), more.end());
  }

  std::string text()
  {
    finish();
    return lines;
  }

private:
  void finish()
  {
    if (!names.empty())
      lines += '|' + cell(boost::join(names, ", ")) + last + '\n';
    names.clear();
  }

  std::string lines, last;
  std::vector<std::string> names;
};

/** The words, behind when it is there. */
std::string on_condition(const FieldDescription &field,
                         const std::string &mark,
                         const std::string &words)
{
  return field.condition.empty() ? words
                                 : field.condition + " only" + mark + words;
}

std::string columns_of(const Descriptions &fields)
{
  MarkdownTable table("| column | unit | meaning |\n|---|---|---|\n");
  for (const FieldDescription *field : fields)
    if (!field->columns.empty())
      table.add(field->columns,
                cell(field->unit) +
                    cell(on_condition(*field, ": ", field->words)));
  return table.text();
}

/** What a grid has, which refers to the table @p file. */
std::string arrays_of(const Descriptions &fields, const std::string &file)
{
  MarkdownTable table(
      "| array | components | unit | meaning |\n|---|---|---|---|\n");
  for (const FieldDescription *field : fields)
  {
    const bool at_points = field->in_grid == FieldDescription::Place::points;
    const std::vector<std::string> names =
        field->shape == FieldShape::pair
            ? field->columns
            : std::vector<std::string>{field->name +
                                       (at_points ? " (points)" : "")};
    const std::string n = field->shape == FieldShape::vector   ? "3"
                          : field->shape == FieldShape::tensor ? "9"
                                                               : "1";
    std::string words =
        field->columns.empty()
            ? on_condition(*field, ": ", field->words)
            : on_condition(*field, ", ",
                           (field->columns == names
                                ? "as"
                                : boost::join(field->columns, ", ")) +
                               " in `" + file + "`");
    if (!field->words_in_grid.empty())
      words += "; " + field->words_in_grid;
    table.add(names, cell(n) + cell(field->unit) + cell(words));
  }
  return table.text();
}

template <typename Data>
Descriptions all_of(const FieldTable<Data> &table)
{
  Descriptions all;
  for (const FieldDescription &field : table.all())
    all.push_back(&field);
  return all;
}

template <typename Data>
Descriptions in_grid_of(const FieldTable<Data> &table)
{
  return {table.in_grid().begin(), table.in_grid().end()};
}

void run()
{
  std::ifstream file(SOURCE_DIR "/../../doc/results.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  const std::vector<std::pair<std::string, std::string>> tables = {
      {interfaces_csv, columns_of(all_of(interface_fields()))},
      {cells_csv, columns_of(all_of(cell_fields()))},
      {boundary_csv, columns_of(all_of(boundary_fields()))},
      {mechanism_csv, columns_of(all_of(mechanism_fields()))},
      {mechanism_joints_csv, columns_of(all_of(mechanism_joint_fields()))},
      {links_csv, columns_of(all_of(link_fields()))},
      {capacity_csv, columns_of(all_of(capacity_fields()))},
      {mechanism_links_csv, columns_of(all_of(mechanism_link_fields()))},
      {links_vtu, arrays_of(in_grid_of(link_fields()), links_csv)},
      {mechanism_links_vtu,
       arrays_of(in_grid_of(mechanism_link_fields()), mechanism_links_csv)},
      {interfaces_vtu,
       arrays_of(in_grid_of(interface_fields()), interfaces_csv)},
      {blocks_vtu, arrays_of(in_grid_of(cell_fields()), cells_csv)},
      {mechanism_vtu, arrays_of(in_grid_of(mechanism_fields()), mechanism_csv)},
      {mechanism_joints_vtu,
       arrays_of(in_grid_of(mechanism_joint_fields()), mechanism_joints_csv)}};
  for (const auto &[name, table] : tables)
    if (page.find("\n\n" + table + '\n') != page.npos)
      std::cout << name << ": OK\n";
    else
      std::cout << name << " has not this table in doc/results.md:\n"
                << table << '\n';
}

const RoomTest test("fields_documented", run);
} // namespace test_fields_documented
