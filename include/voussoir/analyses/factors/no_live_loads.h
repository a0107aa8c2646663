// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_factors_no_live_loads_h
#define voussoir_analyses_factors_no_live_loads_h

#include <voussoir/base/exceptions.h>

namespace Voussoir
{
/**
 * There are no loads that a factor could multiply: a fault of a scene, but not
 * of one among many, as where a vehicle has left the blocks.
 */
class NoLiveLoads : public InputError
{
public:
  using InputError::InputError;
};
} // namespace Voussoir

#endif
