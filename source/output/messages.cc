// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/messages.h>

#include <cmath>
#include <sstream>

namespace Voussoir
{
std::vector<std::string> cells_not_convex(const Packing &packing)
{
  if (packing.not_convex().empty())
    return {};
  const unsigned int c = packing.not_convex().front();
  return {text("Not convex: ", counted(packing.not_convex().size(), "cell"),
               ", the first of which is ", packing.describe(c), " at ",
               text_of_point(packing.centre(c)),
               ". Each can be seen whole from its centre, so the forces on its "
               "sides are those of the model; whether it would interlock with "
               "its neighbours is not looked at.")};
}

std::string message_of(const Collapse &collapse, const std::string &files)
{
  std::ostringstream message;
  message.precision(10); // close to the limit the ratio is hardly above one
  message << "The load is not carried: along a mechanism of the blocks that "
             "closes no joint it does ";
  if (std::isfinite(collapse.proof.work_over_dissipation))
    message << collapse.proof.work_over_dissipation
            << " times the work that friction can dissipate";
  else
    message << "work that friction does not resist";
  message << ", so that no forces within the strengths of the interfaces "
             "balance it";
  if (std::isfinite(collapse.proof.work_over_dissipation))
    message
        << "; these would have to be at least that many times as large, and "
           "perhaps more";
  message << '.';
  if (!collapse.parts.empty())
    message << " Most is done by " << collapse.parts.front().name << ", "
            << std::lround(100. * share_of_first(collapse.parts))
            << "% of the work that is put in. "
            << (files.empty() ? "Change" : "See " + files + "; change")
            << " 'Loads' or raise 'Friction/Strength'.";
  return message.str();
}
} // namespace Voussoir
