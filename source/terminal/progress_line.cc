// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/terminal/interruption.h>
#include <voussoir/terminal/progress_line.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <new>
#include <ostream>
#include <sstream>

namespace Voussoir
{
namespace
{
std::string text_of_time(const double seconds)
{
  const auto s = static_cast<unsigned long>(std::ceil(seconds));
  if (s < 60)
    return text(s, " s");
  if (s < 3600)
    return text(s / 60, " min ", s % 60, " s");
  return text(s / 3600, " h ", s % 3600 / 60, " min");
}

double seconds_of(const ProgressLine::Clock::duration time)
{
  return std::chrono::duration<double>(time).count();
}

/** A rate with three digits, and all of them before the point. */
std::string text_of_rate(const double rate)
{
  std::ostringstream out;
  out << (rate >= 100. ? std::fixed : std::defaultfloat)
      << std::setprecision(rate >= 100. ? 0 : 3) << rate;
  return out.str();
}
} // namespace

std::string text_of_progress(const Progress &progress)
{
  if (progress.total == 0)
    return text_of_time(progress.seconds) +
           (progress.state.empty() ? "" : ", " + progress.state);
  const std::string found =
      text(progress.done, " of ", progress.total, ' ', progress.things, ", ");
  if (progress.done == 0 || !(progress.counted_for > 0.))
    return found + text_of_time(progress.seconds);
  const double rate = progress.done / progress.counted_for;
  const double left = (progress.total - progress.done) / rate - progress.since;
  return found + text_of_rate(rate) + " a second, " +
         text_of_time(std::max(left, 1.)) + " left";
}

ProgressLine::ProgressLine(std::ostream &out,
                           const Screen &screen,
                           const Clock::duration patience,
                           const Clock::duration interval)
    : out(out), width(screen.width), patience(patience), interval(interval),
      thread([this] { run(); })
{}

ProgressLine::~ProgressLine()
{
  {
    const std::lock_guard<std::mutex> lock(mutex);
    clear();
    leave = true;
  }
  changed.notify_all();
  thread.join();
}

void ProgressLine::begin(const std::string &stage)
{
  const std::lock_guard<std::mutex> lock(mutex);
  clear();
  name = stage;
  progress = {};
  began = Clock::now();
}

void ProgressLine::say(const std::string &state)
{
  const std::lock_guard<std::mutex> lock(mutex);
  progress.state = state;
  progress.total = 0; // what was counted is done
}

void ProgressLine::count(const std::size_t done,
                         const std::size_t total,
                         const std::string &things)
{
  const std::lock_guard<std::mutex> lock(mutex);
  if (progress.total == 0)
    began_to_count = Clock::now();
  progress.done = done;
  progress.total = total;
  progress.things = things;
  counted = Clock::now();
  progress.counted_for = seconds_of(counted - began_to_count);
}

void ProgressLine::end()
{
  const std::lock_guard<std::mutex> lock(mutex);
  clear();
  name.clear();
}

void ProgressLine::write(const std::string &lines)
{
  const std::lock_guard<std::mutex> lock(mutex);
  clear();
  out << lines << std::flush;
}

void ProgressLine::run()
{
  for (;;)
  {
    {
      std::unique_lock<std::mutex> lock(mutex);
      if (!leave)
        changed.wait_for(lock, interval);
      if (leave)
        return;
    }
    const Uninterrupted whole; // nothing is shown behind the last message
    const std::lock_guard<std::mutex> lock(mutex);
    const Clock::time_point now = Clock::now();
    if (!name.empty() && now - began >= patience)
      show(now);
  }
}

void ProgressLine::clear()
{
  if (shown)
    out << clear_line << std::flush;
  shown = false;
}

void ProgressLine::show(const Clock::time_point now)
try
{
  progress.seconds = seconds_of(now - began);
  progress.since = seconds_of(now - counted);
  // A line that is too long would go on in the next, which is not cleared.
  const std::string line = "  " + name + ": " + text_of_progress(progress);
  out << clear_line << line.substr(0, width - 1) << std::flush;
  shown = true;
}
catch (const std::bad_alloc &)
{
  // The main thread reports that there is no memory.
}
} // namespace Voussoir
