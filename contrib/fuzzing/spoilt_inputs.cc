// SPDX-License-Identifier: LGPL-2.1-or-later

// The program of the test command_line/spoilt_inputs, in the place of
// libFuzzer: spoilt_inputs SEEDS N reads the files of the directory SEEDS, and
// N inputs that are made of them, by the target that VOUSSOIR_FUZZ_TARGET
// names. The last one is in the file "input".

#include <voussoir/base/text_file.h>

#include "changes.h"
#include "harness.h"
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iostream>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data,
                                      std::size_t size);

namespace
{
void read(const std::string &input)
{
  Fuzzing::write_file("input", input);
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t *>(input.data()),
                         input.size());
}
} // namespace

int main(const int argc, const char *const *const argv)
{
  constexpr int n_words = 3;
  if (argc != n_words)
    return 1;
  std::vector<std::filesystem::path> files;
  for (const auto &entry : std::filesystem::directory_iterator(argv[1]))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<std::string> seeds;
  for (const std::filesystem::path &file : files)
    seeds.push_back(Voussoir::bytes_of_file(file).value());
  for (const std::string &seed : seeds)
    read(seed);
  Fuzzing::Changes changes(seeds, 1);
  for (int n = std::stoi(argv[2]); n > 0; --n)
    read(changes.next());
  return 0;
}
