// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_output_entries_h
#define voussoir_run_output_entries_h

#include <voussoir/output/result_directory.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace Voussoir
{
/** The name of the file of all parameters of a run. */
inline const std::string parameters_prm = "parameters.prm";

/** The entries on results that every run has. */
struct OutputEntries
{
  /** A title for the results; may be empty. */
  std::string title;
  /** Where the results go. */
  std::string directory = "output";
  /** What the terminal shows; 0 to 2. */
  unsigned int verbosity = 1;
  /** The seconds after which what was found is kept on the way. */
  double checkpoint_after = 60.;

  /** Declare those outside all sections. */
  void add_entries(dealii::ParameterHandler &prm);
  /** Declare those of the section `Output` that every run has. */
  void add_output(dealii::ParameterHandler &prm);
};

/** The Journal of a run, or of many, in the directory of the results. */
inline const std::string checkpoint_file = "checkpoint.bin";

/** Every file that any run may write. */
FilesOfRuns files_of_all_runs();

/** Write all parameters, in the order in which they are declared. */
void write_parameters(ResultDirectory &files,
                      const dealii::ParameterHandler &prm);

/** Write a collection of @p grids, which ParaView opens as one file. */
void write_collection(ResultDirectory &files,
                      const std::vector<std::string> &grids);
} // namespace Voussoir

#endif
