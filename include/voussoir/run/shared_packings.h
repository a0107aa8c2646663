// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_shared_packings_h
#define voussoir_run_shared_packings_h

#include <voussoir/packing/packing.h>
#include <voussoir/run/checked_packing.h>
#include <voussoir/terminal/terminal.h>

#include <cstddef>
#include <functional>
#include <future>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace Voussoir
{
/**
 * Packings that runs share, in any number of threads: each is made once, and
 * kept under a key, the values that it is made from, with the warnings on it.
 *
 * @tparam Kind Packing<2>, or CheckedPacking in space.
 */
template <typename Kind>
class SharedPackings
{
public:
  /** @param n_most the number that are kept, those that were used last. */
  explicit SharedPackings(const std::size_t n_most) : n_most(n_most) {}

  /**
   * The packing of a key.
   *
   * @param make makes it, and warns on @p terminal.
   * @param terminal that of the run; it sees the warnings on the packing also
   *   if another run has made it.
   * @throws InputError if it cannot be made.
   */
  std::shared_ptr<const Kind> get(const std::string &key,
                                  const std::function<Kind()> &make,
                                  Terminal &terminal);

private:
  /** A packing, and what was noticed when it was made. */
  struct Made
  {
    std::shared_ptr<const Kind> packing;
    std::vector<std::string> warnings;
  };
  /** One that is there, or that another thread makes. */
  struct Kept
  {
    std::string key;
    std::shared_future<Made> made;
  };

  const std::size_t n_most;
  std::mutex of_list;
  /** The one that was used last is the first. */
  std::list<Kept> kept;
};

/** The packings of runs of which some may be in the plane, some in space. */
struct PackingsOfRuns
{
  /** @param n_most see SharedPackings; of each dimension. */
  explicit PackingsOfRuns(const std::size_t n_most)
      : in_plane(n_most), in_space(n_most)
  {}

  SharedPackings<Packing<2>> in_plane;     /**< of runs in the plane */
  SharedPackings<CheckedPacking> in_space; /**< of runs in space */
};
} // namespace Voussoir

#endif
