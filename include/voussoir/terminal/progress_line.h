// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_terminal_progress_line_h
#define voussoir_terminal_progress_line_h

#include <voussoir/terminal/screen.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <iosfwd>
#include <mutex>
#include <string>
#include <thread>

namespace Voussoir
{
/** The progress of a stage. */
struct Progress
{
  std::size_t done = 0;    /**< of total */
  std::size_t total = 0;   /**< 0: not known */
  std::string things;      /**< those counted, in the plural */
  std::string state;       /**< a text, if nothing is counted */
  double seconds = 0.;     /**< since the stage began */
  double counted_for = 0.; /**< seconds in which done was reached */
  double since = 0.;       /**< seconds since then */
};

/**
 * "12 s" with the state behind it or, where things are counted, "50 of 200
 * cells, 10 a second, 15 s left"; the remaining time is that at the mean rate
 * so far. As long as nothing is done there is no rate, but the time.
 */
std::string text_of_progress(const Progress &progress);

/**
 * A line at the bottom of a screen that says how far a stage has come, from two
 * seconds after its beginning on, and is written over every second. A thread of
 * its own does that, so that it goes on while a library works and says nothing.
 */
class ProgressLine
{
public:
  using Clock = std::chrono::steady_clock; /**< of all times here */

  /**
   * @param out a stream to a screen that overwrites.
   * @param patience the time after which a stage is shown.
   * @param interval the time between two versions of the line.
   */
  ProgressLine(std::ostream &out,
               const Screen &screen,
               Clock::duration patience = std::chrono::seconds(2),
               Clock::duration interval = std::chrono::seconds(1));
  ~ProgressLine();
  ProgressLine(const ProgressLine &) = delete;

  /** The stage @p name begins. */
  void begin(const std::string &name);
  /** Show a text on the stage. */
  void say(const std::string &state);
  /** @p done of @p total things are done. */
  void count(std::size_t done, std::size_t total, const std::string &things);
  /** The stage ends; what was shown is cleared. */
  void end();

  /** Clear what is shown and write @p lines; the stage goes on. */
  void write(const std::string &lines);

private:
  void run();
  void clear();
  void show(Clock::time_point now);

  std::ostream &out;
  const unsigned int width;
  const Clock::duration patience, interval;

  std::mutex mutex; // of all that follows, and of out
  std::condition_variable changed;
  bool leave = false;
  bool shown = false;
  /** Empty between stages. */
  std::string name;
  Progress progress;
  Clock::time_point began, began_to_count, counted;
  std::thread thread;
};
} // namespace Voussoir

#endif
