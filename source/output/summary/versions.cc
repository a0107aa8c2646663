// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/summary/versions.h>
#include <voussoir/version.h>

#include <deal.II/base/config.h>

#include <CGAL/version.h>
#include <IpoptConfig.h>
#include <boost/version.hpp>

#include <cholmod.h>

namespace Voussoir
{
nlohmann::ordered_json library_versions()
{
  return {{"voussoir", VOUSSOIR_VERSION},
          {"deal.II", DEAL_II_PACKAGE_VERSION},
          {"Ipopt", IPOPT_VERSION},
          {"CHOLMOD", text(CHOLMOD_MAIN_VERSION, ".", CHOLMOD_SUB_VERSION, ".",
                           CHOLMOD_SUBSUB_VERSION)},
          {"CGAL", CGAL_VERSION_STR},
          {"Boost", text(BOOST_VERSION / 100000, ".",
                         BOOST_VERSION / 100 % 1000, ".", BOOST_VERSION % 100)},
          {"Trilinos", text(DEAL_II_TRILINOS_VERSION_MAJOR, ".",
                            DEAL_II_TRILINOS_VERSION_MINOR, ".",
                            DEAL_II_TRILINOS_VERSION_SUBMINOR)}};
}
} // namespace Voussoir
