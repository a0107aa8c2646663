// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_nearest_name_h
#define voussoir_base_nearest_name_h

#include <string>
#include <vector>

namespace Voussoir
{
/**
 * The number of letters to insert, remove or replace to make one of two texts
 * the other (Levenshtein, 1966), without regard to upper and lower case.
 */
unsigned int edit_distance(const std::string &a, const std::string &b);

/**
 * The texts among @p texts that are nearest to @p text, if they are near enough
 * to be what was meant: at most @p n_most of them.
 */
std::vector<std::string> nearest_texts(const std::string &text,
                                       const std::vector<std::string> &texts,
                                       std::size_t n_most = 3);

/**
 * The paths among @p paths, "Section/Name", whose name is nearest to @p name,
 * if they are near enough to be what was meant: at most @p n_most of them.
 */
std::vector<std::string> nearest_names(const std::string &name,
                                       const std::vector<std::string> &paths,
                                       std::size_t n_most = 3);
} // namespace Voussoir

#endif
