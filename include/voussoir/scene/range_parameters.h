// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_range_parameters_h
#define voussoir_scene_range_parameters_h

#include <voussoir/packing/packing.h>

#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/** How the ends of ranges are found; see FeasibleSet. */
enum class RangeMethod
{
  /** The quicker one, as far as the numbers of both tell. */
  automatic,
  /** The simplex method, each end from that of another. */
  simplex,
  /** An interior point, each end on its own. */
  interior_point
};

/** The forces whose ranges are found; see find_ranges(). */
struct RangesWanted
{
  /** True for each interface whose forces are among them. */
  std::vector<bool> interfaces;
  /** True if the reactions are. */
  bool reactions = false;
  /** How. */
  RangeMethod method = RangeMethod::automatic;
};

/** How many states are drawn; see draw_samples(). */
struct SamplesWanted
{
  /** The number of independent states that their means are to be worth. */
  unsigned int n = 0;
  /** The number of steps from one to the next; 0: as many as that takes. */
  unsigned int n_steps = 0;
  /** The largest number of steps, if it is not given. */
  unsigned int most_steps = 256;
  /** Of the random numbers. */
  unsigned int seed = 1;
};

/** The section `Ranges`: of which forces the ranges are found. */
class RangeParameters
{
public:
  /** Declare the section and bind it. */
  void add_parameters(dealii::ParameterHandler &prm);

  /**
   * What is wanted of a packing with its supports; nothing by default.
   *
   * @throws InputError if the condition cannot be evaluated or holds on no
   *   interface, a name is that of none, or reactions are wanted and there are
   * no supports.
   */
  std::optional<RangesWanted> wanted(const Packing &packing) const;

  /**
   * The samples that are wanted; none by default.
   *
   * @throws InputError if they are too few to tell anything.
   */
  std::optional<SamplesWanted> samples() const;

private:
  std::string where = "0", joints;
  bool reactions = false;
  RangeMethod method = RangeMethod::automatic;
  SamplesWanted of_samples;
};
} // namespace Voussoir

#endif
