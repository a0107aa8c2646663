// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/vtu/stress_pieces.h>
#include <voussoir/run/worker.h>
#include <voussoir/statics/energy/elastic_faces.h>
#include <voussoir/statics/energy/least_energy.h>
#include <voussoir/stress/shared_tetrahedra.h>
#include <voussoir/terminal/terminal.h>

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace Voussoir
{
void run_worker(const ProcessGroup &processes)
{
  Terminal &silent = Terminal::silent(); // the root says what there is to say
  std::optional<StressPart> stress;
  const std::map<std::string, std::function<void()>> tasks = {
      {least_energy_task, [&] { work_on_least_energy(processes, silent); }},
      {faces_task, [&] { work_on_faces(processes, silent); }},
      {stress_task, [&] { stress.emplace(work_on_stress(processes, silent)); }},
      {tetrahedra_task, [&] { work_on_tetrahedra(processes); }},
      {writing_task, [&] { write_stress_piece(*stress, processes); }}};
  for (std::string task = processes.wait(); !task.empty();
       task = processes.wait())
    try
    {
      tasks.at(task)();
    }
    catch (const SolverError &)
    {
      // All processes have it; the root reports it.
    }
}
} // namespace Voussoir
