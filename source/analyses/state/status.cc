// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/state/status.h>
#include <voussoir/base/text.h>

namespace Voussoir
{
std::string Status::word() const
{
  switch (kind)
  {
  case Kind::solved: return "solved";
  case Kind::carried_within: return "carried to within";
  default: return "collapse";
  }
}

std::string Status::description() const
{
  return kind == Kind::carried_within
             ? text(word(), ' ', within, " of the largest load")
             : word();
}
} // namespace Voussoir
