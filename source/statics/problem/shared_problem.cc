// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/statics/problem/find_opening.h>
#include <voussoir/statics/problem/shared_problem.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>

namespace Voussoir
{
using Joint = Structure::Joint;

namespace
{
/** The cells per process below which communication outweighs computation. */
constexpr unsigned int least_cells_per_process = 500;

/**
 * Recursive coordinate bisection: cut the cells from @p begin to @p end - 1
 * into parts of equal numbers, @p n_parts of them from @p first_part on, always
 * across the longest side of their box.
 */
void bisect(const Structure &whole,
            const std::vector<unsigned int>::iterator begin,
            const std::vector<unsigned int>::iterator end,
            const unsigned int first_part,
            const unsigned int n_parts,
            std::vector<unsigned int> &part)
{
  if (n_parts == 1)
  {
    for (auto cell = begin; cell != end; ++cell)
      part[*cell] = first_part;
    return;
  }
  std::array<double, 3> extent = {};
  for (unsigned int i = 0; i < whole.n_translations(); ++i)
  {
    const auto [low, high] = std::minmax_element(
        begin, end, [&](const unsigned int a, const unsigned int b) {
          return whole.centre(a)[i] < whole.centre(b)[i];
        });
    extent[i] =
        begin == end ? 0. : whole.centre(*high)[i] - whole.centre(*low)[i];
  }
  const unsigned int i =
      std::max_element(extent.begin(), extent.end()) - extent.begin();
  const unsigned int n_first = n_parts / 2;
  const auto middle =
      begin + static_cast<std::size_t>(end - begin) * n_first / n_parts;
  std::nth_element(begin, middle, end,
                   [&](const unsigned int a, const unsigned int b) {
                     return whole.centre(a)[i] < whole.centre(b)[i];
                   });
  bisect(whole, begin, middle, first_part, n_first, part);
  bisect(whole, middle, end, first_part + n_first, n_parts - n_first, part);
}

/** Send all that a part has by @p pass, or receive it. */
template <typename Part, typename Pass>
void transfer(Part &part, const Pass &pass)
{
  const Kinematics &kinematics = part.kinematics;
  std::vector<unsigned int> motions = {kinematics.n_translations(),
                                       kinematics.n_rotations()};
  std::vector<char> name(kinematics.name().begin(), kinematics.name().end());
  pass(motions);
  pass(name);
  part.kinematics =
      Kinematics(std::string(name.begin(), name.end()), motions[0], motions[1]);
  std::vector<unsigned int> numbers = {part.first, part.n_not_judged};
  pass(numbers);
  part.first = numbers[0];
  part.n_not_judged = numbers[1];
  pass(part.ghosts);
  pass(part.joints.list);
  pass(part.joints.first_row);
  pass(part.joints.direction);
  pass(part.joints.turn_minus);
  pass(part.joints.turn_plus);
  pass(part.joints.set_sizes);
  pass(part.joints.first_set);
  pass(part.joints.first_coefficient);
  pass(part.joints.shares);
  pass(part.joints.set_strengths);
  pass(part.loads);
  pass(part.centres);
}
} // namespace

ProcessGroup SharedProblem::helpers(const DiscreteProblem &whole,
                                    const ProcessGroup &processes)
{
  return whole.n_cells() >= least_cells_per_process * processes.size()
             ? processes
             : ProcessGroup();
}

SharedProblem::SharedProblem(const DiscreteProblem &whole) : whole(&whole) {}

SharedProblem::SharedProblem(const DiscreteProblem *whole,
                             const ProcessGroup &processes)
    : whole(whole), processes(processes)
{
  if (processes.size() == 1)
    return;
  Structure::Part own;
  if (processes.is_root())
  {
    cut();
    // Its own last, so that no more than two are held at a time.
    for (unsigned int r = processes.size(); r-- > 0;)
    {
      own = make_part(r);
      if (r > 0)
        transfer(own, [&](const auto &values) { processes.send(values, r); });
    }
  }
  else
    transfer(own, [&](auto &values) {
      values = processes.receive<
          typename std::remove_reference_t<decltype(values)>::value_type>(0);
    });
  part = std::make_unique<const Structure>(processes, std::move(own));
}

void SharedProblem::cut()
{
  AssertThrow(whole->n_cells() >= processes.size(), dealii::ExcInternalError());
  std::vector<unsigned int> part(whole->n_bodies(), 0); // that of the ground
  std::vector<unsigned int> cells(whole->n_cells());
  std::iota(cells.begin(), cells.end(), 0);
  bisect(*whole, cells.begin(), cells.end(), 0, processes.size(), part);

  first_body.assign(processes.size() + 1, 0);
  for (const unsigned int p : part)
    ++first_body[p + 1];
  std::partial_sum(first_body.begin(), first_body.end(), first_body.begin());
  std::vector<unsigned int> next(first_body.begin(), first_body.end() - 1);
  bodies.resize(part.size());
  number.resize(part.size());
  for (unsigned int b = 0; b < part.size(); ++b)
  {
    number[b] = next[part[b]]++;
    bodies[number[b]] = b;
  }

  joints_of.resize(processes.size());
  for (unsigned int e = 0; e < whole->joints().size(); ++e)
  {
    const unsigned int one = part[whole->joints()[e].cell_minus];
    const unsigned int other = part[whole->joints()[e].cell_plus];
    joints_of[one].push_back(e);
    if (other != one)
      joints_of[other].push_back(e);
  }
}

Structure::Part SharedProblem::make_part(const unsigned int process) const
{
  const unsigned int begin = first_body[process], end = first_body[process + 1];
  const auto is_own = [&](const unsigned int k) {
    return begin <= k && k < end;
  };
  Structure::Part result;
  result.kinematics = whole->kinematics();
  result.first = begin;
  if (is_own(number.back())) // the ground, or none whose balance is not judged
    result.n_not_judged = whole->n_own_dofs() - whole->n_judged_dofs();
  for (unsigned int k = begin; k < end; ++k)
  {
    for (unsigned int i = 0; i < whole->n_unknowns(); ++i)
      result.loads.push_back(whole->loads()[whole->dof(bodies[k], i)]);
    result.centres.push_back(whole->centre(bodies[k]));
  }
  const std::vector<unsigned int> &joints = joints_of[process];
  for (const unsigned int e : joints)
    for (const unsigned int b :
         {whole->joints()[e].cell_minus, whole->joints()[e].cell_plus})
      if (!is_own(number[b]))
        result.ghosts.push_back(number[b]);
  std::sort(result.ghosts.begin(), result.ghosts.end());
  result.ghosts.erase(std::unique(result.ghosts.begin(), result.ghosts.end()),
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
  std::size_t n_rows = 0;
  for (const unsigned int e : joints)
    n_rows += whole->n_rows(e);
  result.joints.reserve(joints.size(), n_rows, result.kinematics);
  for (const unsigned int e : joints)
  {
    Joint joint = whole->joints()[e];
    joint.cell_minus = local(joint.cell_minus);
    joint.cell_plus = local(joint.cell_plus);
    std::vector<double> shares;
    if (!whole->is_plane())
      whole->for_each_face_set(e, [&](const Structure::FaceSet &set) {
        shares.push_back(set.share);
        result.joints.set_strengths.push_back(set.strength);
      });
    result.joints.add(joint, whole->rows(e), result.kinematics, whole->sets(e),
                      shares);
  }
  return result;
}

std::vector<double> SharedProblem::of_joints(const NumberOfJoint &find) const
{
  std::vector<std::vector<double>> numbers(joints_of.size());
  for (unsigned int r = 0; r < joints_of.size(); ++r)
    for (const unsigned int e : joints_of[r])
      numbers[r].push_back(find(*whole, e));
  if (part)
    return processes.scatter(numbers);
  std::vector<double> of_all;
  for (unsigned int e = 0; e < whole->joints().size(); ++e)
    of_all.push_back(find(*whole, e));
  return of_all;
}

template <typename Action>
void SharedProblem::on_root(const Action &action) const
{
  std::string fault;
  bool failed = false;
  if (whole != nullptr)
    try
    {
      action();
    }
    catch (const SolverError &error)
    {
      fault = error.what();
      failed = true;
    }
  if (processes.broadcast(failed))
    throw SolverError(fault);
}

std::vector<double> SharedProblem::displacement(const Finder &find) const
{
  std::vector<double> of_whole;
  on_root([&]() { of_whole = find(*whole); });
  return part ? scatter(of_whole) : of_whole;
}

std::vector<double> SharedProblem::opening() const
{
  return displacement([](const DiscreteProblem &problem) {
    return opening_of(problem).displacement;
  });
}

bool SharedProblem::has_opening() const
{
  bool has_one = false;
  on_root([&]() { has_one = !opening_of(*whole).displacement.empty(); });
  return processes.broadcast(has_one);
}

std::optional<Mechanism> SharedProblem::search(const std::vector<double> &u,
                                               const Search &how) const
{
  std::optional<Mechanism> found;
  const std::vector<double> all = gather(u);
  on_root([&]() { found = how(*whole, all); });
  if (processes.broadcast(found.has_value()) && !found)
    found.emplace();
  return found;
}

void SharedProblem::collect(const std::vector<double> &u,
                            const std::vector<double> &forces,
                            Solution &solution) const
{
  std::vector<double> all = gather(u);
  const auto parts = processes.gather(forces);
  if (whole == nullptr)
    return;
  if (!part)
    solution.forces = parts.front();
  else
    solution.forces.resize(whole->n_all_rows());
  for (unsigned int r = 0; part && r < parts.size(); ++r)
  {
    auto of_joint = parts[r].begin();
    for (const unsigned int e : joints_of[r])
    {
      std::copy_n(of_joint, whole->n_rows(e),
                  solution.forces.begin() + whole->first_row(e));
      of_joint += whole->n_rows(e);
    }
  }
  whole->remove_rigid_motions(all);
  solution.u = std::move(all);
}

/** All unknowns in the order of the whole, on the root. */
std::vector<double> SharedProblem::gather(const std::vector<double> &u) const
{
  if (!part)
    return u;
  const auto parts = processes.gather(
      std::vector<double>(u.begin(), u.begin() + part->n_own_dofs()));
  const unsigned int n = part->n_unknowns();
  std::vector<double> all(n * bodies.size());
  for (unsigned int r = 0; r < parts.size(); ++r)
    for (std::size_t k = 0; k < parts[r].size(); ++k)
      all[part->dof(bodies[first_body[r] + k / n], k % n)] = parts[r][k];
  return all;
}

/** The part of what the root has in the order of the whole. */
std::vector<double> SharedProblem::scatter(const std::vector<double> &u) const
{
  std::vector<std::vector<double>> parts(processes.is_root() ? processes.size()
                                                             : 0);
  for (unsigned int r = 0; r < parts.size(); ++r)
    for (unsigned int k = first_body[r]; k < first_body[r + 1]; ++k)
      for (unsigned int i = 0; i < part->n_unknowns(); ++i)
        parts[r].push_back(u[part->dof(bodies[k], i)]);
  std::vector<double> result = processes.scatter(parts);
  result.resize(part->n_dofs());
  part->update_ghosts(result);
  return result;
}
} // namespace Voussoir
