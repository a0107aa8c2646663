// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_parameters_print_parameters_h
#define voussoir_base_parameters_print_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace Voussoir
{
/** How parameters are written; ParameterInput reads all of them. */
enum class ParameterFormat
{
  prm,
  json,
  xml
};

/**
 * @param name as on the command line.
 * @throws InputError if there is no such format.
 */
ParameterFormat parameter_format_of(const std::string &name);

/** What is written of an entry. */
enum class Detail
{
  /** Its value, default, documentation and what it accepts. */
  listing,
  /** Its value. */
  value
};

/**
 * Print those entries of which @p is_wanted is true of the path, such as
 * "Friction/Strength", in the order in which they are declared.
 */
void print_parameters(std::ostream &out,
                      const dealii::ParameterHandler &prm,
                      const std::function<bool(const std::string &)> &is_wanted,
                      ParameterFormat format,
                      Detail detail);

/**
 * A JSON schema (draft 7) of the .json files that ParameterInput reads, by
 * which editors complete and check them.
 *
 * @param of_users sections whose sections or entries users name; the first
 *   that @p prm has there stands for all.
 */
void print_schema(std::ostream &out,
                  const dealii::ParameterHandler &prm,
                  const std::vector<std::string> &of_users);
} // namespace Voussoir

#endif
