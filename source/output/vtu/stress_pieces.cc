// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/vtu/stress_pieces.h>
#include <voussoir/output/vtu/stress_vtu.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

namespace Voussoir
{
namespace
{
std::vector<char> characters(const std::string &text)
{
  return {text.begin(), text.end()};
}

StressedCells shown(const StressPart &part)
{
  return {part.packing, part.stress, part.motion, part.first_cell};
}

std::string name_of_piece(const std::string &process)
{
  return "stress_" + process + ".vtu";
}

/** @return why that failed; empty if it did not. */
std::string write(const StressPart &part, const std::string &path)
{
  errno = 0;
  std::ofstream out(path);
  write_stress_vtu(out, shown(part));
  out.close();
  if (out)
    return {};
  return errno != 0 ? std::strerror(errno) : "it cannot be written";
}
} // namespace

void write_stress_pieces(ResultDirectory &files,
                         const StressPart &part,
                         const ProcessGroup &processes)
{
  std::vector<std::string> names;
  std::vector<std::vector<char>> paths;
  for (unsigned int r = 0; r < processes.size(); ++r)
  {
    names.push_back(name_of_piece(std::to_string(r)));
    paths.push_back(characters(files.place_for(names.back()).string()));
  }
  processes.call(writing_task);
  const auto failures = processes.together([&]() {
    const std::vector<char> path = processes.scatter(paths);
    return processes.gather(
        characters(write(part, std::string(path.begin(), path.end()))));
  });
  for (unsigned int r = 0; r < failures.size(); ++r)
    if (!failures[r].empty())
      files.refuse(
          "process " + std::to_string(r) + " writing " + names[r] +
          " failed: " + std::string(failures[r].begin(), failures[r].end()));
  files.write(stress_pvtu, [&](std::ostream &out) {
    write_stress_pvtu(out, shown(part), names);
  });
}

bool is_stress_piece(const std::string &name)
{
  const std::size_t begin = name.find('_') + 1;
  const std::string process = name.substr(begin, name.find('.') - begin);
  return !process.empty() &&
         process.find_first_not_of("0123456789") == std::string::npos &&
         name == name_of_piece(process);
}

void write_stress_piece(const StressPart &part, const ProcessGroup &processes)
{
  processes.together([&]() {
    const std::vector<char> path = processes.scatter<char>({});
    return processes.gather(
        characters(write(part, std::string(path.begin(), path.end()))));
  });
}
} // namespace Voussoir
