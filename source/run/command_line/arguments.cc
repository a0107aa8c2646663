// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/run/command_line/arguments.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <sstream>

namespace Voussoir
{
namespace
{
namespace po = boost::program_options;

/** The options that the help shows, which set @p arguments. */
po::options_description visible_options(Arguments &arguments)
{
  const auto add_verbosity = [&arguments](const std::string &verbosity) {
    arguments.assignments.push_back("Output/Verbosity=" + verbosity);
  };
  // A long option stands above its description.
  constexpr unsigned int line_length = 80, description_length = 56;
  po::options_description options("Options", line_length, description_length);
  options.add_options()(
      "set", po::value(&arguments.assignments)->value_name("ENTRY"),
      "assign a parameter, as in --set \"Section/Name=value\"; repeatable")(
      "sweep", po::value(&arguments.sweeps)->value_name("RANGE"),
      "run with many values, as in --sweep \"Friction/Strength=0.1:1:20\" "
      "(20 values), 0.1:1:20:log, \"a | b\", or any of these for a word of a "
      "text, \"Loads/Body force=sin(a); -1 for a=0:1:20\", and write "
      "sweep.csv; "
      "repeatable for all combinations")(
      "find", po::value(&arguments.find)->value_name("RANGE"),
      "look for the value at which the answer changes, as in --find "
      "\"Friction/Strength=0:1:1e-6\", to this share of it, and write the "
      "results of both ends, into carried and collapses")(
      "result", po::value(&arguments.results)->value_name("NAME"),
      "a number of summary.json for sweep.csv, such as ground/reaction/1; "
      "repeatable")("directories", po::bool_switch(&arguments.has_directories),
                    "with --sweep or --find: write the results of each run, "
                    "into run_1, run_2, ... of the output directory")(
      "critical", po::bool_switch(&arguments.writes_critical),
      "with --sweep: write the results of the run with the least load factor, "
      "into critical of the output directory")(
      "validate", po::bool_switch(&arguments.validate),
      "read the scene and its packing, show what was understood, and solve and "
      "write nothing")(
      "resume", po::bool_switch(&arguments.resumes),
      "go on with a run, or a sweep or search, that was interrupted, from "
      "what it has kept in its output directory")(
      "reproduce", po::value(&arguments.reproduced)->value_name("SUMMARY"),
      "make the results of a summary.json again, in a directory that is "
      "removed, and say what differs")(
      "check",
      po::value(&arguments.checked)->value_name("DIRECTORY")->multitoken(),
      "prove the results in directories again from their files, by a script of "
      "Python that has no code of the program")(
      "print-parameters",
      po::value<std::string>()
          ->value_name("SECTION")
          ->implicit_value("", "all")
          ->notifier([&arguments](const std::string &section) {
            arguments.print_parameters = section;
          }),
      "print every parameter, or those of a section as in "
      "--print-parameters=Packing/wall, with value and documentation")(
      "print-settings", po::bool_switch(&arguments.print_settings),
      "print the parameters that the file and --set assign")(
      "as",
      po::value<std::string>()->value_name("FORMAT")->notifier(
          [&arguments](const std::string &format) {
            arguments.format = format;
          }),
      "print these as prm, json or xml; FILE may be any of the three")(
      "print-schema", po::bool_switch(&arguments.print_schema),
      "print a JSON schema of all parameters, for editors")(
      "print-reference", po::bool_switch(&arguments.print_reference),
      "print the manual's page on all parameters, as Markdown")(
      "print-completion", po::bool_switch(&arguments.print_completion),
      "print what lets bash complete the arguments: source it")(
      "quiet", po::bool_switch(&arguments.quiet),
      "print warnings and errors only")(
      "verbosity",
      po::value<std::string>()->value_name("N")->notifier(add_verbosity),
      "the same as --set Output/Verbosity=N: 0 the closing summary, 1 also "
      "the stages, 2 also iterations and the joints most used")(
      "help", po::bool_switch(&arguments.help), "print this help")(
      "version", po::bool_switch(&arguments.version), "print the version");
  return options;
}

/** What is wrong with the words, as the middle of a sentence. */
std::string fault_of(const po::error &error,
                     const std::vector<std::string> &words)
{
  const auto has_percent = [](const std::string &word) {
    return word.find('%') != word.npos;
  };
  // Boost puts words in the places of names between %, without an end if these
  // are in the words.
  const auto *const of_option =
      dynamic_cast<const po::error_with_option_name *>(&error);
  if (of_option == nullptr ||
      std::none_of(words.begin(), words.end(), has_percent))
    return error.what();
  return "the option '" + of_option->get_option_name() +
         "' is not known, or has no value or one that it does not take";
}
} // namespace

Arguments arguments_of(const std::vector<std::string> &words)
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
    throw InputError("The command line is not valid: " +
                     fault_of(error, words) + ". See 'voussoir --help'.");
  }
  if (files.size() > 1)
    throw InputError("One file of parameters is expected, but '" + files[0] +
                     "' and '" + files[1] +
                     "' are given. See 'voussoir --help'.");
  if (!files.empty())
    arguments.file = files[0];
  if (arguments.format && !arguments.print_parameters &&
      !arguments.print_settings)
    throw InputError("--as belongs to --print-parameters or --print-settings; "
                     "give one of them. See 'voussoir --help'.");
  return arguments;
}

std::string help()
{
  Arguments defaults;
  std::ostringstream text;
  text << "Usage: voussoir FILE [options]\n\n"
          "Computes the contact forces between, and the stresses inside, "
          "the rigid blocks\nof the packing that FILE describes, a file of "
          "parameters in deal.II's formats:\n.prm, .json or .xml.\n\n"
       << visible_options(defaults)
       << "\nExit status: 0 solved, 1 another answer with --reproduce or not "
          "proven with --check,\n2 bad input, 3 the load is not carried, 4 the "
          "solver failed, 130 interrupted by SIGINT\n(Ctrl-C), 143 by SIGTERM, "
          "129 by SIGHUP: then nothing is written, or all results\nare "
          "complete.\n";
  return text.str();
}

std::vector<std::string> option_names()
{
  Arguments defaults;
  std::vector<std::string> names;
  const po::options_description options = visible_options(defaults);
  for (const auto &option : options.options())
    names.push_back("--" + option->long_name());
  return names;
}
} // namespace Voussoir
