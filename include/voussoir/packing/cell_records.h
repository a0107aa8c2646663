// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_cell_records_h
#define voussoir_packing_cell_records_h

#include <string>
#include <vector>

namespace Voussoir
{
/** Where the cells of a packing come from, and what they are called. */
struct CellRecords
{
  /** The names of groups of cells; empty: every cell is called "block". */
  std::vector<std::string> group_names;
  /** For each cell its name's number in group_names; empty: 0. */
  std::vector<unsigned int> group;

  /** The file that the cells were read from; empty if they were not. */
  std::string file;
  /** The name of a record of that file. */
  std::string record_name = "line";
  /** For each cell the number of its record; empty if not read. */
  std::vector<unsigned int> records;
  /**
   * For each cell what else tells of its record, as "layer 'pier', handle 2A";
   * the last ones, or all, may be missing.
   */
  std::vector<std::string> details;

  /** Notices to the user on how the input was understood. */
  std::vector<std::string> notices;

  /**
   * Name the groups if they are not, and add that of the ground.
   *
   * @throws InputError if a group has an impossible name.
   */
  void name_groups();

  /** The number among group_names of a cell's group, from @p ground on its. */
  unsigned int group_of(unsigned int cell, unsigned int ground) const;
  /**
   * Let one of @p n_cells cells belong to the group @p name.
   *
   * @throws InputError if that cannot be a name; see check_group_name().
   */
  void
  set_group(unsigned int cell, const std::string &name, unsigned int n_cells);

  /** "cell 3", with its record if it was read. */
  std::string describe(unsigned int cell) const;
};
} // namespace Voussoir

#endif
