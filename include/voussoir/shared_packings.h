// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_shared_packings_h
#define voussoir_shared_packings_h

#include <voussoir/packing/packing.h>
#include <voussoir/run_parameters.h>
#include <voussoir/terminal/terminal.h>

#include <cstddef>
#include <filesystem>
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
 * kept under the values that it is made from, RunParameters::packing_key(),
 * with the warnings on it.
 */
class SharedPackings
{
public:
  /** @param n_most the number that are kept, those that were used last. */
  explicit SharedPackings(const std::size_t n_most) : n_most(n_most) {}

  /**
   * The packing that the parameters describe, with its supports.
   *
   * @param directory where relative paths begin.
   * @param terminal that of the run; it sees the warnings on the packing also
   *   if another run has made it.
   * @throws InputError if it cannot be made.
   */
  std::shared_ptr<const Packing> get(const RunParameters &parameters,
                                     const std::filesystem::path &directory,
                                     Terminal &terminal);

private:
  /** A packing, and what was noticed when it was made. */
  struct Made
  {
    std::shared_ptr<const Packing> packing;
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
