// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_parameters_nested_parameters_h
#define voussoir_base_parameters_nested_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <boost/property_tree/ptree.hpp>

#include <string>

namespace Voussoir
{
/** @{ */
/**
 * The sections and entries of a file by their names. Those of XML are in an
 * element "ParameterHandler", and each byte of a name but a letter or a digit
 * is written there as _ and two hexadecimal digits, as deal.II does.
 *
 * @param file its name, for messages.
 * @throws InputError naming the line if it is not valid.
 */
boost::property_tree::ptree nested_from_json(const std::string &text,
                                             const std::string &file);
boost::property_tree::ptree nested_from_xml(const std::string &text,
                                            const std::string &file);
/** @} */

/**
 * Assign all entries in @p nested to @p prm; see ParameterInput::assign_to().
 *
 * @param place of it, for messages.
 */
bool assign_nested(dealii::ParameterHandler &prm,
                   const boost::property_tree::ptree &nested,
                   const std::string &place);
} // namespace Voussoir

#endif
