// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/contact/contact_points.h>

namespace Voussoir
{
const ContactPoints &contact_points(const bool blocks_turn)
{
  static const ContactPoint midpoint = {0.5};
  static const ContactPoints of_translations = {{midpoint}, midpoint};
  static const ContactPoints of_rotations = {{{0.}, {1.}}, midpoint};
  return blocks_turn ? of_rotations : of_translations;
}
} // namespace Voussoir
