// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/reference.h>
#include <voussoir/command_line.h>
#include <voussoir/simulation.h>
#include <voussoir/sweep.h>
#include <voussoir/version.h>

#include <boost/program_options.hpp>

#include <filesystem>
#include <new>
#include <ostream>
#include <sstream>

namespace Voussoir
{
namespace
{
namespace po = boost::program_options;

/** The exit status of the program; see run_command_line(). */
enum class ExitStatus
{
  solved = 0,
  bad_input = 2,
  load_not_carried = 3,
  solver_failed = 4
};

struct Arguments
{
  std::string file;
  std::vector<std::string> assignments;
  std::vector<std::string> sweeps;
  std::string find;
  std::vector<std::string> results;
  bool has_directories = false;
  bool print_parameters = false;
  bool print_reference = false;
  bool quiet = false;
  std::string verbosity;
  bool help = false;
  bool version = false;
};

/** The options that the help shows, which set @p arguments. */
po::options_description visible_options(Arguments &arguments)
{
  po::options_description options("Options");
  options.add_options()(
      "set", po::value(&arguments.assignments)->value_name("ENTRY"),
      "assign a parameter, as in --set \"Section/Name=value\"; repeatable")(
      "sweep", po::value(&arguments.sweeps)->value_name("RANGE"),
      "run with many values, as in --sweep \"Friction/Strength=0.1:1:20\" "
      "(20 values), 0.1:1:20:log or \"a | b\", and write sweep.csv; repeatable "
      "for all combinations")(
      "find", po::value(&arguments.find)->value_name("RANGE"),
      "look for the value at which the answer changes, as in --find "
      "\"Friction/Strength=0:1:1e-6\", to this share of it")(
      "result", po::value(&arguments.results)->value_name("NAME"),
      "a number of summary.json for sweep.csv, such as ground/reaction/1; "
      "repeatable")("directories", po::bool_switch(&arguments.has_directories),
                    "with --sweep or --find: write the results of each run, "
                    "into run_1, run_2, ... of the output directory")(
      "print-parameters", po::bool_switch(&arguments.print_parameters),
      "print every parameter with its value and documentation, as .prm")(
      "print-reference", po::bool_switch(&arguments.print_reference),
      "print the manual's page on all parameters, as Markdown")(
      "quiet", po::bool_switch(&arguments.quiet),
      "print warnings and errors only")(
      "verbosity", po::value(&arguments.verbosity)->value_name("N"),
      "the same as --set Output/Verbosity=N: 0 the closing summary, 1 also "
      "the stages, 2 also iterations and the joints most used")(
      "help", po::bool_switch(&arguments.help), "print this help")(
      "version", po::bool_switch(&arguments.version), "print the version");
  return options;
}

Arguments parse(const std::vector<std::string> &words)
{
  Arguments arguments;
  std::vector<std::string> files;
  po::options_description all = visible_options(arguments);
  all.add_options()("file", po::value(&files));
  po::positional_options_description positional;
  positional.add("file", -1);
  try
  {
    // No prefixes of options: a later option must not change their meaning.
    const int style = po::command_line_style::default_style &
                      ~po::command_line_style::allow_guessing;
    po::variables_map values;
    po::store(po::command_line_parser(words)
                  .options(all)
                  .positional(positional)
                  .style(style)
                  .run(),
              values);
    po::notify(values);
  }
  catch (const po::error &error)
  {
    throw InputError(std::string("The command line is not valid: ") +
                     error.what() + ". See 'voussoir --help'.");
  }
  if (files.size() > 1)
    throw InputError("One .prm file is expected, but '" + files[0] + "' and '" +
                     files[1] + "' are given. See 'voussoir --help'.");
  if (!files.empty())
    arguments.file = files[0];
  if (!arguments.verbosity.empty())
    arguments.assignments.push_back("Output/Verbosity=" + arguments.verbosity);
  return arguments;
}

std::string help()
{
  Arguments none;
  std::ostringstream text;
  text << "Usage: voussoir FILE.prm [options]\n\n"
          "Computes the contact forces between, and the stresses inside, "
          "the rigid blocks\nof the packing that FILE.prm describes.\n\n"
       << visible_options(none)
       << "\nExit status: 0 solved, 2 bad input, 3 the load is not carried, "
          "4 the solver failed,\n130 interrupted by SIGINT (Ctrl-C), 143 by "
          "SIGTERM, 129 by SIGHUP: then nothing is\nwritten, or all "
          "results are complete.\n";
  return text.str();
}

/** The streams of the program, and the devices behind them. */
struct Streams
{
  std::ostream &out;
  std::ostream &error;
  const Screens &screens;
};

/** Print @p text; throws an InputError unless all of it is written. */
void print(std::ostream &out, const std::string &text)
{
  if (!(out << text << std::flush))
    throw InputError("The output cannot be written; is the disk full, or has "
                     "its reader gone?");
}

/** Run a scene many times, if that is asked for. */
bool run_many(const Arguments &arguments, const Team &team, Terminal &terminal)
{
  const bool finds = !arguments.find.empty();
  if (arguments.sweeps.empty() && !finds)
  {
    if (!arguments.results.empty() || arguments.has_directories)
      throw InputError("--result and --directories belong to --sweep or "
                       "--find. See 'voussoir --help'.");
    return false;
  }
  if (finds && !arguments.sweeps.empty())
    throw InputError("--sweep and --find are given; give one of them.");
  if (team.size() > 1)
    throw InputError("--sweep and --find use the cores of one process; give "
                     "them without mpirun.");
  if (arguments.file.empty())
    throw InputError("No parameter file is given. Run 'voussoir FILE.prm', or "
                     "see 'voussoir --help'.");
  const ManyRuns runs = {arguments.file, arguments.assignments,
                         arguments.results, arguments.has_directories};
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

void run(const Arguments &arguments, const Streams &streams, const Team &team)
{
  if (arguments.help)
    return print(streams.out, help());
  if (arguments.version)
    return print(streams.out, "voussoir " VOUSSOIR_VERSION "\n");
  // A quiet run shows warnings only, which belong to the errors.
  Terminal terminal = arguments.quiet
                          ? Terminal(streams.error, 1, streams.screens.error)
                          : Terminal(streams.out, 1, streams.screens.out);
  if (arguments.quiet)
    terminal.be_quiet();
  if (run_many(arguments, team, terminal))
    return;
  Simulation simulation(terminal, team);
  ParameterSources sources;
  if (!arguments.file.empty())
    sources.file = arguments.file;
  sources.assignments = arguments.assignments;
  simulation.read(sources);
  const dealii::ParameterHandler &prm = simulation.entries();
  std::ostringstream text;
  if (arguments.print_reference)
  {
    write_reference(text, prm);
    return print(streams.out, text.str());
  }
  if (arguments.print_parameters)
  {
    prm.print_parameters(text,
                         dealii::ParameterHandler::PRM |
                             dealii::ParameterHandler::KeepDeclarationOrder);
    return print(streams.out, text.str());
  }
  if (arguments.file.empty())
    throw InputError("No parameter file is given. Run 'voussoir FILE.prm', or "
                     "see 'voussoir --help'.");
  // The directory of the file itself, should its name be a link; relative to
  // the working directory, for messages that a user recognises.
  namespace fs = std::filesystem;
  simulation.run(fs::proximate(fs::canonical(arguments.file).parent_path()));
}

int fail(const Streams &streams,
         const ExitStatus status,
         const std::string &message)
{
  streams.error << streams.screens.error.bad("voussoir:") << ' ' << message
                << std::endl;
  return static_cast<int>(status);
}
} // namespace

int run_command_line(const std::vector<std::string> &words,
                     std::ostream &out,
                     std::ostream &error,
                     const Team &team,
                     const Screens &screens)
{
  const Streams streams{out, error, screens};
  try
  {
    run(parse(words), streams, team);
    return static_cast<int>(ExitStatus::solved);
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
  catch (const LoadNotCarried &e)
  {
    return fail(streams, ExitStatus::load_not_carried, e.what());
  }
  catch (const SolverError &e)
  {
    return fail(streams, ExitStatus::solver_failed, e.what());
  }
  catch (const std::bad_alloc &)
  {
    return fail(streams, ExitStatus::solver_failed,
                "There is not enough memory for this packing.");
  }
  catch (const std::exception &e)
  {
    return fail(streams, ExitStatus::solver_failed,
                std::string("An unexpected error, which is a defect of the "
                            "program, ended the run:\n") +
                    e.what());
  }
}
} // namespace Voussoir
