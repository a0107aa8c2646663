// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_anderson_h
#define voussoir_algebra_anderson_h

#include <deque>
#include <vector>

namespace Voussoir
{
/**
 * Anderson's acceleration of a fixed point x = g(x): Walker and Ni, *SIAM
 * Journal on Numerical Analysis* 49 (2011), 1715.
 */
class Anderson
{
public:
  /** @param depth the number of earlier steps that the next one uses. */
  explicit Anderson(const unsigned int depth) : depth(depth) {}

  /** The next x, after @p g = g(@p x) was found; of any sign. */
  std::vector<double> next(const std::vector<double> &x,
                           const std::vector<double> &g);
  /** Forget all earlier steps. */
  void restart() { earlier.clear(); }

private:
  struct Step
  {
    /** g(x), and g(x) - x. */
    std::vector<double> g, residual;
  };
  const unsigned int depth;
  std::deque<Step> earlier;
};
} // namespace Voussoir

#endif
