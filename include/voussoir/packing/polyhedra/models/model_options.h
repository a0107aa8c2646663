// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_models_model_options_h
#define voussoir_packing_polyhedra_models_model_options_h

namespace Voussoir
{
/** How the blocks of a model become cells. */
struct ModelOptions
{
  /** What all coordinates are multiplied by. */
  double scale = 1.;
  /** CellFaces::tolerance over the size of a block; 0: see cells_of_model(). */
  double tolerance = 0.;
  /** True if blocks that the file calls supports are fixed. */
  bool uses_supports = true;
};
} // namespace Voussoir

#endif
