// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/csv.h>
#include <voussoir/output/summary/text_lines.h>
#include <voussoir/scene/proofs/displacement_jumps.h>
#include <voussoir/scene/proofs/utilisation.h>

#include <array>
#include <cmath>
#include <ostream>

namespace Voussoir
{
namespace
{
/** The number of cell c+ of an interface: of the ground, -1. */
int number_of_plus(const Packing &packing, const Packing::Interface &interface)
{
  return interface.cell_plus == packing.ground() ? -1 : interface.cell_plus;
}

/** The names of the columns of what a scene has of the limits. */
std::string columns_of_limits(const Scene &scene)
{
  return std::string(scene.coefficient.empty() ? "" : ",coefficient") +
         (scene.tensile_strength.empty() ? "" : ",tensile_strength") +
         (scene.compressive_strength.empty() ? "" : ",compressive_strength");
}

/** The ranges of the forces of interface @p e; empty where not asked for. */
void add_ranges(TextLines &line, const Ranges &ranges, const unsigned int e)
{
  const bool has_places = !ranges.eccentricity.empty();
  if (!ranges.wanted[e])
  {
    line << ",,,,," << (has_places ? ",," : "")
         << (ranges.are_inner ? ",," : "");
    return;
  }
  line << ',' << 0. - ranges.normal[e].greatest << ','
       << 0. - ranges.normal[e].least << ',' << ranges.tangential[e].least
       << ',' << ranges.tangential[e].greatest << ','
       << int(ranges.is_determined(e));
  if (has_places)
  {
    const Range &place = ranges.eccentricity[e];
    if (std::isnan(place.least))
      line << ",,";
    else
      line << ',' << place.least << ',' << place.greatest;
  }
  if (ranges.are_inner)
    line << ',' << ranges.normal[e].beyond << ','
         << ranges.tangential[e].beyond;
}

/** The columns of samples; empty if they have not settled. */
void add_samples(TextLines &line,
                 const StateSamples &samples,
                 const unsigned int e)
{
  if (!samples.have_settled())
  {
    line << ",,,,,,,";
    return;
  }
  const Moments &normal = samples.normal[e],
                &tangential = samples.tangential[e];
  line << ',' << 0. - normal.mean << ',' << normal.error << ','
       << normal.deviation << ',' << tangential.mean << ',' << tangential.error
       << ',' << tangential.deviation << ',' << samples.correlation[e];
}

void add_limits(TextLines &line, const Scene &scene, const unsigned int e)
{
  for (const auto *limits : {&scene.coefficient, &scene.tensile_strength,
                             &scene.compressive_strength})
    if (!limits->empty())
      line << ',' << (*limits)[e];
}
} // namespace

void write_interfaces_csv(std::ostream &out, const Results &results)
{
  const bool marked = !results.never_pressed.empty();
  const Scene &scene = results.scene;
  out << "cell_minus,cell_plus,x0,y0,x1,y1,nx,ny,length,normal_force,"
         "tangential_force,strength,utilisation"
      << (marked ? ",never_pressed,always_sliding" : "")
      << (scene.turns() ? ",normal_force_0,normal_force_1,eccentricity" : "")
      << columns_of_limits(scene)
      << (scene.compressive_strength.empty() ? "" : ",crushing_utilisation")
      << (results.ranges ? ",p_min,p_max,q_min,q_max,determined" : "")
      << (results.ranges && !results.ranges->eccentricity.empty()
              ? ",e_min,e_max"
              : "")
      << (results.ranges && results.ranges->are_inner ? ",p_beyond,q_beyond"
                                                      : "")
      << (results.samples ? ",p_mean,p_mean_error,p_deviation,q_mean,"
                            "q_mean_error,q_deviation,correlation"
                          : "")
      << ",branch_x,branch_y\n";
  const auto &interfaces = scene.packing.interfaces();
  const Utilisation utilisation(scene, results.forces);
  write_lines(out, interfaces.size(), [&](TextLines &line, unsigned int e) {
    const Packing::Interface &i = interfaces[e];
    line.row(i.cell_minus, number_of_plus(scene.packing, i), i.start[0],
             i.start[1], i.end[0], i.end[1], i.normal[0], i.normal[1], i.length,
             results.forces.normal[e], results.forces.tangential[e],
             scene.strength[e], utilisation(e));
    if (marked)
      line << ',' << int(results.never_pressed[e]) << ','
           << int(results.always_sliding[e]);
    if (scene.turns())
      line << ',' << results.forces.at_ends[e][0] << ','
           << results.forces.at_ends[e][1] << ','
           << results.forces.eccentricity(i, e);
    add_limits(line, scene, e);
    if (!scene.compressive_strength.empty())
      line << ','
           << scene.limits(e).crushing_utilisation(results.forces.ends(e));
    if (results.ranges)
      add_ranges(line, *results.ranges, e);
    if (results.samples)
      add_samples(line, *results.samples, e);
    const dealii::Tensor<1, 2> branch =
        (i.cell_plus == scene.packing.ground()
             ? i.midpoint()
             : scene.packing.centre(i.cell_plus)) -
        scene.packing.centre(i.cell_minus);
    line << ',' << branch[0] << ',' << branch[1] << '\n';
  });
}

void write_boundary_csv(std::ostream &out, const Results &results)
{
  out << "cell,x0,y0,x1,y1,nx,ny,length,force_x,force_y,moment_x,moment_y,"
         "branch_x,branch_y\n";
  const Scene &scene = results.scene;
  const auto &edges = scene.packing.boundary_edges();
  write_lines(out, edges.size(), [&](TextLines &line, unsigned int b) {
    const Packing::BoundaryEdge &edge = edges[b];
    const dealii::Tensor<1, 2> force = edge.length * scene.traction[b];
    const dealii::Tensor<1, 2> &moment = scene.traction_moment[b];
    const dealii::Tensor<1, 2> branch =
        edge.midpoint() - scene.packing.centre(edge.cell);
    line.row(edge.cell, edge.start[0], edge.start[1], edge.end[0], edge.end[1],
             edge.normal[0], edge.normal[1], edge.length, force[0], force[1],
             moment[0], moment[1], branch[0], branch[1]);
    line << '\n';
  });
}

void write_cells_csv(std::ostream &out, const Results &results)
{
  const bool turns = results.scene.turns();
  out << "id,x,y,area,load_x,load_y,ux,uy,torque,sxx,sxy,syx,syy,group"
      << (turns ? ",load_torque,rotation\n" : "\n");
  const Packing &packing = results.scene.packing;
  write_lines(out, packing.n_cells(), [&](TextLines &line, unsigned int c) {
    const dealii::Tensor<2, 2> &s = results.mean_stresses[c];
    line.row(c, packing.centre(c)[0], packing.centre(c)[1], packing.area(c),
             results.scene.load[c][0], results.scene.load[c][1],
             results.motion.displacement[c][0],
             results.motion.displacement[c][1], results.torques[c], s[0][0],
             s[0][1], s[1][0], s[1][1], packing.group_name(c));
    if (turns)
      line << ',' << results.scene.load_torque[c] << ','
           << results.motion.rotation[c];
    line << '\n';
  });
}

void write_mechanism_csv(std::ostream &out,
                         const Scene &scene,
                         const Motion &motion)
{
  out << "id,x,y,load_x,load_y,ux,uy,group"
      << (scene.turns() ? ",load_torque,rotation\n" : "\n");
  const Packing &packing = scene.packing;
  write_lines(out, packing.n_cells(), [&](TextLines &line, unsigned int c) {
    const dealii::Point<2> &x = packing.centre(c);
    const dealii::Tensor<1, 2> &F = scene.load[c];
    const dealii::Tensor<1, 2> &u = motion.displacement[c];
    line.row(c, x[0], x[1], F[0], F[1], u[0], u[1], packing.group_name(c));
    if (scene.turns())
      line << ',' << scene.load_torque[c] << ',' << motion.rotation[c];
    line << '\n';
  });
}

void write_mechanism_joints_csv(std::ostream &out,
                                const Scene &scene,
                                const Motion &motion)
{
  out << "cell_minus,cell_plus,x0,y0,x1,y1,nx,ny,length,strength,opening,"
         "sliding,dissipation"
      << (scene.turns() ? ",opening_0,opening_1" : "")
      << columns_of_limits(scene) << '\n';
  const auto &interfaces = scene.packing.interfaces();
  const InterfaceJumps jumps = jumps_of(scene.packing, motion);
  write_lines(out, interfaces.size(), [&](TextLines &line, unsigned int e) {
    const Packing::Interface &i = interfaces[e];
    const std::array<double, 2> &openings = jumps.openings[e];
    line.row(
        i.cell_minus, number_of_plus(scene.packing, i), i.start[0], i.start[1],
        i.end[0], i.end[1], i.normal[0], i.normal[1], i.length,
        scene.strength[e], 0.5 * (openings[0] + openings[1]), jumps.sliding[e],
        scene.limits(e).resistance(openings, jumps.sliding[e]).dissipation);
    if (scene.turns())
      line << ',' << openings[0] << ',' << openings[1];
    add_limits(line, scene, e);
    line << '\n';
  });
}
} // namespace Voussoir
