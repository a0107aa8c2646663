// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_ranges_range_entries_h
#define voussoir_analyses_ranges_range_entries_h

#include <voussoir/analyses/ranges/ranges.h>

#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <string>

namespace Voussoir
{
/** The section `Ranges`, in the plane and in space. */
class RangeEntries
{
public:
  /** Declare the section and bind it. */
  template <int dim>
  void add_parameters(dealii::ParameterHandler &prm);

  /**
   * What is wanted of a packing with its supports; nothing by default.
   *
   * @throws InputError if the condition cannot be evaluated or holds on no
   *   interface, a name is that of none, or reactions are wanted and there are
   *   no supports.
   */
  template <int dim>
  std::optional<RangesWanted> wanted(const Packing<dim> &packing) const;

private:
  std::string where = "0", joints;
  bool reactions = false;
  bool links = false;
  RangeMethod method = RangeMethod::automatic;
};
} // namespace Voussoir

#endif
