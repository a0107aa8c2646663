// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/commit.h>
#include <voussoir/output/summary/versions.h>

namespace Voussoir
{
std::string commit()
{
  return VOUSSOIR_COMMIT;
}
} // namespace Voussoir
