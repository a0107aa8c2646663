// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/assist.h>
#include <voussoir/base/terminal.h>
#include <voussoir/output/stress_pieces.h>
#include <voussoir/statics/least_energy.h>

#include <optional>
#include <ostream>

namespace Voussoir
{
void assist(const Team &team)
{
  Terminal &silent = Terminal::silent(); // the root says what there is to say
  std::optional<StressPart> stress;
  for (;;)
    switch (team.wait())
    {
    case Team::Task::none:
      return;
    case Team::Task::least_energy:
      assist_least_energy(team, silent);
      break;
    case Team::Task::stress:
      stress.emplace(assist_stress(team, silent));
      break;
    case Team::Task::writing:
      write_stress_piece(*stress, team);
      break;
    }
}
} // namespace Voussoir
