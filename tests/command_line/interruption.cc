// SPDX-License-Identifier: LGPL-2.1-or-later

// SIGINT, SIGTERM and SIGHUP end the program wherever it is: in libraries,
// while files are written and put in place, and under mpirun. The exit status
// and one message say so, and the directory of the results is as it was, or
// has all new ones.

#include "own_directory.h"
#include "tests.h"
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace test_interruption
{
namespace fs = std::filesystem;
using Words = std::vector<std::string>;
using Clock = std::chrono::steady_clock;

constexpr auto patience = std::chrono::seconds(60);

std::string read(const fs::path &file)
{
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/** The files below @p directory with their contents. */
std::map<std::string, std::string> contents(const fs::path &directory)
{
  std::map<std::string, std::string> all;
  if (fs::exists(directory))
    for (const auto &entry : fs::recursive_directory_iterator(directory))
      all[entry.path().string()] = entry.is_directory() ? "" : read(entry);
  return all;
}

bool wait_for(const std::function<bool()> &condition)
{
  const auto end = Clock::now() + patience;
  while (!condition())
  {
    if (Clock::now() > end)
      return false;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  return true;
}

/** A program, with its standard streams in the files "out" and "error". */
class Process
{
public:
  /** @param hangup what it does at SIGHUP, SIG_DFL or SIG_IGN. */
  explicit Process(const Words &words, void (*hangup)(int) = SIG_DFL)
  {
    std::vector<char *> arguments;
    for (const std::string &word : words)
      arguments.push_back(const_cast<char *>(word.c_str()));
    arguments.push_back(nullptr);
    for (const char *name : {"out", "error"})
      fs::remove(name);
    pid = fork();
    if (pid != 0)
      return;
    // The runner of the tests may have it otherwise.
    signal(SIGINT, SIG_DFL);
    signal(SIGTERM, SIG_DFL);
    signal(SIGHUP, hangup);
    for (const auto &[name, stream] :
         {std::make_pair("out", 1), std::make_pair("error", 2)})
      dup2(open(name, O_CREAT | O_TRUNC | O_WRONLY, 0666), stream);
    execv(arguments[0], arguments.data());
    _exit(127);
  }

  bool ended()
  {
    if (!has_ended)
      has_ended = waitpid(pid, &result, WNOHANG) == pid;
    return has_ended;
  }

  /** The exit status; 1000 and the signal if one killed it; 2000: not ended. */
  int status()
  {
    if (!wait_for([&] { return ended(); }))
    {
      kill(pid, SIGKILL);
      return 2000;
    }
    return WIFEXITED(result) ? WEXITSTATUS(result) : 1000 + WTERMSIG(result);
  }

  /** Whether it has a handler of @p signal. */
  bool handles(const int signal) const
  {
    std::ifstream in("/proc/" + std::to_string(pid) + "/status");
    for (std::string line; std::getline(in, line);)
      if (line.rfind("SigCgt:", 0) == 0)
        return ((std::stoull(line.substr(7), nullptr, 16) >> (signal - 1)) &
                1) != 0;
    return false;
  }

  /** For how long it has computed, in seconds. */
  double computed() const
  {
    const std::string stat = read("/proc/" + std::to_string(pid) + "/stat");
    std::istringstream rest(stat.substr(stat.rfind(')') + 1));
    std::string skipped;
    for (int field = 3; field < 14; ++field)
      rest >> skipped;
    double ticks = 0.;
    rest >> ticks;
    return ticks / sysconf(_SC_CLK_TCK);
  }

  /** Its children that run, and theirs. */
  std::vector<pid_t> children() const
  {
    std::vector<pid_t> found = {pid};
    for (unsigned int i = 0; i < found.size(); ++i)
      for (const auto &entry : fs::directory_iterator("/proc"))
      {
        const std::string name = entry.path().filename();
        if (name.find_first_not_of("0123456789") != std::string::npos)
          continue; // not a process
        const std::string stat = read(entry.path() / "stat");
        const std::size_t name_end = stat.rfind(')');
        if (name_end == std::string::npos)
          continue;
        std::istringstream rest(stat.substr(name_end + 1));
        char state = 0;
        pid_t parent = 0;
        rest >> state >> parent;
        if (parent == found[i])
          found.push_back(std::stoi(name));
      }
    found.erase(found.begin());
    return found;
  }

  pid_t pid;

private:
  bool has_ended = false;
  int result = 0;
};

bool runs(const pid_t pid)
{
  const std::string stat = read("/proc/" + std::to_string(pid) + "/stat");
  const std::size_t name_end = stat.rfind(')');
  // What has ended and is not waited for by anybody is a zombie, Z.
  return name_end != std::string::npos && stat[name_end + 2] != 'Z';
}

Words program(const Words &settings)
{
  Words words = {VOUSSOIR_PROGRAM, "scene.prm"};
  for (const std::string &setting : settings)
    words.insert(words.end(), {"--set", setting});
  return words;
}

const std::map<int, std::string> names = {
    {SIGINT, "SIGINT"}, {SIGTERM, "SIGTERM"}, {SIGHUP, "SIGHUP"}};

/** Whether a file @p name of a staging directory in @p directory has grown. */
bool is_being_written(const std::string &directory, const std::string &name)
{
  std::error_code error;
  for (const auto &entry : fs::directory_iterator(directory, error))
    if (entry.path().filename().string().rfind(".voussoir-", 0) == 0)
      return fs::file_size(entry.path() / name, error) > 0 && !error;
  return false;
}

bool has_said(const std::string &words)
{
  return read("out").find(words) != std::string::npos;
}

/** Interrupt a run when @p moment has come; all must be as it was before. */
void interrupt(const std::string &name,
               const int signal,
               const Words &settings,
               const std::function<bool(const Process &)> &moment,
               const std::string &directory = "output")
{
  std::cout << names.at(signal) << " " << name << std::endl;
  const auto before = contents(directory);
  Process process(program(settings));
  bool came = wait_for([&] { return process.handles(signal); });
  came = came && wait_for([&] { return moment(process) || process.ended(); });
  check("  the moment comes", came && !process.ended());
  const std::vector<pid_t> children = process.children();
  kill(process.pid, signal);
  check("  exit status", process.status() == 128 + signal);
  std::string said = read("error");
  // Whether the results had a directory is a matter of microseconds there.
  const std::string not_made = ", and 'output' was not made";
  if (name == "at the start" && said.find(not_made) != std::string::npos)
    said.erase(said.find(not_made), not_made.size());
  std::cout << "  " << said;
  check("  nothing has changed", contents(directory) == before);
  check("  no child stays", wait_for([&] {
          return std::none_of(children.begin(), children.end(), runs);
        }));
}

/** Under mpirun the root alone speaks, and no process stays. */
void interrupt_parallel()
{
  std::cout << "SIGTERM to mpirun" << std::endl;
  const auto before = contents("output");
  Words words;
  std::istringstream launcher(VOUSSOIR_MPIRUN);
  for (std::string word; launcher >> word;)
    words.push_back(word);
  // Large, for mpirun takes its time to pass the signal on.
  const Words rest = program({"Packing/Voronoi/Number of points=200000"});
  words.insert(words.end(), rest.begin(), rest.end());
  Process process(words);
  wait_for([&] { return process.ended() || has_said("Packing"); });
  const std::vector<pid_t> children = process.children();
  check("  there are two processes", children.size() >= 2);
  check("  the moment comes", wait_for([&] {
                                return process.ended() ||
                                       is_being_written("output",
                                                        "interfaces.csv");
                              }) &&
                                  !process.ended());
  const auto start = Clock::now();
  kill(process.pid, SIGTERM);
  check("  it fails", process.status() != 0);
  check("  soon", Clock::now() - start < std::chrono::seconds(20));
  const auto after = contents("output");
  check("  no child stays", wait_for([&] {
          return std::none_of(children.begin(), children.end(), runs);
        }));
  const std::string error = read("error"), message = "voussoir: Interrupted by";
  // mpirun may pass the signal on when all is done.
  const bool is_done = error.find("are complete") != std::string::npos;
  check("  nothing has changed, or it says so", (after == before) != is_done);
  check("  nothing hidden stays",
        std::none_of(after.begin(), after.end(), [](const auto &file) {
          return file.first.find(".voussoir-") != std::string::npos;
        }));
  // Open MPI 5's mpirun may end before it has passed the message on.
  check("  one message at most", error.find(message) == error.rfind(message));
}

/**
 * Interrupt at moments around the one when results are put in place: they are
 * the old ones, or all are new; the message tells which.
 */
void interrupt_publication()
{
  const Words settings = {"Output directory=output", "Output/Files=csv",
                          "Title=new", "Formulation=least energy",
                          "Packing/Voronoi/Number of points=2000"};
  Process whole(program(settings));
  check("Around publication: the run ends", whole.status() == 0);
  const auto now = [] {
    auto all = contents("output");
    all.erase("output/summary.json"); // which has times
    return all;
  };
  const auto complete = now();
  bool right = true;
  unsigned int n_interrupted = 0;
  for (int k = 0; k < 12; ++k)
  {
    fs::remove_all("output");
    Process process(program(settings));
    wait_for([&] {
      return process.ended() || is_being_written("output", "cells.csv");
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(k));
    kill(process.pid, SIGINT);
    const int status = process.status();
    const bool published = now() == complete;
    const bool says_complete =
        read("error").find("the results in 'output' are complete") !=
        std::string::npos;
    n_interrupted += (status == 130);
    right &= status == 130 ? (published && says_complete) ||
                                 (!fs::exists("output") && !says_complete)
                           : status == 0 && published;
  }
  check("  all results or none", right);
  check("  some of these runs were interrupted", n_interrupted > 0);
}

void run()
{
  work_in_own_directory();
  std::ofstream("scene.prm")
      << "subsection Packing\n subsection Voronoi\n"
         "  set Number of points = 12000\n end\nend\n"
         "set Formulation = least energy\n"
         "subsection Loads\n set Traction = -1.2*nx; -0.8*ny\nend\n"
         "subsection Friction\n set Strength = 0.5\nend\n";

  // Where nothing is yet, in CGAL, MUMPS and CHOLMOD
  const auto at_once = [](const Process &) { return true; };
  const auto computing = [](const Process &process) {
    return process.computed() > 3.;
  };
  const auto packed = [](const int milliseconds) {
    return [milliseconds](const Process &) {
      const bool is_packed = has_said("Packing");
      if (is_packed)
        std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
      return is_packed;
    };
  };
  const Words slow = {"Packing/Voronoi/Lloyd steps=1000"};
  const Words ipopt = {"Formulation=smoothed friction"};
  const Words sliding = {"Friction/Strength=0.06"};
  interrupt("at the start", SIGINT, slow, at_once);
  interrupt("in the packing", SIGTERM, slow, computing);
  interrupt("in the solver", SIGINT, ipopt, packed(0));
  interrupt("in the solver", SIGTERM, ipopt, packed(300));
  interrupt("in the solver", SIGHUP, sliding, packed(50));
  check("no directory", !fs::exists("output"));

  // With results of an earlier run, and a file of the user's own
  Process earlier(program({"Packing/Voronoi/Number of points=20"}));
  check("An earlier run", earlier.status() == 0);
  std::ofstream("output/notes.txt") << "the user's own\n";
  interrupt("in the solver", SIGINT, ipopt, packed(150));
  for (const char *file :
       {"interfaces.csv", "cells.csv", "blocks.vtu", "stress.vtu"})
    interrupt(std::string("in ") + file, SIGTERM, {}, [file](const Process &) {
      return is_being_written("output", file);
    });
  interrupt(
      "in a new directory", SIGINT, {"Output directory=a/b/c"},
      [](const Process &) { return is_being_written("a/b/c", "cells.csv"); },
      "a");
  check("no directory", !fs::exists("a"));
  interrupt_parallel();

  // nohup
  Process deaf(program({"Packing/Voronoi/Number of points=20"}), SIG_IGN);
  wait_for([&] { return deaf.handles(SIGINT); });
  kill(deaf.pid, SIGHUP);
  check("SIGHUP that is ignored stays so", deaf.status() == 0);

  fs::remove_all("output");
  interrupt_publication();
}

const RoomTest test("interruption", run);
} // namespace test_interruption
