// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/discrete_problem.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace Voussoir
{
using dealii::Tensor;

DiscreteProblem::DiscreteProblem(const Scene &scene)
    : DiscreteProblem(scene, std::vector<bool>(scene.packing.n_cells(), true))
{
}

DiscreteProblem::DiscreteProblem(const Scene &scene,
                                 const std::vector<bool> &moves)
{
  choose_scales(scene, moves);
  const Packing &packing = scene.packing;

  const double area = packing.area();
  Tensor<1, 2> centroid;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    centroid += packing.area(c) / area * packing.centre(c);
  centre.reserve(packing.n_cells());
  load.reserve(packing.n_cells() + 1);
  std::vector<unsigned int> body(packing.n_cells() + 1);
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    if (moves[c])
    {
      body[c] = centre.size();
      centre.push_back((packing.centre(c) - centroid) / length_unit);
      load.push_back(scene.load[c] / (stress_unit * length_unit));
    }
  for (unsigned int c = 0; c <= packing.n_cells(); ++c)
    if (c == packing.ground() || !moves[c])
      body[c] = n_cells();

  joint_list.reserve(packing.interfaces().size());
  bool has_ground = false;
  for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
  {
    add_joint(scene, e, body);
    has_ground |=
        !joint_list.empty() && joint_list.back().cell_plus == n_cells();
  }
  if (has_ground)
    load.emplace_back();
  connect_groups();
  balance_loads();
}

/** Joints with the ground have it as c+; those within it are none. */
void DiscreteProblem::add_joint(const Scene &scene,
                                const unsigned int interface,
                                const std::vector<unsigned int> &body)
{
  const Packing::Interface &i = scene.packing.interfaces()[interface];
  unsigned int minus = body[i.cell_minus], plus = body[i.cell_plus];
  Tensor<1, 2> normal = i.normal, tangent = i.tangent();
  if (minus == n_cells() && plus == n_cells())
    return;
  if (minus == n_cells())
  {
    std::swap(minus, plus);
    normal *= -1.;
    tangent *= -1.;
  }
  const double length = i.length / length_unit;
  joint_list.push_back({minus, plus, normal, tangent, length,
                        scene.packing.distance(i) / length_unit,
                        scene.strength[interface] / stress_unit * length});
}

/** Find the lowest body of each connected group. */
void DiscreteProblem::connect_groups()
{
  group.resize(n_bodies());
  std::iota(group.begin(), group.end(), 0u);
  const auto root_of = [&](unsigned int b) {
    while (group[b] != b)
      b = group[b] = group[group[b]];
    return b;
  };
  for (const Joint &joint : joint_list)
  {
    const unsigned int a = root_of(joint.cell_minus);
    const unsigned int b = root_of(joint.cell_plus);
    group[std::max(a, b)] = std::min(a, b);
  }
  for (unsigned int b = 0; b < n_bodies(); ++b)
    group[b] = root_of(b);
}

void DiscreteProblem::choose_scales(const Scene &scene,
                                    const std::vector<bool> &moves)
{
  const double area = scene.packing.area();
  length_unit = std::sqrt(area / scene.packing.n_cells());
  double largest = 0.;
  for (const Packing::Interface &i : scene.packing.interfaces())
    for (const dealii::Point<2> &x : {i.start, i.end})
      largest = std::max({largest, std::abs(x[0]), std::abs(x[1])});
  coordinate_rounding =
      std::numeric_limits<double>::epsilon() * largest / length_unit;

  // All forces on the packing over its size: of the order of the boundary
  // traction, or of the pressure at the foot of a wall under its own weight.
  double total = 0.;
  for (unsigned int c = 0; c < moves.size(); ++c)
    if (moves[c])
      total += scene.load[c].norm();
  has_load = total > 0.;
  if (has_load)
    stress_unit = total / std::sqrt(area);
}

/**
 * Spread the total force of a group that rounding leaves over its cells; the
 * ground takes that of its own group.
 */
void DiscreteProblem::balance_loads()
{
  // With many cells the sum of doubles would be off by more than a solver's
  // tolerance.
  using Sum = std::array<long double, 2>;
  const bool has_ground = n_bodies() > n_cells();
  std::vector<Sum> sum(n_bodies(), Sum{{0., 0.}});
  std::vector<unsigned int> size(n_bodies(), 0);
  for (unsigned int b = 0; b < n_bodies(); ++b)
  {
    for (unsigned int i = 0; i < 2; ++i)
      sum[group[b]][i] += load[b][i];
    ++size[group[b]];
  }
  for (unsigned int b = 0; b < n_bodies(); ++b)
    for (unsigned int i = 0; i < 2; ++i)
      if (!has_ground || group[b] != group.back())
        load[b][i] -= sum[group[b]][i] / size[group[b]];
      else if (b == n_cells())
        load[b][i] = -sum[group[b]][i];
}

void DiscreteProblem::remove_translations(std::vector<double> &u) const
{
  const bool has_ground = n_bodies() > n_cells();
  std::vector<Tensor<1, 2>> sum(n_bodies());
  std::vector<unsigned int> size(n_bodies(), 0);
  for (unsigned int b = 0; b < n_bodies(); ++b)
  {
    for (unsigned int i = 0; i < 2; ++i)
      sum[group[b]][i] += u[dof(b, i)];
    ++size[group[b]];
  }
  if (has_ground)
  {
    size[group.back()] = 1;
    for (unsigned int i = 0; i < 2; ++i)
      sum[group.back()][i] = u[dof(n_cells(), i)];
  }
  for (unsigned int b = 0; b < n_bodies(); ++b)
    for (unsigned int i = 0; i < 2; ++i)
      u[dof(b, i)] -= sum[group[b]][i] / size[group[b]];
}

void DiscreteProblem::hold_bodies(std::vector<double> &u) const
{
  std::vector<Tensor<1, 2>> held(n_bodies());
  for (unsigned int b = 0; b < n_bodies(); ++b)
    if (is_held(b))
      for (unsigned int i = 0; i < 2; ++i)
        held[group[b]][i] = u[dof(b, i)];
  for (unsigned int b = 0; b < n_bodies(); ++b)
    for (unsigned int i = 0; i < 2; ++i)
      u[dof(b, i)] -= held[group[b]][i];
}

std::vector<Tensor<1, 2>>
DiscreteProblem::displacement_of_cells(const std::vector<double> &u,
                                       const double unit) const
{
  std::vector<Tensor<1, 2>> displacement(n_cells());
  for (unsigned int c = 0; c < n_cells(); ++c)
    for (unsigned int i = 0; i < 2; ++i)
      displacement[c][i] = unit * u[dof(c, i)];
  return displacement;
}

unsigned int DiscreteProblem::n_cells() const
{
  return centre.size();
}

bool DiscreteProblem::is_loaded() const
{
  return has_load;
}

const std::vector<Tensor<1, 2>> &DiscreteProblem::centres() const
{
  return centre;
}

bool DiscreteProblem::is_held(const unsigned int body) const
{
  const bool with_ground =
      n_bodies() > n_cells() && group[body] == group.back();
  return with_ground ? body == n_cells() : body == group[body];
}

DiscreteProblem
DiscreteProblem::with_strengths_up_to(const double strength) const
{
  DiscreteProblem problem(*this);
  for (Joint &joint : problem.joint_list)
    joint.strength = std::min(joint.strength, strength * joint.length);
  return problem;
}

DiscreteProblem DiscreteProblem::without_loads() const
{
  DiscreteProblem problem(*this);
  problem.load.assign(n_bodies(), Tensor<1, 2>());
  return problem;
}

double DiscreteProblem::length_scale() const
{
  return length_unit;
}

double DiscreteProblem::stress_scale() const
{
  return stress_unit;
}

double DiscreteProblem::rounding_of_coordinates() const
{
  return coordinate_rounding;
}
} // namespace Voussoir
