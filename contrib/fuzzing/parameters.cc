// SPDX-License-Identifier: LGPL-2.1-or-later

// Files of parameters in the three formats, up to the solver.

#include "harness.h"

namespace
{
/** Everything that a run reads from a file of parameters. */
template <const char *name>
void read(const std::string &input)
{
  Fuzzing::write_file(name, input);
  Fuzzing::validate({name});
}

constexpr char prm[] = "scene.prm", json[] = "scene.json", xml[] = "scene.xml";
const Fuzzing::Target of_lines("prm", read<prm>);
const Fuzzing::Target of_json("json", read<json>);
const Fuzzing::Target of_xml("xml", read<xml>);
} // namespace
