// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/summary.h>
#include <voussoir/version.h>

#include <deal.II/base/config.h>

#include <CGAL/version.h>
#include <IpoptConfig.h>
#include <boost/version.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <ostream>

namespace Voussoir
{
void write_summary_json(std::ostream &out, const Results &results)
{
  const Packing &packing = results.scene.packing;
  const Certificate &certificate = results.certificate;

  nlohmann::ordered_json summary;
  summary["title"] = results.title;
  summary["status"] = results.status;
  summary["formulation"] = results.formulation;
  summary["selection"] = results.selection;
  summary["packing"] = {
      {"cells", packing.n_cells()},
      {"interfaces", packing.interfaces().size()},
      {"boundary_edges", packing.boundary_edges().size()},
      {"static_indeterminacy", packing.static_indeterminacy()}};
  summary["certificate"] = {
      {"equilibrium_residual", certificate.equilibrium_residual},
      {"admissibility_violation", certificate.admissibility_violation},
      {"max_utilisation", certificate.max_utilisation},
      {"max_torque", certificate.max_torque}};
  summary["solver"] = {{"iterations", results.n_iterations},
                       {"evaluations", results.n_evaluations}};
  summary["stress"] = {{"sub_cells", results.stress.sub_cells.size()},
                       {"undetermined_cells", results.stress.undetermined}};
  summary["timings"] = results.timings;
  summary["versions"] = {
      {"voussoir", VOUSSOIR_VERSION},
      {"deal.II", DEAL_II_PACKAGE_VERSION},
      {"Ipopt", IPOPT_VERSION},
      {"CGAL", CGAL_VERSION_STR},
      {"Boost", text(BOOST_VERSION / 100000, ".", BOOST_VERSION / 100 % 1000,
                     ".", BOOST_VERSION % 100)},
      {"Trilinos",
       text(DEAL_II_TRILINOS_VERSION_MAJOR, ".", DEAL_II_TRILINOS_VERSION_MINOR,
            ".", DEAL_II_TRILINOS_VERSION_SUBMINOR)}};
  out << summary.dump(2, ' ', false,
                      nlohmann::ordered_json::error_handler_t::replace)
      << '\n';
}

void show_summary(Terminal &terminal, const Results &results)
{
  const Certificate &certificate = results.certificate;
  double most_compressed = 0.;
  const auto &interfaces = results.scene.packing.interfaces();
  for (unsigned int e = 0; e < interfaces.size(); ++e)
    most_compressed = std::min(most_compressed,
                               results.forces.normal[e] / interfaces[e].length);

  terminal.summary("Status", results.status);
  terminal.summary("Selection", results.selection);
  terminal.summary("Equilibrium",
                   text("residual ", certificate.equilibrium_residual,
                        " of the largest load on a cell"));
  terminal.summary("Admissibility",
                   text("violation ", certificate.admissibility_violation,
                        " of the largest load on a cell"));
  terminal.summary("Friction",
                   text("largest utilisation ", certificate.max_utilisation));
  terminal.summary(
      "Contact",
      text("largest compressive stress on an interface ", -most_compressed));
  terminal.summary(
      "Torque", text("largest residual ", certificate.max_torque,
                     " of load times cell size; rotations are not balanced"));
}
} // namespace Voussoir
