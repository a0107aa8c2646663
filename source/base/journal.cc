// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/journal.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
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

/** A record: its length, and that many bytes of CBOR. */
std::string record_of(const Journal::Json &content)
{
  const std::vector<std::uint8_t> bytes = Journal::Json::to_cbor(content);
  const std::uint64_t length = bytes.size();
  std::string record(sizeof(length) + bytes.size(), '\0');
  std::memcpy(record.data(), &length, sizeof(length));
  std::memcpy(record.data() + sizeof(length), bytes.data(), bytes.size());
  return record;
}

/** The records of a text, but for one that is cut off. */
std::vector<Journal::Json> records_in(const std::string &text)
{
  std::vector<Journal::Json> records;
  std::uint64_t length;
  for (std::size_t at = 0; at + sizeof(length) <= text.size(); at += length)
  {
    std::memcpy(&length, text.data() + at, sizeof(length));
    at += sizeof(length);
    if (length > text.size() - at)
      break;
    const char *const begin = text.data() + at;
    Journal::Json record =
        Journal::Json::from_cbor(begin, begin + length, true, false);
    if (record.is_discarded())
      break;
    records.push_back(std::move(record));
  }
  return records;
}

/** A name and what was found. */
Journal::Json record_of_part(const std::string &name,
                             const Journal::Json &found)
{
  return Journal::Json::array({name, found});
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
  std::ifstream in(place.file, std::ios::binary);
  if (!in)
    refuse("is not there: nothing was interrupted in this directory after "
           "'Output/Checkpoint after', or its results are complete. Run "
           "without --resume.");
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  const std::vector<Json> records = records_in(text);
  if (records.empty() || !records.front().is_object())
    refuse("cannot be read. Run without --resume.");
  const Json &identity = records.front();
  for (const auto &[name, value] : place.identity.items())
    if (!identity.contains(name) || identity.at(name) != value)
      refuse("is of a run with another '" + name + "': " +
             (identity.contains(name) ? identity.at(name).dump() : "none") +
             ", now " + value.dump() +
             ". Make it the same, or run without --resume.");
  for (std::size_t k = 1; k < records.size(); ++k)
    if (const Json &part = records[k]; part.is_array() && part.size() == 2)
      parts[part[0].get<std::string>()] = part[1];
  // From now on without a record that was cut off.
  write_all();
}

const Journal::Json *Journal::find(const std::string &name) const
{
  const std::lock_guard<std::mutex> lock(mutex);
  const auto found = parts.find(name);
  return found == parts.end() ? nullptr : &found->second;
}

bool Journal::is_due() const
{
  const std::lock_guard<std::mutex> lock(mutex);
  if (!keeps || seconds_since(start) < place.after)
    return false;
  return place.after == 0. ||
         seconds_since(last_write) >=
             std::max(least_interval, intervals_of_write * seconds_of_write);
}

void Journal::keep(const std::string &name, Json found)
{
  const std::lock_guard<std::mutex> lock(mutex);
  if (!keeps)
    return;
  parts[name] = std::move(found);
  if (seconds_since(start) < place.after)
    return;
  const Clock::time_point before = Clock::now();
  if (written.empty() || written.count(name) > 0)
    write_all();
  else
    append(name);
  last_write = Clock::now();
  seconds_of_write = seconds_since(before);
}

/** Write a new file beside the old one, and put it in its place. */
void Journal::write_all()
{
  std::error_code error;
  if (!place.file.parent_path().empty())
    fs::create_directories(place.file.parent_path(), error);
  const fs::path beside = place.file.string() + ".new";
  {
    std::ofstream out(beside, std::ios::binary);
    out << record_of(place.identity);
    for (const auto &[name, found] : parts)
    {
      out << record_of(record_of_part(name, found));
      written.insert(name);
    }
    if (!out.flush())
      throw InputError(
          "'" + beside.string() +
          "' cannot be written: the disk may be full. Make room, or set "
          "'Output/Checkpoint after' to more seconds than the run "
          "takes.");
  }
  fs::rename(beside, place.file);
}

void Journal::append(const std::string &name)
{
  std::ofstream out(place.file, std::ios::binary | std::ios::app);
  // In one call, so that it is cut off at most at the end of the file.
  const std::string record = record_of(record_of_part(name, parts.at(name)));
  out.write(record.data(), record.size());
  if (!out.flush())
    throw InputError(
        "'" + place.file.string() +
        "' cannot be written: the disk may be full. Make room, or set "
        "'Output/Checkpoint after' to more seconds than the run "
        "takes.");
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
