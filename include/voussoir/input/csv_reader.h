// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_input_csv_reader_h
#define voussoir_input_csv_reader_h

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace Voussoir
{
/**
 * Reads a .csv file as csv.h writes them, line by line: names in the first
 * line, commas between the fields, and no quotes. Of each line the numbers in
 * chosen columns are kept, whatever the order of the columns.
 */
class CsvReader
{
public:
  /** @throws InputError if the file cannot be read or is empty. */
  explicit CsvReader(std::filesystem::path file);

  /** True if the first line has that name. */
  bool has_column(const std::string &name) const;
  /**
   * Read the numbers of the columns @p names.
   *
   * @throws InputError if there is none of that name.
   */
  void choose(const std::vector<std::string> &names);

  /**
   * Read a line.
   *
   * @return true if there was one.
   * @throws InputError if it has not as many fields as the first one, or a
   *   chosen one is not a finite number.
   */
  bool next();
  /** The number in the chosen column @p i of the line that was read last. */
  double operator[](const unsigned int i) const { return values[i]; }

  /** @throws InputError "Line 3 of 'file.csv' " and the @p fault. */
  [[noreturn]] void refuse(const std::string &fault) const;

private:
  /** Split the line into fields; return how many there are. */
  std::size_t split();
  void parse(std::size_t column, std::size_t choice);

  std::filesystem::path file;
  std::ifstream in;
  std::string content;
  std::size_t line = 1;
  std::vector<std::string_view> fields;
  std::vector<std::string> columns;
  /** The columns that are read, and their numbers in the present line. */
  std::vector<std::size_t> chosen;
  std::vector<double> values;
};
} // namespace Voussoir

#endif
