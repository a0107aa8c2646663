// SPDX-License-Identifier: LGPL-2.1-or-later

// Results appear together or not at all, and never at the cost of earlier ones.

#include <voussoir/output/result_directory.h>

#include "tests.h"
#include <atomic>
#include <filesystem>
#include <fstream>
#include <thread>

namespace test_result_directory
{
namespace fs = std::filesystem;
using Voussoir::ResultDirectory;

const Voussoir::FilesOfRuns all_files = {{"stress.vtu", "summary.json"}};

void show(const std::string &when)
{
  std::vector<std::string> names;
  if (fs::exists("results"))
    for (const auto &entry : fs::directory_iterator("results"))
      names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  std::cout << when << ":";
  for (const std::string &name : names)
  {
    std::string content;
    std::getline(std::ifstream("results/" + name) >> std::ws, content);
    std::cout << ' ' << name << " = " << content << ';';
  }
  std::cout << std::endl;
}

void run()
{
  fs::remove_all("results");
  fs::remove_all("new");
  const auto writer = [](const std::string &content) {
    return [content](std::ostream &out) { out << content << '\n'; };
  };
  {
    ResultDirectory files("results", all_files);
    show("nothing yet");
    files.write("stress.vtu", writer("first"));
    files.write("summary.json", writer("first"));
    files.publish();
  }
  show("first run");
  std::ofstream("results/notes.txt") << "the user's own\n";
  try
  {
    ResultDirectory files("results", all_files);
    files.write("summary.json", writer("second"));
    throw std::runtime_error("the run fails");
  }
  catch (const std::runtime_error &)
  {}
  show("after a failure");
  show_refusal([&] {
    ResultDirectory files("results", all_files);
    files.write("summary.json",
                [](std::ostream &out) { out.setstate(std::ios::badbit); });
  });
  show("after a failing disk");
  {
    ResultDirectory files("results", all_files);
    files.write("summary.json", writer("third"));
    files.publish();
  }
  show("a run without stress.vtu");

  show_refusal([] {
    ResultDirectory files("new/below", all_files);
    files.write("summary.json",
                [](std::ostream &out) { out.setstate(std::ios::badbit); });
  });
  check("no directory stays for results that are not there",
        !fs::exists("new"));

  // Before anything is solved: a name that no file system takes.
  show_refusal(
      [] { ResultDirectory("new/" + std::string(300, 'x'), all_files); });
  const ResultDirectory trial("new/below", all_files);
  check("nothing stays of a trial", !fs::exists("new"));

  // Runs of a sweep make and remove the directory above all of theirs.
  std::atomic<bool> are_made = true;
  std::vector<std::thread> threads;
  for (const char *name : {"new/run_1", "new/run_2"})
    threads.emplace_back([name, &are_made] {
      for (unsigned int k = 0; k < 2000; ++k)
        try
        {
          const ResultDirectory files(name, all_files);
        }
        catch (const Voussoir::InputError &)
        {
          are_made = false;
        }
    });
  for (std::thread &thread : threads)
    thread.join();
  check("two runs at once", are_made);
  fs::remove_all("new");

  std::ofstream("file") << "in the way\n";
  try
  {
    ResultDirectory files("file/below", all_files);
    std::cout << "FAILED" << std::endl;
  }
  catch (const Voussoir::InputError &error)
  {
    check("a file in the way is refused",
          std::string(error.what()).find("is not a directory") !=
              std::string::npos);
  }
}

const RoomTest test("result_directory", run);
} // namespace test_result_directory
