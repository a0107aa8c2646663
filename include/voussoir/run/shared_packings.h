// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_shared_packings_h
#define voussoir_run_shared_packings_h

#include <voussoir/packing/packing.h>
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
 */
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
  std::shared_ptr<const Packing<2>> get(const std::string &key,
                                        const std::function<Packing<2>()> &make,
                                        Terminal &terminal);

private:
  /** A packing, and what was noticed when it was made. */
  struct Made
  {
    std::shared_ptr<const Packing<2>> packing;
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
} // namespace Voussoir

#endif
