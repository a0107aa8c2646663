// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_ranges_range_search_h
#define voussoir_analyses_ranges_range_search_h

#include <voussoir/analyses/ranges/range.h>
#include <voussoir/base/journal.h>
#include <voussoir/terminal/terminal.h>

#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/** Ranges are looked for, function by function, in the plane or in space. */
template <typename SceneOf>
class RangeSearch
{
public:
  /** Of the scene. */
  using Function = typename SceneOf::Function;
  /**
   * @param scene whose loads are carried.
   * @param functions of the forces, in kinds that take turns.
   * @param n_kinds the number of kinds.
   * @param pressed in the plane the interfaces whose eccentricities are looked
   *   for, too: function n_kinds k is the normal force of the k-th of them.
   * @param method of the search.
   * @param journal where is kept what is found on the way, or null.
   * @param terminal sees the progress.
   */
  RangeSearch(const SceneOf &scene,
              const std::vector<Function> &functions,
              unsigned int n_kinds,
              const std::vector<unsigned int> &pressed,
              RangeMethod method,
              Journal *journal,
              Terminal &terminal);

  /** Find all. */
  void find_all();
  /** @{ */
  /** A range for each function, and the places of the resultants. */
  const std::vector<Range> &ranges() const { return found; }
  const std::vector<Range> &places() const { return found_places; }
  /** @} */
  /** The errors of all so far. */
  RangeProofs proofs;
  /** FeasibleSetOf::reference(). */
  double reference() const { return states.reference(); }

private:
  struct Part;
  /** Let @p find do all parts, on all threads; @p name is that of the journal.
   */
  template <typename Find>
  void find_parts(const std::string &name, bool finds_places, const Find &find);
  void find_forces(Part &part);
  void find_next_force(Part &part, double sign);
  void find_places(Part &part);
  void end_item(Part &part);
  void keep(const Part &part);
  void go_on(Part &part);
  Range &range_of(const Part &part, std::size_t k);
  double farthest_place(Part &part, unsigned int interface, double sign);
  StateProgram &program_of(Part &part);
  GreatestValueOf<SceneOf> greatest(Part &part, const Function &function);
  void count(unsigned int n);

  const FeasibleSetOf<SceneOf> states;
  const std::vector<Function> &functions;
  const unsigned int n_kinds;
  const std::vector<unsigned int> &pressed;
  const bool by_interior_point;
  /** What the programmes of all parts start from, if there are any. */
  std::optional<StateProgram> first;
  Journal *const journal;
  Terminal &terminal;
  std::vector<Range> found, found_places;
  std::size_t n_done = 0;
  std::mutex mutex;
};
} // namespace Voussoir

#endif
