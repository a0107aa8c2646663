// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_vtu_pvd_h
#define voussoir_output_vtu_pvd_h

#include <iosfwd>
#include <string>
#include <vector>

namespace Voussoir
{
/** The name of the file. */
inline const std::string results_pvd = "results.pvd";

/**
 * The .pvd that makes one data set of @p files beside it, for ParaView, which
 * shows one at a time: each is a time step, the first is what is seen first.
 */
void write_pvd(std::ostream &out, const std::vector<std::string> &files);
} // namespace Voussoir

#endif
