// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_summary_messages_h
#define voussoir_output_summary_messages_h

#include <voussoir/output/results.h>

#include <string>
#include <vector>

namespace Voussoir
{
/** A sentence for the user on the cells that are not convex, or none. */
std::vector<std::string> cells_not_convex(const Packing<2> &packing);

/**
 * The verdict on loads that are carried as they are given, in a sentence.
 *
 * @param has_supports false if nothing is held.
 */
std::string sentence_of(const Status &status, bool has_supports);

/** Warnings on forces that the certificate accepts. */
std::vector<std::string> doubts_about(const Results &results);

/**
 * The message of a run whose load is not carried.
 *
 * @param files those with the mechanism, "a and b", or none.
 */
std::string message_of(const Collapse &collapse, const std::string &files);
} // namespace Voussoir

#endif
