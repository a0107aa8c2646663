// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_parameters_parameter_faults_h
#define voussoir_base_parameters_parameter_faults_h

#include <voussoir/base/parameters/faulty_assignment.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/parameter_handler.h>

#include <limits>
#include <string>
#include <vector>

namespace Voussoir
{
/** A text of parameters. */
struct ParameterText
{
  /** Lines as in a .prm file. */
  std::string lines;
  /** The name of the file that has them. */
  std::string name;
};

/** A "subsection" of a text of parameters. */
struct SectionOfText
{
  /** With its name at the end. */
  SectionPath path;
  /** The number of its first line, from one. */
  unsigned int line;
  /** Whether its "end" is missing. */
  bool is_open;
};

/**
 * The sections that begin before a line of a text, in their order.
 *
 * @param text as in a .prm file, valid or not.
 * @param line from one; what stands there or behind is not looked at.
 */
std::vector<SectionOfText>
sections_before(const std::string &text,
                unsigned int line = std::numeric_limits<unsigned int>::max());

/**
 * What is wrong with a text of parameters, where, and what to do, in words that
 * a user knows.
 *
 * @param prm outside of all sections; its values are of no use afterwards.
 * @param fault that deal.II's parser has thrown on the text.
 */
std::string explain_fault(dealii::ParameterHandler &prm,
                          const dealii::ExceptionBase &fault,
                          const ParameterText &text);
} // namespace Voussoir

#endif
