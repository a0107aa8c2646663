// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/assist.h>
#include <voussoir/statics/least_energy.h>

namespace Voussoir
{
void assist(const Team &team)
{
  for (;;)
    switch (team.wait())
    {
      case Team::Task::none:
        return;
      case Team::Task::least_energy:
        assist_least_energy(team);
        break;
      case Team::Task::stress:
        break;
    }
}
} // namespace Voussoir
