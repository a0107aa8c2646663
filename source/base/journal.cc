// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/journal.h>
#include <voussoir/base/text_file.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <system_error>
#include <utility>

namespace Voussoir
{
namespace fs = std::filesystem;

namespace
{
/** The least seconds between two writes of a part that is not at its end, and
 * the least number of times that a write takes. */
constexpr double least_interval = 10., intervals_of_write = 20.;

/** A tree as bytes of CBOR, with all digits and what is not finite. */
std::string bytes_of(const Journal::Json &content)
{
  std::string bytes;
  Journal::Json::to_cbor(content, bytes);
  return bytes;
}

/** Discarded if they are not those of a tree. */
Journal::Json tree_of(const std::string &bytes)
{
  return Journal::Json::from_cbor(bytes, true, false);
}

/** Some bytes with their length before them. */
std::string with_length(const std::string &bytes)
{
  const std::uint64_t length = bytes.size();
  std::string with(sizeof(length), '\0');
  std::memcpy(with.data(), &length, sizeof(length));
  return with + bytes;
}

/** What stands in a text with lengths before, but for what is cut off. */
std::vector<std::string> records_in(const std::string &text)
{
  std::vector<std::string> records;
  std::uint64_t length;
  for (std::size_t at = 0; at + sizeof(length) <= text.size(); at += length)
  {
    std::memcpy(&length, text.data() + at, sizeof(length));
    at += sizeof(length);
    if (length > text.size() - at)
      break;
    records.push_back(text.substr(at, length));
  }
  return records;
}
} // namespace

double Journal::seconds_since(const Clock::time_point then) const
{
  return std::chrono::duration<double>(Clock::now() - then).count();
}

void Journal::refuse(const std::string &fault) const
{
  throw InputError("--resume: '" + place.file.string() + "' " + fault);
}

void Journal::begin(Place place_in, const bool resumes)
{
  place = std::move(place_in);
  keeps = true;
  start = last_write = Clock::now();
  is_begun = false;
  parts.clear();
  written.clear();
  if (resumes)
    read();
  else
  {
    std::error_code ignored;
    fs::remove(place.file, ignored);
  }
}

void Journal::read()
{
  const std::optional<std::string> text = bytes_of_file(place.file);
  if (!text)
    refuse("is not there: nothing was interrupted in this directory after "
           "'Output/Checkpoint after', or its results are complete. Run "
           "without --resume.");
  // The identity, and then a name and what was found in turn.
  const std::vector<std::string> records = records_in(*text);
  const Json before = records.empty() ? Json() : tree_of(records.front());
  if (!before.is_object())
    refuse("cannot be read. Run without --resume.");
  for (const auto &[name, value] : place.identity.items())
    if (!before.contains(name) || before.at(name) != value)
      refuse("is of a run with another '" + name +
             "': " + (before.contains(name) ? before.at(name).dump() : "none") +
             ", now " + value.dump() +
             ". Make it the same, or run without --resume.");
  for (std::size_t k = 1; k + 1 < records.size(); k += 2)
    parts[records[k]] = records[k + 1];
  // From now on without a record that was cut off.
  write_all();
}

Journal::Json Journal::find(const std::string &name) const
{
  const std::lock_guard<std::mutex> lock(mutex);
  const auto found = parts.find(name);
  return found == parts.end() ? Json() : tree_of(found->second);
}

bool Journal::is_due() const
{
  const std::lock_guard<std::mutex> lock(mutex);
  if (!keeps || (!is_begun && seconds_since(start) < place.after))
    return false;
  return place.after == 0. ||
         seconds_since(last_write) >=
             std::max(least_interval, intervals_of_write * seconds_of_write);
}

void Journal::keep(const std::string &name, const Json &found)
{
  if (!keeps)
    return;
  std::string bytes = bytes_of(found);
  const std::lock_guard<std::mutex> lock(mutex);
  parts[name] = std::move(bytes);
  if (!is_begun && seconds_since(start) < place.after)
    return;
  const Clock::time_point before = Clock::now();
  if (!is_begun || written.count(name) > 0)
    write_all();
  else
    append(name);
  last_write = Clock::now();
  seconds_of_write = seconds_since(before);
}

/** Write @p records behind what @p file has, or anew. */
void Journal::write(const fs::path &file,
                    const std::string &records,
                    const std::ios::openmode mode) const
{
  std::ofstream out(file, std::ios::binary | mode);
  if (!out.write(records.data(), records.size()).flush())
    throw InputError(
        "'" + file.string() +
        "' cannot be written: the disk may be full. Make room, or set "
        "'Output/Checkpoint after' to more seconds than the run takes.");
}

/** Write a new file beside the old one, and put it in its place. */
void Journal::write_all()
{
  std::error_code ignored;
  if (!place.file.parent_path().empty())
    fs::create_directories(place.file.parent_path(), ignored);
  std::string records = with_length(bytes_of(place.identity));
  for (const auto &[name, found] : parts)
  {
    records += with_length(name) + with_length(found);
    written.insert(name);
  }
  const fs::path beside = place.file.string() + ".new";
  write(beside, records, std::ios::trunc);
  fs::rename(beside, place.file);
  if (!std::exchange(is_begun, true) && place.when_begun)
    place.when_begun();
}

void Journal::append(const std::string &name)
{
  // In one call, so that it is cut off at most at the end of the file.
  write(place.file, with_length(name) + with_length(parts.at(name)),
        std::ios::app);
  written.insert(name);
}

void Journal::end()
{
  const std::lock_guard<std::mutex> lock(mutex);
  if (!keeps)
    return;
  std::error_code ignored;
  for (const std::string ending : {"", ".new"})
    fs::remove(place.file.string() + ending, ignored);
  keeps = false;
}

Journal::Json packed(const std::vector<double> &numbers)
{
  std::vector<std::uint8_t> bytes(numbers.size() * sizeof(double));
  if (!numbers.empty())
    std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return Journal::Json::binary(std::move(bytes));
}

std::vector<double> unpacked(const Journal::Json &bytes)
{
  const auto &content = bytes.get_binary();
  std::vector<double> numbers(content.size() / sizeof(double));
  if (!numbers.empty())
    std::memcpy(numbers.data(), content.data(), content.size());
  return numbers;
}
} // namespace Voussoir
