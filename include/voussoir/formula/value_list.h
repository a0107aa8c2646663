// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_formula_value_list_h
#define voussoir_formula_value_list_h

#include <string>
#include <vector>

namespace Voussoir
{
/** What a list begins with that stands in the place of an expression. */
inline const std::string list_word = "list";

/** True of "list 0.5, 0.6", and if a component is one: "list 0, 0; list 1, 2".
 */
bool is_value_list(const std::string &value);

/**
 * The numbers of a list, one for each element.
 *
 * @param value as in "list 0.5, 0.6"; inf is a number, and nan is, too.
 * @param parameter its name, for messages.
 * @param n_elements how many there must be.
 * @param element the word for one, such as "interface".
 * @throws InputError if something else stands there, or another number of them.
 */
std::vector<double> numbers_of_list(const std::string &value,
                                    const std::string &parameter,
                                    unsigned int n_elements,
                                    const std::string &element);

/**
 * The components of vectors, each a list: "list b_x, ...; list b_y, ...".
 *
 * @param n_components how many lists there must be.
 * @return for each component the numbers.
 * @throws InputError as numbers_of_list(), or if a number is not finite, as of
 * a force.
 */
std::vector<std::vector<double>> vectors_of_lists(const std::string &value,
                                                  const std::string &parameter,
                                                  unsigned int n_components,
                                                  unsigned int n_elements,
                                                  const std::string &element);
} // namespace Voussoir

#endif
