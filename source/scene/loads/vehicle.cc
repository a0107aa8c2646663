// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/group_names.h>
#include <voussoir/scene/loads/vehicle.h>

#include <boost/lexical_cast/try_lexical_convert.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace Voussoir
{
using dealii::Point;

namespace
{
/** The distance, over an edge's length, that counts as none. */
constexpr double largest_distance_from_edge = 1e-6;

/** One whose axles are known; in kN and m. */
struct KnownVehicle
{
  const char *name;
  const char *axles;
  const char *source;
};

constexpr KnownVehicle known_vehicles[] = {
    {"LM1", "0: 300 | 1.2: 300",
     "the tandem of lane 1, EN 1991-2:2003, 4.3.2, with adjustment factors of "
     "one"},
    {"LM2", "0: 400", "the single axle of EN 1991-2:2003, 4.3.3"},
    {"LM71", "0: 250 | 1.6: 250 | 3.2: 250 | 4.8: 250",
     "the axles of trains, EN 1991-2:2003, 6.3.2, without the line load beside "
     "them"},
    {"HL-93 truck", "0: 35 | 4.3: 145 | 8.6: 145",
     "AASHTO LRFD, 3.6.1.2.2, with the rear axles as near as they may be"},
    {"HL-93 tandem", "0: 110 | 1.2: 110", "AASHTO LRFD, 3.6.1.2.3"}};

double number_or_refuse(const std::string &text,
                        const std::string &axle,
                        const std::string &parameter)
{
  double number = 0.;
  if (!boost::conversion::try_lexical_convert(text, number) ||
      !std::isfinite(number))
    throw InputError("The parameter '" + parameter + "' has the axle '" + axle +
                     "'; \"distance: force\" of two finite numbers is "
                     "expected, as in 1.2: 300, or the name of a vehicle.");
  return number;
}

double height_at(const Packing<2>::BoundaryEdge &edge, const double x)
{
  const double share =
      std::clamp((x - edge.start[0]) / (edge.end[0] - edge.start[0]), 0., 1.);
  return edge.start[1] + share * (edge.end[1] - edge.start[1]);
}
} // namespace

std::vector<unsigned int> highest_edges(const Packing<2> &packing,
                                        const double x)
{
  std::vector<unsigned int> highest;
  double height = -std::numeric_limits<double>::infinity();
  const auto &edges = packing.boundary_edges();
  for (unsigned int b = 0; b < edges.size(); ++b)
  {
    const Packing<2>::BoundaryEdge &edge = edges[b];
    const double small = largest_distance_from_edge * edge.length;
    // Counterclockwise: the top of a cell runs to the left.
    if (!(edge.normal[1] > largest_distance_from_edge) ||
        x > edge.start[0] + small || x < edge.end[0] - small)
      continue;
    const double y = height_at(edge, x);
    if (y > height + small)
      highest.clear();
    if (y >= height - small)
      highest.push_back(b);
    height = std::max(height, y);
  }
  return highest;
}

void VehicleParameters::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  std::string known;
  for (const KnownVehicle &vehicle : known_vehicles)
    known += std::string(known.empty() ? " " : "; ") + "'" + vehicle.name +
             "': " + vehicle.axles + ", " + vehicle.source;
  prm.enter_subsection("Vehicle");
  prm.add_parameter("Axles", axles,
                    "The axles of a vehicle on top of the blocks, each by its "
                    "distance along x behind the first and its force "
                    "downwards: \"0: 300 | 1.2: 300\". A length, and a force "
                    "over 'Effective width'. Or one of these, in kN and m:" +
                        known + ".",
                    Anything());
  prm.add_parameter("Position", position,
                    "The place x of the first axle; a length. An axle stands "
                    "on the highest block there; one beside the blocks loads "
                    "none.",
                    Double());
  prm.add_parameter("Reversed", is_reversed,
                    "Whether the other axles are on the left of the first, "
                    "not on its right.");
  prm.add_parameter("Effective width", width,
                    "The width of the blocks, across the plane, that carries "
                    "the vehicle: the forces of axles are divided by it. A "
                    "length, positive.",
                    Double(0.));
  prm.leave_subsection();
}

std::vector<CellForce>
VehicleParameters::forces(const Packing<2> &packing,
                          const std::vector<Spreading> &soil,
                          const std::string &section,
                          std::vector<std::string> &warnings) const
{
  const std::string parameter = section + "/Vehicle/Axles";
  const auto known = std::find_if(
      std::begin(known_vehicles), std::end(known_vehicles),
      [&](const KnownVehicle &vehicle) { return axles == vehicle.name; });
  if (known == std::end(known_vehicles) && !axles.empty() &&
      axles.find(':') == std::string::npos)
  {
    std::string names;
    for (const KnownVehicle &vehicle : known_vehicles)
      names += std::string(names.empty() ? "" : ", ") + vehicle.name;
    throw InputError("The parameter '" + parameter + "' is '" + axles +
                     "', which is no vehicle; those are " + names +
                     ". Give one, or axles such as 0: 300 | 1.2: 300.");
  }
  if (!axles.empty() && !(width > 0.))
    throw InputError("The parameter '" + section +
                     "/Vehicle/Effective width' is 0; it must be positive.");
  std::vector<CellForce> forces;
  bool is_beside = false;
  for (const auto &[distance, value] : split_named_list(
           known == std::end(known_vehicles) ? axles : known->axles, parameter))
  {
    const std::string axle = distance + ": " + value;
    const double behind = number_or_refuse(distance, axle, parameter);
    const double force = number_or_refuse(value, axle, parameter);
    if (!(force > 0.))
      throw InputError("The parameter '" + parameter + "' has the axle '" +
                       axle +
                       "', whose force must be positive: it acts downwards.");
    const double x = position + (is_reversed ? -behind : behind);
    std::vector<CellForce> spread;
    for (const Spreading &body : soil)
      if (spread.empty())
        spread = body.forces(packing, x, force / width);
    if (!spread.empty())
    {
      std::move(spread.begin(), spread.end(), std::back_inserter(forces));
      continue;
    }
    const std::vector<unsigned int> below = highest_edges(packing, x);
    is_beside = is_beside || below.empty();
    for (const unsigned int b : below)
    {
      const Packing<2>::BoundaryEdge &edge = packing.boundary_edges()[b];
      forces.push_back(
          {text("cell ", edge.cell),
           {edge.cell},
           dealii::Tensor<1, 2>({0., -force / (width * double(below.size()))}),
           Point<2>(x, height_at(edge, x))});
    }
  }
  if (is_beside)
    warnings.push_back("An axle of '" + section +
                       "/Vehicle' stands beside the blocks, and loads none.");
  return forces;
}
} // namespace Voussoir
