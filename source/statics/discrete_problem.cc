// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/discrete_problem.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
using dealii::Tensor;

DiscreteProblem::DiscreteProblem(const Scene &scene)
{
  choose_scales(scene);
  const Packing &packing = scene.packing;

  const double area = packing.area();
  Tensor<1, 2> centroid;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    centroid += packing.area(c) / area * packing.centre(c);
  centre.reserve(packing.n_cells());
  load.reserve(packing.n_cells());
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    centre.push_back((packing.centre(c) - centroid) / length_unit);
    load.push_back(scene.load[c] / (stress_unit * length_unit));
  }

  joint_list.reserve(packing.interfaces().size());
  for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
  {
    const Packing::Interface &i = packing.interfaces()[e];
    const double length = i.length / length_unit;
    const double distance =
        (packing.centre(i.cell_plus) - packing.centre(i.cell_minus)) *
        i.normal / length_unit;
    joint_list.push_back({i.cell_minus, i.cell_plus, i.normal, i.tangent(),
                          length, distance,
                          scene.strength[e] / stress_unit * length});
  }

  // What rounding leaves of the total force of a group is spread over its
  // cells, so that a translation does exactly no work.
  group = connected_groups(packing);
  remove_group_means(load);
}

void DiscreteProblem::choose_scales(const Scene &scene)
{
  const double area = scene.packing.area();
  length_unit = std::sqrt(area / scene.packing.n_cells());

  // All forces on the packing over its size: of the order of the boundary
  // traction, or of the pressure at the foot of a wall under its own weight.
  double total = 0.;
  for (const Tensor<1, 2> &F : scene.load)
    total += F.norm();
  has_load = total > 0.;
  if (has_load)
    stress_unit = total / std::sqrt(area);
}

void DiscreteProblem::remove_group_means(std::vector<Tensor<1, 2>> &v) const
{
  std::vector<Tensor<1, 2>> sum(n_cells());
  std::vector<unsigned int> size(n_cells(), 0);
  for (unsigned int c = 0; c < n_cells(); ++c)
  {
    sum[group[c]] += v[c];
    ++size[group[c]];
  }
  for (unsigned int c = 0; c < n_cells(); ++c)
    v[c] -= sum[group[c]] / size[group[c]];
}

unsigned int DiscreteProblem::n_cells() const
{
  return load.size();
}

unsigned int DiscreteProblem::n_dofs() const
{
  return 2 * n_cells();
}

const std::vector<DiscreteProblem::Joint> &DiscreteProblem::joints() const
{
  return joint_list;
}

const std::vector<Tensor<1, 2>> &DiscreteProblem::loads() const
{
  return load;
}

bool DiscreteProblem::is_loaded() const
{
  return has_load;
}

const std::vector<Tensor<1, 2>> &DiscreteProblem::centres() const
{
  return centre;
}

const std::vector<unsigned int> &DiscreteProblem::groups() const
{
  return group;
}

double DiscreteProblem::work(const double *u) const
{
  long double work = 0.;
  for (unsigned int c = 0; c < n_cells(); ++c)
    for (unsigned int i = 0; i < 2; ++i)
      work += load[c][i] * u[dof(c, i)];
  return work;
}

double DiscreteProblem::length_scale() const
{
  return length_unit;
}

double DiscreteProblem::stress_scale() const
{
  return stress_unit;
}
} // namespace Voussoir
