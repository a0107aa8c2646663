// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_result_directory_h
#define voussoir_output_result_directory_h

#include <voussoir/terminal/interruption.h>
#include <voussoir/terminal/terminal.h>

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <system_error>
#include <vector>

namespace Voussoir
{
/** The files that any run may write, by their names. */
struct FilesOfRuns
{
  /** Results, which a later run replaces or removes. */
  std::vector<std::string> results;
  /** Packings, which are there to be edited: they are removed by no run. */
  std::vector<std::string> packings = {};
  /** True for further results, of which there may be any number. */
  std::function<bool(const std::string &)> is_piece = {};
};

/**
 * The directory that takes the results of a run, complete or not at all: files
 * are written into a hidden directory beside their final place, and publish()
 * renames them, over those of an earlier run. Whatever ends the run before
 * that, an exception or an Interruption, leaves the earlier results untouched
 * and nothing else behind; publish() itself is not interrupted.
 */
class ResultDirectory
{
public:
  /**
   * Make what write() needs, and remove it, so that a long run does not find
   * out at its end that this cannot be.
   *
   * @throws InputError if it cannot.
   * @param all_files those of every run, not only of this one.
   * @param terminal is told which file is being written.
   */
  ResultDirectory(std::filesystem::path directory,
                  FilesOfRuns all_files,
                  Terminal &terminal = Terminal::silent());
  /**
   * @throws InputError if @p input is one of the files that a run may write
   * here: it would be lost.
   */
  void protect(const std::filesystem::path &input) const;

  /** Remove what was written and not published, with directories made for it.
   */
  ~ResultDirectory();
  ResultDirectory(const ResultDirectory &) = delete;
  ResultDirectory &operator=(const ResultDirectory &) = delete;

  /**
   * Write the file @p name, which is one of those of every run, through @p
   * writer.
   *
   * @throws InputError if it cannot be written to the end, for example because
   *   the disk is full.
   */
  void write(const std::string &name,
             const std::function<void(std::ostream &)> &writer);

  /**
   * The path to which another process is to write the file @p name, which
   * counts as written then.
   */
  std::filesystem::path place_for(const std::string &name);

  /** @throws InputError that the results cannot be written, and why. */
  [[noreturn]] void refuse(const std::string &reason) const;

  /**
   * Put all written files in place, in the order in which they were written,
   * and remove those results of an earlier run that this run did not write.
   */
  void publish();

  /** Put written files in place beside the results of an earlier run. */
  void publish_beside();

private:
  bool is_result(const std::string &name) const;
  void put_in_place();
  void finish(Uninterrupted &whole);
  void make_staging(Uninterrupted &whole);
  std::error_code try_to_make_staging();
  void discard();

  std::filesystem::path directory;
  const FilesOfRuns all_files;
  Terminal &terminal;
  std::filesystem::path staging;
  /** The directories that were made for the results, the innermost first. */
  std::vector<std::filesystem::path> created;
  std::vector<std::string> written;
};

/**
 * Remove the files that processes which were killed have written aside in
 * @p directory; no other may be at work there.
 */
void remove_left_over(const std::filesystem::path &directory);
} // namespace Voussoir

#endif
