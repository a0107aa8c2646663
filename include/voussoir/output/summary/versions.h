// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_summary_versions_h
#define voussoir_output_summary_versions_h

#include <nlohmann/json.hpp>

namespace Voussoir
{
/** The versions of the program and of its libraries, by their names. */
nlohmann::ordered_json library_versions();
} // namespace Voussoir

#endif
