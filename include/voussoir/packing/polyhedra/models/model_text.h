// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_models_model_text_h
#define voussoir_packing_polyhedra_models_model_text_h

#include <deal.II/base/point.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace Voussoir
{
/**
 * The lines of a text file with a model, and the words in them.
 *
 * Numbers are read whatever the locale is; "nan" and "inf" are numbers, and so
 * is what is too large for one: a block that has such is refused later, with
 * all other faults.
 */
class ModelText
{
public:
  /**
   * @param format the name of the format, for messages.
   * @throws InputError if the file cannot be read, or is in UTF-16.
   */
  ModelText(const std::filesystem::path &file, const std::string &format);

  /**
   * Go on to the next line that is neither empty nor begins with #; false if
   * there is none. A line that ends with a backslash goes on in the next one.
   */
  bool next_line();
  /** Go on to the next line; refuse the file, which lacks @p what, else. */
  void expect_line(const std::string &what);

  /** The words of the line, which next_line() forgets. */
  const std::vector<std::string_view> &words() const { return words_of_line; }
  /** True if a line begins with @p word, in small or capital letters. */
  bool begins_with(const std::string_view word) const;
  /** The line from a word on, without spaces at the end; empty behind it. */
  std::string rest(std::size_t word) const;
  /** The number of the line, from one. */
  unsigned int line() const { return number_of_line; }
  /** The number of bytes of the text. */
  std::size_t n_bytes() const { return content.size(); }

  /**
   * Three numbers from a word on; lengths.
   *
   * @throws InputError naming the line if they are none.
   */
  dealii::Point<3> point(std::size_t word) const;
  /**
   * The whole number that a word is.
   *
   * @param expected what it should be, for the message.
   * @throws InputError naming the line if it is not from @p least to @p most.
   */
  long long integer(std::size_t word,
                    const std::string &expected,
                    long long least,
                    long long most) const;

  /** The sentence that the file cannot be read in this line. */
  std::string fault_in_line(const std::string &fault) const;
  /** @throws InputError that the file cannot be read in this line. */
  [[noreturn]] void refuse(const std::string &fault) const;
  /** @throws InputError that the file has the @p fault. */
  [[noreturn]] void refuse_file(const std::string &fault) const;

private:
  const std::filesystem::path file;
  const std::string format;
  std::string content;
  std::size_t next = 0; // where the next line begins
  std::string current;
  std::vector<std::string_view> words_of_line;
  unsigned int number_of_line = 0;
  unsigned int n_lines = 0; // that were read
};

/** The bytes of a file. @throws InputError if it cannot be read. */
std::string read_model_bytes(const std::filesystem::path &file);
} // namespace Voussoir

#endif
