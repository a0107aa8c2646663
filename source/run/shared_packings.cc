// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/run/shared_packings.h>

#include <algorithm>
#include <exception>
#include <utility>

namespace Voussoir
{
template <typename Kind>
std::shared_ptr<const Kind>
SharedPackings<Kind>::get(const std::string &key,
                          const std::function<Kind()> &make,
                          Terminal &terminal)
{
  const auto has_key = [&key](const Kept &one) { return one.key == key; };
  std::promise<Made> promise;
  std::shared_future<Made> made;
  bool is_there;
  {
    const std::lock_guard lock(of_list);
    const auto found = std::find_if(kept.begin(), kept.end(), has_key);
    is_there = found != kept.end();
    if (is_there)
      kept.splice(kept.begin(), kept, found);
    else
      kept.push_front({key, promise.get_future().share()});
    made = kept.front().made;
    if (kept.size() > n_most)
      kept.pop_back();
  }
  if (is_there)
  {
    for (const std::string &warning : made.get().warnings)
      terminal.warning(warning);
    return made.get().packing;
  }
  try
  {
    const std::size_t n_before = terminal.warnings().size();
    auto packing = std::make_shared<const Kind>(make());
    promise.set_value(
        {std::move(packing),
         {terminal.warnings().begin() + n_before, terminal.warnings().end()}});
  }
  catch (...)
  {
    // A file may be mended before the next run; those that wait fail alike.
    promise.set_exception(std::current_exception());
    const std::lock_guard lock(of_list);
    kept.remove_if(has_key);
  }
  return made.get().packing;
}

template class SharedPackings<Packing<2>>;
template class SharedPackings<CheckedPacking>;
} // namespace Voussoir
