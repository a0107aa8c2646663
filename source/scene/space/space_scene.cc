// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/connected_groups.h>
#include <voussoir/scene/space/space_scene.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace Voussoir
{
using dealii::Tensor;

namespace
{
/** The sum of forces or moments on a group that is rounding, over their sizes.
 */
constexpr double rounding_of_balance_in_space = 1e-10;
/** The sum of the forces on one cell, over their sizes, that is cancelled. */
constexpr double cancelled_in_space = 1e-14;

std::string text_of_vector(const Tensor<1, 3> &v)
{
  return text('(', v[0], ", ", v[1], ", ", v[2], ')');
}

/** What acts on a connected group, about the centre of its lowest cell. */
struct LoadOfGroup
{
  Tensor<1, 3> force, moment;
  double size = 0., size_of_moment = 0.;
  unsigned int n_cells = 0;
};

double reach_of(const Packing<3> &packing, const unsigned int c)
{
  return std::cbrt(packing.volume(c));
}
} // namespace

SpaceBlocks::SpaceBlocks(Packing<3> packing_in,
                         Strengths strengths_in,
                         const Kinematics &kinematics,
                         const unsigned int n_cuts)
    : packing(std::move(packing_in)), strengths(std::move(strengths_in)),
      kinematics(&kinematics), group(connected_groups(packing))
{
  points.reserve(packing.interfaces().size());
  for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
  {
    points.push_back(
        face_points(packing.polygon(e), kinematics.turns(), n_cuts));
    // A section that crushes bears nothing at its vertices.
    if (!strengths.compressive.empty() &&
        std::isfinite(strengths.compressive[e]))
      points.back().pressure = points.back().friction;
  }
}

double SpaceBlocks::strength_under_tension(const unsigned int e) const
{
  return std::max(strength(e) - coefficient(e) * tensile(e), 0.);
}

void SpaceLoads::add(const unsigned int cell,
                     const Tensor<1, 3> &f,
                     const Tensor<1, 3> &arm)
{
  force[cell] += f;
  torque[cell] += cross_product_3d(arm, f);
  first_moment[cell] += outer_product(f, arm);
  size[cell] += f.norm();
}

void SpaceLoads::add_on_face(const unsigned int face,
                             const std::size_t n_faces,
                             const Tensor<1, 3> &f,
                             const Tensor<1, 3> &moment)
{
  on_faces.resize(n_faces);
  on_faces[face].force += f;
  on_faces[face].moment += moment;
}

void SpaceLoads::add(const double factor, const SpaceLoads &others)
{
  for (unsigned int c = 0; c < size.size(); ++c)
  {
    force[c] += factor * others.force[c];
    torque[c] += factor * others.torque[c];
    first_moment[c] += factor * others.first_moment[c];
    size[c] += std::abs(factor) * others.size[c];
  }
  if (!others.on_faces.empty())
    on_faces.resize(others.on_faces.size());
  for (std::size_t b = 0; b < others.on_faces.size(); ++b)
  {
    on_faces[b].force += factor * others.on_faces[b].force;
    on_faces[b].moment += factor * others.on_faces[b].moment;
  }
}

SpaceScene::SpaceScene(std::shared_ptr<const SpaceBlocks> blocks_in,
                       SpaceLoads loads_in)
    : blocks(std::move(blocks_in)), loads(std::move(loads_in))
{
  check_sizes();
  for (unsigned int c = 0; c < packing().n_cells(); ++c)
  {
    // Rounding must not pass for a load where all forces on a cell cancel.
    if (loads.force[c].norm() <= cancelled_in_space * loads.size[c])
      loads.force[c] = 0.;
    if (loads.torque[c].norm() <=
        cancelled_in_space * loads.size[c] * reach_of(packing(), c))
      loads.torque[c] = 0.;
  }
  check_balance();
}

bool SpaceScene::is_loaded() const
{
  return std::any_of(loads.size.begin(), loads.size.end(),
                     [](const double size) { return size > 0.; });
}

void SpaceScene::check_sizes() const
{
  for (unsigned int c = 0; c < packing().n_cells(); ++c)
  {
    const Tensor<1, 3> &f = loads.force[c];
    const bool is_zero = f[0] == 0. && f[1] == 0. && f[2] == 0.;
    if (!std::isfinite(f.norm()) || (!is_zero && !(f.norm() > 0.)) ||
        !std::isfinite(loads.torque[c].norm()))
      throw InputError(text(
          "The load on ", packing().describe(c), " at ",
          text_of_point(packing().centre(c)), " is ", text_of_vector(f),
          ", a force whose square is beyond the computer's numbers. Choose "
          "units in which it is between 1e-150 and 1e150."));
  }
}

void SpaceScene::check_balance() const
{
  const std::vector<unsigned int> &group = blocks->group;
  std::vector<LoadOfGroup> of(group.size());
  for (unsigned int c = 0; c < packing().n_cells(); ++c)
  {
    LoadOfGroup &sum = of[group[c]];
    const Tensor<1, 3> arm = packing().centre(c) - packing().centre(group[c]);
    sum.force += loads.force[c];
    sum.moment += loads.torque[c] + cross_product_3d(arm, loads.force[c]);
    sum.size += loads.size[c];
    sum.size_of_moment += loads.size[c] * (arm.norm() + reach_of(packing(), c));
    ++sum.n_cells;
  }
  for (unsigned int g = 0; g < packing().n_cells(); ++g)
  {
    if (g == group[packing().ground()] || of[g].n_cells == 0)
      continue;
    const bool is_pushed =
        of[g].force.norm() > rounding_of_balance_in_space * of[g].size;
    const bool is_turned =
        blocks->turns() && of[g].moment.norm() > rounding_of_balance_in_space *
                                                     of[g].size_of_moment;
    if (!is_pushed && !is_turned)
      continue;
    const std::string where =
        of[g].n_cells == packing().n_cells()
            ? "the packing"
            : text(of[g].n_cells > 1 ? "the connected group of cells around "
                                     : "",
                   packing().describe(g), " at ",
                   text_of_point(packing().centre(g)));
    throw InputError(
        text("The loads are not balanced: on ", where,
             is_pushed ? " their sum is " : " their moment is ",
             text_of_vector(is_pushed ? of[g].force : of[g].moment),
             ", and nothing supports it. Change the loads, choose "
             "'Supports/Where', or set a larger 'Tolerance' if it should touch "
             "others."));
  }
}
} // namespace Voussoir
