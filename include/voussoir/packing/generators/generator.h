// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_generators_generator_h
#define voussoir_packing_generators_generator_h

#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/cells.h>
#include <voussoir/terminal/terminal.h>

#include <deal.II/base/parameter_handler.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace Voussoir
{
/** One source of packings, with the parameters that it needs. */
template <int dim>
class PackingGenerator
{
public:
  virtual ~PackingGenerator() = default;

  /** The name in `set Generator = ...`; also the name of its subsection. */
  virtual std::string name() const = 0;

  /** One line on what it makes, for the documentation of the parameters. */
  virtual std::string meaning() const = 0;

  /** Declare the parameters in the current subsection and bind them. */
  virtual void add_parameters(dealii::ParameterHandler &prm) = 0;

  /**
   * Make the cells of the packing, from the parameters that were parsed.
   *
   * @param directory the start of relative paths among the parameters.
   * @param terminal is told how far that has come, where it can be long.
   * @throws InputError if the parameters describe no packing.
   */
  virtual Cells<dim> generate(const std::filesystem::path &directory,
                              Terminal &terminal) const = 0;

  /** The files that generate() reads. */
  virtual std::vector<std::filesystem::path>
  input_files(const std::filesystem::path & /*directory*/) const
  {
    return {};
  }
};

/**
 * The most cells that a generator makes: a packing then needs some 100 GB. Who
 * tries what comes, as contrib/fuzz does, may set less at the start.
 */
inline double most_generated_cells = 1e8;

/**
 * Check the number of cells, before any memory is asked for.
 *
 * @throws InputError if a packing has more cells than numbers of 32 bits can
 *   count the sides of.
 * @param entries the names of the parameters that it follows from.
 */
inline void check_number_of_cells(const double n_cells,
                                  const std::string &entries)
{
  if (n_cells > most_generated_cells)
    throw InputError(text(entries, " make some ", n_cells,
                          " cells; there may be ", most_generated_cells,
                          " at most."));
}

/**
 * Check the size of a rectangle, @p what such as "wall 'Packing/wall'".
 *
 * @throws InputError unless both lengths are positive and finite.
 */
inline void
check_size(const std::string &what, const double width, const double height)
{
  if (!std::isfinite(width) || !std::isfinite(height) || width <= 0. ||
      height <= 0.)
    throw InputError(text("The ", what, " has the width ", width,
                          " and the height ", height,
                          "; both must be positive and finite."));
}
} // namespace Voussoir

#endif
