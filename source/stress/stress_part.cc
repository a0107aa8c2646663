// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/stress/side_forces.h>
#include <voussoir/stress/stress_part.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/split.hpp>

#include <type_traits>
#include <utility>

namespace Voussoir
{
namespace
{
/** The data sent of the cells of one process. */
struct Message
{
  CellLoops cells;
  CellForces forces;
  Motion motion;
};

/** Visit all of a message that is a list of numbers or vectors. */
template <typename MessageType, typename Visitor>
void for_each_list(MessageType &message, const Visitor &visit)
{
  visit(message.cells.vertices);
  visit(message.cells.first);
  visit(message.cells.loops);
  visit(message.cells.centres);
  visit(message.cells.group);
  visit(message.forces.on_side);
  visit(message.forces.shift_on_side);
  visit(message.forces.body);
  visit(message.motion.displacement);
  visit(message.motion.rotation);
}

/** No name of a group has it; see check_group_name(). */
constexpr char between_names = '\n';

void send(const ProcessGroup &processes,
          const unsigned int process,
          const Message &message)
{
  const std::string names = boost::algorithm::join(
      message.cells.group_names, std::string(1, between_names));
  processes.send(std::vector<char>(names.begin(), names.end()), process);
  processes.send(std::vector<double>{message.cells.tolerance}, process);
  for_each_list(message,
                [&](const auto &list) { processes.send(list, process); });
}

Message receive(const ProcessGroup &processes)
{
  Message message;
  const std::vector<char> names = processes.receive<char>(0);
  boost::algorithm::split(message.cells.group_names, names,
                          [](const char c) { return c == between_names; });
  message.cells.tolerance = processes.receive<double>(0).front();
  for_each_list(message, [&](auto &list) {
    list =
        processes.receive<typename std::decay_t<decltype(list)>::value_type>(0);
  });
  return message;
}

Motion part_of(const Motion &motion, const CellRange &cells)
{
  Motion part;
  const auto copy = [&](const auto &all, auto &some) {
    if (!all.empty())
      some.assign(all.begin() + cells.begin, all.begin() + cells.end);
  };
  copy(motion.displacement, part.displacement);
  copy(motion.rotation, part.rotation);
  return part;
}

/** Reconstruct on all processes, each with its own message. */
StressPart reconstruct(Message message,
                       const unsigned int first_cell,
                       const Reconstruction &how,
                       const ProcessGroup &processes,
                       Terminal &terminal)
{
  Packing<2> packing(std::move(message.cells));
  StressField stress =
      reconstruct_stress(packing, message.forces, how, terminal);
  for (unsigned int &c : stress.undetermined)
    c += first_cell;
  const auto n_sub_cells =
      processes.sum<unsigned long long>(stress.n_sub_cells);
  const auto of_all = processes.gather(stress.undetermined);
  if (processes.is_root())
  {
    stress.n_sub_cells = n_sub_cells;
    stress.undetermined.clear();
    for (const auto &cells : of_all)
      stress.undetermined.insert(stress.undetermined.end(), cells.begin(),
                                 cells.end());
  }
  return {first_cell, std::move(packing), std::move(message.motion),
          std::move(stress)};
}
} // namespace

StressPart reconstruct_on_root(const Scene &scene,
                               const InterfaceForces &forces,
                               const Motion &motion,
                               const Reconstruction &how,
                               const ProcessGroup &processes,
                               Terminal &terminal)
{
  processes.call(stress_task);
  return processes.together([&]() {
    processes.broadcast(how);
    const std::size_t n_cells = scene.packing.n_cells();
    Message message;
    // Its own last, so that no more than two are held at a time.
    for (unsigned int r = processes.size(); r-- > 0;)
    {
      const CellRange cells = {
          static_cast<unsigned int>(n_cells * r / processes.size()),
          static_cast<unsigned int>(n_cells * (r + 1) / processes.size())};
      message = {cut_free(scene.packing, cells),
                 cell_forces(scene, forces, cells), part_of(motion, cells)};
      if (r > 0)
      {
        processes.send(std::vector<unsigned int>{cells.begin}, r);
        send(processes, r, message);
      }
    }
    return reconstruct(std::move(message), 0, how, processes, terminal);
  });
}

StressPart work_on_stress(const ProcessGroup &processes, Terminal &terminal)
{
  return processes.together([&]() {
    const Reconstruction how = processes.broadcast(Reconstruction());
    const unsigned int first_cell = processes.receive<unsigned int>(0).front();
    return reconstruct(receive(processes), first_cell, how, processes,
                       terminal);
  });
}
} // namespace Voussoir
