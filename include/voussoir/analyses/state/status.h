// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_state_status_h
#define voussoir_analyses_state_status_h

#include <string>

namespace Voussoir
{
/** The answer on the load; the words for it are here alone. */
struct Status
{
  /** The three answers. */
  enum class Kind
  {
    /** Forces that balance it to rounding exist. */
    solved,
    /**
     * Forces balance it to a small error. It may be a little above or below
     * what can be carried.
     */
    carried_within,
    /** A mechanism proves that it is not carried. */
    collapse
  };

  /** The answer found. */
  Kind kind = Kind::solved;
  /**
   * The error of balance or admissibility, over the largest load on a cell; of
   * `carried_within` only.
   */
  double within = 0.;

  /** The word in summary.json: "solved", "carried to within" or "collapse". */
  std::string word() const;
  /** For the terminal: the word and, if it is not exact, the error. */
  std::string description() const;
};
} // namespace Voussoir

#endif
