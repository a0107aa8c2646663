// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_reconstruction_h
#define voussoir_stress_reconstruction_h

#include <voussoir/base/terminal.h>
#include <voussoir/statics/scene.h>
#include <voussoir/stress/fan.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace Voussoir
{
/** The stress inside the cells. */
struct StressField
{
  /**
   * The stress of each sub-cell. Sub-cell i of cell c, which lies along side i
   * of the cell, has the number packing.first_side(c) + i. Empty if no
   * reconstruction was asked for.
   */
  std::vector<Fan::SubCell> sub_cells;
  /**
   * The cells for which the mixed problem has no unique answer; their
   * sub-cells all have the mean stress of the cell. Ascending.
   */
  std::vector<unsigned int> undetermined;
};

/**
 * A sentence for the user on the undetermined cells, or none: how many, and
 * which is the first.
 */
std::vector<std::string> undetermined_cells(const Scene &scene,
                                            const StressField &field);

/** The section `Stress`. */
class StressParameters
{
public:
  void add_parameters(dealii::ParameterHandler &prm);

  bool reconstruct() const;

private:
  bool asked_for = true;
};

/**
 * Solve the mixed problem of Fan in every cell, on all threads. The result does
 * not depend on their number.
 */
StressField reconstruct_stress(const Scene &scene,
                               const InterfaceForces &forces,
                               Terminal &terminal);
} // namespace Voussoir

#endif
