// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_journal_h
#define voussoir_base_journal_h

#include <nlohmann/json.hpp>

#include <chrono>
#include <filesystem>
#include <functional>
#include <ios>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace Voussoir
{
/**
 * What the parts of a long computation have found, in a file, so that it goes
 * on from there after an interruption and ends with the same results.
 *
 * Each part has a name and what it found, a tree of numbers and texts. The file
 * is begun when the computation has taken longer than a number of seconds; a
 * process that is killed leaves all that was kept then, but for what it was
 * writing. Threads may share a journal.
 */
class Journal
{
public:
  /** A tree of numbers and texts. */
  using Json = nlohmann::ordered_json;

  /** One that keeps nothing. */
  Journal() = default;
  /** @{ */
  /** Not copied: it is the one that writes its file. */
  Journal(const Journal &) = delete;
  Journal &operator=(const Journal &) = delete;
  /** @} */

  /** Keep what is found from now on. */
  struct Place
  {
    /** The file, in a directory that may not exist yet. */
    std::filesystem::path file;
    /** What tells the computation from others, in one level of members. */
    Json identity;
    /** When the file is begun, in seconds from now. */
    double after;
    /** Called when it is begun; may be null. */
    std::function<void()> when_begun = nullptr;
  };
  /**
   * Begin it, in the place of one that may be there.
   *
   * @param place of it.
   * @param resumes whether to take what the file has instead.
   * @throws InputError if @p resumes and there is no such file, or it is of
   *   another computation; the message says what differs.
   */
  void begin(Place place, bool resumes);

  /** What the part @p name has found; null if it has to be looked for. */
  Json find(const std::string &name) const;
  /**
   * True if a part that is not at its end may keep where it is: not more often
   * than every ten seconds, and than takes a twentieth of the time.
   */
  bool is_due() const;
  /**
   * Keep what the part @p name has found, in the place of what it had before.
   *
   * @throws InputError, or a filesystem_error, if the file cannot be written.
   */
  void keep(const std::string &name, const Json &found);
  /** Remove the file: the results are there. */
  void end();

private:
  using Clock = std::chrono::steady_clock;

  void read();
  void write(const std::filesystem::path &file,
             const std::string &records,
             std::ios::openmode mode) const;
  void write_all();
  void append(const std::string &name);
  double seconds_since(Clock::time_point then) const;
  [[noreturn]] void refuse(const std::string &fault) const;

  mutable std::mutex mutex;
  Place place = {};
  bool keeps = false;
  /** True if the file is there. */
  bool is_begun = false;
  /** What each has found, as bytes. */
  std::map<std::string, std::string> parts;
  /** Those that are in the file. */
  std::set<std::string> written;
  Clock::time_point start, last_write;
  double seconds_of_write = 0.;
};

/** @{ */
/** Numbers as bytes, with all their digits, and back. */
Journal::Json packed(const std::vector<double> &numbers);
std::vector<double> unpacked(const Journal::Json &bytes);
/** @} */
} // namespace Voussoir

#endif
