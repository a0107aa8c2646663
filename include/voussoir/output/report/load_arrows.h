// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_load_arrows_h
#define voussoir_output_report_load_arrows_h

#include <voussoir/scene/scene.h>

#include <vector>

namespace Voussoir
{
/** A load as a force on a line of action. */
struct LoadArrow
{
  /** What kind of load it is. */
  enum class Kind
  {
    traction,
    body_force,
    cell_force
  };
  Kind kind;                  /**< this */
  dealii::Point<2> place;     /**< where it acts, a length */
  dealii::Tensor<1, 2> force; /**< S L */
  /** True if it presses on a side, so that its head is at the place. */
  bool pushes;
};

/** All loads of @p scene: one for each side, block and named force. */
std::vector<LoadArrow> load_arrows(const Scene &scene);
} // namespace Voussoir

#endif
