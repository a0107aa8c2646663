// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/content_name.h>

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>

namespace Voussoir
{
std::string name_of_content(const std::string &content)
{
  boost::uuids::name_generator_sha1 of(boost::uuids::ns::oid());
  return to_string(of(content.data(), content.size()));
}
} // namespace Voussoir
