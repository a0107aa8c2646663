// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/print_parameters.h>
#include <voussoir/base/parameters/reference.h>
#include <voussoir/base/printable.h>
#include <voussoir/run/command_line/arguments.h>
#include <voussoir/run/command_line/bash_completion.h>
#include <voussoir/run/command_line/command_line.h>
#include <voussoir/run/command_line/proof_script.h>
#include <voussoir/run/make_run.h>
#include <voussoir/run/reproduction.h>
#include <voussoir/run/sweep/search.h>
#include <voussoir/run/sweep/sweep.h>
#include <voussoir/run/variables.h>
#include <voussoir/scene/scene_parameters.h>
#include <voussoir/version.h>

#include <deal.II/base/exceptions.h>

#include <filesystem>
#include <memory>
#include <new>
#include <optional>
#include <ostream>
#include <sstream>
#include <system_error>

namespace Voussoir
{
namespace
{
/** The exit status of the program; see run_command_line(). */
enum class ExitStatus
{
  solved = 0,
  another_answer = 1,
  bad_input = 2,
  load_not_carried = 3,
  solver_failed = 4
};

/** The streams of the program, and the devices behind them. */
struct Streams
{
  std::ostream &out;
  std::ostream &error;
  const Screens &screens;
};

/** Print @p text; throws an InputError unless all of it is written. */
ExitStatus print(std::ostream &out, const std::string &text)
{
  if (!(out << text << std::flush))
    throw InputError("The output cannot be written; is the disk full, or has "
                     "its reader gone?");
  return ExitStatus::solved;
}

/** Run a scene many times, if that is asked for. */
bool run_many(const Arguments &arguments,
              const ProcessGroup &processes,
              Terminal &terminal)
{
  const bool finds = !arguments.find.empty();
  if (arguments.sweeps.empty() && arguments.writes_critical)
    throw InputError("--critical belongs to --sweep. See 'voussoir --help'.");
  if (arguments.sweeps.empty() && !finds)
  {
    if (!arguments.results.empty() || arguments.has_directories)
      throw InputError("--result and --directories belong to --sweep or "
                       "--find. See 'voussoir --help'.");
    return false;
  }
  if (arguments.validate)
    throw InputError("--validate looks at one scene; give it without --sweep "
                     "and --find.");
  if (finds && !arguments.sweeps.empty())
    throw InputError("--sweep and --find are given; give one of them.");
  if (processes.size() > 1)
    throw InputError("--sweep and --find use the cores of one process; give "
                     "them without mpirun.");
  if (arguments.file.empty())
    throw InputError("No parameter file is given. Run 'voussoir FILE.prm', or "
                     "see 'voussoir --help'.");
  const ManyRuns runs = {arguments.file,
                         arguments.assignments,
                         arguments.results,
                         arguments.has_directories,
                         arguments.writes_critical,
                         arguments.resumes};
  if (finds)
  {
    search(runs, read_search_range(arguments.find), terminal);
    return true;
  }
  std::vector<SweepAxis> axes;
  for (const std::string &text : arguments.sweeps)
    axes.push_back(read_sweep_axis(text));
  sweep(runs, axes, terminal);
  return true;
}

/** Whether anything is given besides what concerns results that are there. */
bool has_others(const Arguments &arguments)
{
  return !arguments.file.empty() || !arguments.assignments.empty() ||
         !arguments.sweeps.empty() || !arguments.find.empty() ||
         !arguments.results.empty() || arguments.has_directories ||
         arguments.writes_critical || arguments.validate || arguments.resumes ||
         arguments.print_parameters || arguments.print_settings ||
         arguments.print_schema || arguments.print_reference ||
         arguments.print_completion;
}

/** Prove results again that are there. */
ExitStatus check(const Arguments &arguments, const Streams &streams)
{
  if (has_others(arguments) || !arguments.reproduced.empty())
    throw InputError("--check takes directories of results; give it without a "
                     "file of parameters and other options than --quiet.");
  const bool are_proven =
      prove_again(arguments.checked, [&](const std::string &line) {
        if (!arguments.quiet)
          streams.out << printable(line) << std::endl;
        else if (line.find(": WRONG, ") != line.npos)
          streams.error << printable(line) << std::endl;
      });
  return are_proven ? ExitStatus::solved : ExitStatus::another_answer;
}

/** Make results again that are there. */
ExitStatus run_again(const Arguments &arguments,
                     const ProcessGroup &processes,
                     Terminal &terminal)
{
  if (has_others(arguments))
    throw InputError(
        "--reproduce takes the parameters beside the summary; give "
        "it without a file of parameters and other options than "
        "--quiet.");
  return reproduce(arguments.reproduced, terminal, processes)
             ? ExitStatus::solved
             : ExitStatus::another_answer;
}

/** A text that is asked for besides runs. */
std::optional<std::string> text_to_print(const Arguments &arguments)
{
  if (arguments.help)
    return help();
  if (arguments.version)
    return "voussoir " VOUSSOIR_VERSION "\n";
  return {};
}

/** One that tells of the parameters. */
std::optional<std::string> text_of_parameters(const Arguments &arguments,
                                              Run &run)
{
  std::ostringstream text;
  if (arguments.print_parameters || arguments.print_settings)
    run.print(text, arguments.print_parameters.value_or(""),
              parameter_format_of(arguments.format.value_or("prm")),
              arguments.print_settings ? Detail::value : Detail::listing);
  else if (arguments.print_schema)
  {
    std::vector<std::string> of_users = {variables_section};
    if (run.dimension() == 2)
      for (const std::string &section : SceneParameters::sections_of_users())
        of_users.push_back(section);
    print_schema(text, run.entries(), of_users);
  }
  else if (arguments.print_reference)
    write_reference(text, run.entries(),
                    run.dimension() == 3 ? "Parameters in space" : "Parameters",
                    run.dimension() == 3 ? " --set Dimension=3" : "");
  else if (arguments.print_completion)
    print_bash_completion(text, option_names(), run.tree());
  else
    return {};
  return text.str();
}

ExitStatus fail(const Streams &streams,
                const ExitStatus status,
                const std::string &message)
{
  streams.error << streams.screens.error.bad("voussoir:") << ' '
                << printable(message) << std::endl;
  return status;
}

ExitStatus run(const Arguments &arguments,
               const Streams &streams,
               const ProcessGroup &processes)
{
  if (const auto text = text_to_print(arguments))
    return print(streams.out, *text);
  if (!arguments.checked.empty())
    return check(arguments, streams);
  // A quiet run shows warnings only, which belong to the errors.
  Terminal terminal = arguments.quiet
                          ? Terminal(streams.error, 1, streams.screens.error)
                          : Terminal(streams.out, 1, streams.screens.out);
  if (arguments.quiet)
    terminal.be_quiet();
  if (!arguments.reproduced.empty())
    return run_again(arguments, processes, terminal);
  if (run_many(arguments, processes, terminal))
    return ExitStatus::solved;
  ParameterSources sources;
  if (!arguments.file.empty())
    sources.file = arguments.file;
  sources.assignments = arguments.assignments;
  // Sections and variables by any name.
  const bool is_plane = dimension_of(sources) == 2;
  if (is_plane && (arguments.print_schema || arguments.print_reference))
    sources.assignments.insert(
        sources.assignments.end(),
        {ties_section + "/NAME/Prestress=0", fill_section + "/NAME/Top=0"});
  if (is_plane && arguments.print_schema)
    sources.assignments.push_back(load_cases_section +
                                  "/NAME/Boundary load=traction");
  if (arguments.print_schema)
    sources.assignments.push_back(variables_section + "/NAME=0");
  const std::unique_ptr<Run> run = make_run(sources, terminal, processes);
  if (const auto text = text_of_parameters(arguments, *run))
    return print(streams.out, *text);
  if (arguments.file.empty())
    throw InputError("No parameter file is given. Run 'voussoir FILE.prm', or "
                     "see 'voussoir --help'.");
  // The directory of the file itself, should its name be a link; relative to
  // the working directory, for messages that a user recognises.
  namespace fs = std::filesystem;
  const fs::path directory =
      fs::proximate(fs::canonical(arguments.file).parent_path());
  if (arguments.validate)
  {
    run->validate(directory);
    return ExitStatus::solved;
  }
  terminal.set_verbosity(run->verbosity());
  if (arguments.resumes)
    run->resume();
  const std::string message = run->carry_out(directory, true).message;
  return message.empty() ? ExitStatus::solved
                         : fail(streams, ExitStatus::load_not_carried, message);
}

constexpr const char *no_memory =
    "There is not enough memory for this packing.";

/** Run, whatever is thrown. */
ExitStatus run_to_its_end(const std::vector<std::string> &words,
                          const Streams &streams,
                          const ProcessGroup &processes)
{
  try
  {
    return run(arguments_of(words), streams, processes);
  }
  catch (const InputError &e)
  {
    return fail(streams, ExitStatus::bad_input, e.what());
  }
  catch (const std::filesystem::filesystem_error &e)
  {
    return fail(streams, ExitStatus::bad_input,
                std::string("A file or directory cannot be used: ") + e.what());
  }
  catch (const SolverError &e)
  {
    return fail(streams, ExitStatus::solver_failed, e.what());
  }
  catch (const std::bad_alloc &)
  {
    return fail(streams, ExitStatus::solver_failed, no_memory);
  }
  catch (const dealii::StandardExceptions::ExcOutOfMemory &)
  {
    return fail(streams, ExitStatus::solver_failed, no_memory);
  }
  catch (const std::system_error &e)
  {
    return fail(streams, ExitStatus::solver_failed,
                std::string("The system refuses what the program needs, such "
                            "as a thread: ") +
                    e.what() +
                    ". End other programs, or raise the limits that 'ulimit "
                    "-a' shows.");
  }
  catch (const std::exception &e)
  {
    return fail(streams, ExitStatus::solver_failed,
                std::string("An unexpected error, which is a defect of the "
                            "program, ended the run:\n") +
                    e.what());
  }
  catch (...) // Trilinos throws numbers
  {
    return fail(streams, ExitStatus::solver_failed,
                "An unexpected error, which is a defect of the program, ended "
                "the run:\nan exception without words.");
  }
}
} // namespace

int run_command_line(const std::vector<std::string> &words,
                     std::ostream &out,
                     std::ostream &error,
                     const ProcessGroup &processes,
                     const Screens &screens)
{
  return static_cast<int>(
      run_to_its_end(words, {out, error, screens}, processes));
}
} // namespace Voussoir
