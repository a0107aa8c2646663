// SPDX-License-Identifier: LGPL-2.1-or-later

// What libFuzzer calls, whichever target runs.

#include "harness.h"

#include <voussoir/base/blas.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/base/parameters/parameter_tree.h>
#include <voussoir/packing/generators/generator.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace Fuzzing
{
namespace
{
/** A line of a message that nobody reads to its end. */
constexpr std::size_t longest_line = 2000;

/** The most of anything that a run may be asked for in an integer. */
constexpr int most_of_anything = 30;

/** The most cells of a packing: what takes its time is no find. */
constexpr double most_cells = 1000.;

/** A control character, which a terminal would obey. */
bool is_control(const char c)
{
  return (static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\t') ||
         c == 0x7f;
}

Target::Read target()
{
  const char *const name = std::getenv("VOUSSOIR_FUZZ_TARGET");
  const auto found = Target::all().find(name ? name : "");
  if (found != Target::all().end())
    return found->second;
  std::cerr << "Set VOUSSOIR_FUZZ_TARGET to the target to run, one of:";
  for (const auto &[known, read] : Target::all())
    std::cerr << ' ' << known;
  std::cerr << std::endl;
  std::exit(1);
}

bool is_small(const Voussoir::Run &run)
{
  bool is_small = true;
  Voussoir::for_each_entry(run.tree(), [&](const std::string &,
                                           const auto &entry) {
    const std::string pattern = entry.at("pattern_description");
    if (pattern.rfind("[Integer", 0) == 0)
      is_small &= std::stoi(entry.at("value").template get<std::string>()) <=
                  most_of_anything;
  });
  return is_small;
}
} // namespace

void write_file(const std::string &name, const std::string &content)
{
  std::ofstream out(name, std::ios::binary);
  if (!(out << content << std::flush))
    std::abort();
}

void check_message(const std::string &message)
{
  std::istringstream in(message);
  bool is_fit = std::none_of(message.begin(), message.end(), is_control);
  for (std::string line; std::getline(in, line);)
    is_fit &= line.size() <= longest_line;
  if (is_fit)
    return;
  std::cerr << "This message has control characters, or a line of more than "
            << longest_line << " characters:\n"
            << message << std::endl;
  std::abort();
}

std::vector<std::string> lines_of(const std::string &text)
{
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  return lines;
}

void with_run(const Voussoir::ParameterSources &sources,
              const std::function<void(Voussoir::Run &)> &action)
{
  std::ostringstream out;
  Voussoir::Terminal terminal(out);
  const std::unique_ptr<Voussoir::Run> run =
      Voussoir::make_run(sources, terminal, {});
  if (!is_small(*run))
    return;
  action(*run);
  check_message(out.str());
}
} // namespace Fuzzing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *const data,
                                      const std::size_t size)
{
  static const Fuzzing::Target::Read read = Fuzzing::target();
  static const bool once =
      (Voussoir::prepare_blas(),
       Voussoir::most_generated_cells = Fuzzing::most_cells, true);
  static_cast<void>(once);
  // In libFuzzer itself they are none of ours.
  const Voussoir::InvalidOperationsTrapped trapped(true);
  try
  {
    read({data, data + size});
  }
  catch (const Voussoir::InputError &error)
  {
    Fuzzing::check_message(error.what());
  }
  return 0;
}
