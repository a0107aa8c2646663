// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/shared_problem.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace Voussoir
{
using dealii::Tensor;
using Joint = Structure::Joint;
using Jump = Structure::Jump;

namespace
{
/** The cells in their order along a Hilbert curve through their centres. */
std::vector<unsigned int>
along_hilbert_curve(const std::vector<Tensor<1, 2>> &centres)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_2> points;
  points.reserve(centres.size());
  for (const Tensor<1, 2> &x : centres)
    points.emplace_back(x[0], x[1]);
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  using Map = CGAL::Pointer_property_map<Kernel::Point_2>::type;
  CGAL::hilbert_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_2<Kernel, Map>(
                         CGAL::make_property_map(points)));
  return {order.begin(), order.end()};
}

/** The joints of each body, and where those of each begin. */
struct Incidence
{
  explicit Incidence(const Structure &structure)
      : first(structure.n_bodies() + 1, 0), joints(2 * structure.joints().size())
  {
    const auto for_ends = [&](const auto &visit) {
      for (unsigned int e = 0; e < structure.joints().size(); ++e)
        for (const unsigned int b : {structure.joints()[e].cell_minus,
                                     structure.joints()[e].cell_plus})
          visit(b, e);
    };
    for_ends([&](const unsigned int b, unsigned int) { ++first[b + 1]; });
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<unsigned int> next(first.begin(), first.end() - 1);
    for_ends([&](const unsigned int b, const unsigned int e) {
      joints[next[b]++] = e;
    });
  }

  std::vector<unsigned int> first, joints;
};
} // namespace

SharedProblem::SharedProblem(const DiscreteProblem &whole) : whole(&whole)
{
}

SharedProblem::SharedProblem(const DiscreteProblem *whole, const Team &team)
    : whole(whole), team(team)
{
  if (team.size() == 1)
    return;
  Structure::Part own;
  if (team.is_root())
  {
    number_bodies();
    joints_of.resize(team.size());
    const Incidence incidence(*whole);
    // Its own last, so that no more than two are held at a time.
    for (unsigned int r = team.size(); r-- > 0;)
    {
      own = make_part(r, incidence.first, incidence.joints);
      if (r > 0)
      {
        team.send(std::vector<unsigned int>{own.first}, r);
        team.send(own.ghosts, r);
        team.send(own.joints, r);
        team.send(own.loads, r);
      }
    }
  }
  else
  {
    own.first = team.receive<unsigned int>(0).front();
    own.ghosts = team.receive<unsigned int>(0);
    own.joints = team.receive<Joint>(0);
    own.loads = team.receive<Tensor<1, 2>>(0);
  }
  part = std::make_unique<const Structure>(team, std::move(own));
}

void SharedProblem::number_bodies()
{
  bodies = along_hilbert_curve(whole->centres());
  for (unsigned int b = whole->n_cells(); b < whole->n_bodies(); ++b)
    bodies.push_back(b);
  number.resize(bodies.size());
  for (unsigned int k = 0; k < bodies.size(); ++k)
    number[bodies[k]] = k;
  for (unsigned int r = 0; r <= team.size(); ++r)
    first_body.push_back(std::size_t(bodies.size()) * r / team.size());
}

Structure::Part
SharedProblem::make_part(const unsigned int process,
                         const std::vector<unsigned int> &first_joint,
                         const std::vector<unsigned int> &joints_of_body)
{
  const unsigned int begin = first_body[process], end = first_body[process + 1];
  const auto is_own = [&](const unsigned int k) {
    return begin <= k && k < end;
  };
  Structure::Part result;
  result.first = begin;
  std::vector<unsigned int> &joints = joints_of[process];
  for (unsigned int k = begin; k < end; ++k)
  {
    const unsigned int b = bodies[k];
    result.loads.push_back(whole->loads()[b]);
    for (unsigned int i = first_joint[b]; i < first_joint[b + 1]; ++i)
    {
      const Joint &joint = whole->joints()[joints_of_body[i]];
      const unsigned int other = number[joint.cell_minus == b
                                            ? joint.cell_plus
                                            : joint.cell_minus];
      if (!is_own(other))
        result.ghosts.push_back(other);
      if (!is_own(other) || k < other)
        joints.push_back(joints_of_body[i]);
    }
  }
  std::sort(result.ghosts.begin(), result.ghosts.end());
  result.ghosts.erase(
      std::unique(result.ghosts.begin(), result.ghosts.end()),
      result.ghosts.end());

  const auto local = [&](const unsigned int body) {
    const unsigned int k = number[body];
    return is_own(k) ? k - begin
                     : end - begin +
                           static_cast<unsigned int>(
                               std::lower_bound(result.ghosts.begin(),
                                                result.ghosts.end(), k) -
                               result.ghosts.begin());
  };
  result.joints.reserve(joints.size());
  for (const unsigned int e : joints)
  {
    Joint joint = whole->joints()[e];
    joint.cell_minus = local(joint.cell_minus);
    joint.cell_plus = local(joint.cell_plus);
    result.joints.push_back(joint);
  }
  return result;
}

const Structure &SharedProblem::structure() const
{
  return part ? *part : *whole;
}

std::vector<double> SharedProblem::opening() const
{
  return part ? scatter(team.is_root() ? whole->opening()
                                       : std::vector<double>())
              : whole->opening();
}

bool SharedProblem::has_opening() const
{
  return team.broadcast(whole != nullptr && !whole->opening().empty());
}

std::optional<Mechanism>
SharedProblem::find_mechanism(const std::vector<double> &u) const
{
  std::optional<Mechanism> found;
  const std::vector<double> all = gather(u);
  if (whole != nullptr)
    found = Voussoir::find_mechanism(*whole, all);
  if (team.broadcast(found.has_value()) && !found)
    found.emplace();
  return found;
}

void SharedProblem::collect(const std::vector<double> &u,
                            const std::vector<Jump> &forces,
                            const double displacement_unit,
                            Solution &solution) const
{
  std::vector<double> all = gather(u);
  const auto parts = team.gather(forces);
  if (whole == nullptr)
    return;
  InterfaceForces &result = solution.forces;
  result.normal.resize(whole->joints().size());
  result.tangential.resize(whole->joints().size());
  for (unsigned int r = 0; r < parts.size(); ++r)
    for (unsigned int k = 0; k < parts[r].size(); ++k)
    {
      const unsigned int e = part ? joints_of[r][k] : k;
      result.normal[e] = parts[r][k].normal;
      result.tangential[e] = parts[r][k].tangential;
    }
  whole->remove_translations(all);
  solution.displacement = whole->displacement_of_cells(all, displacement_unit);
}

/** All unknowns in the order of the whole, on the root. */
std::vector<double> SharedProblem::gather(const std::vector<double> &u) const
{
  if (!part)
    return u;
  const auto parts = team.gather(
      std::vector<double>(u.begin(), u.begin() + part->n_own_dofs()));
  std::vector<double> all(2 * bodies.size());
  for (unsigned int r = 0; r < parts.size(); ++r)
    for (unsigned int k = 0; k < parts[r].size(); ++k)
      all[Structure::dof(bodies[first_body[r] + k / 2], k % 2)] = parts[r][k];
  return all;
}

/** The part of what the root has in the order of the whole. */
std::vector<double> SharedProblem::scatter(const std::vector<double> &u) const
{
  std::vector<std::vector<double>> parts(team.is_root() ? team.size() : 0);
  for (unsigned int r = 0; r < parts.size(); ++r)
    for (unsigned int k = first_body[r]; k < first_body[r + 1]; ++k)
      for (unsigned int i = 0; i < 2; ++i)
        parts[r].push_back(u[Structure::dof(bodies[k], i)]);
  std::vector<double> result = team.scatter(parts);
  result.resize(part->n_dofs());
  part->update_ghosts(result);
  return result;
}
} // namespace Voussoir
