// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/structure.h>
#include <voussoir/base/chunks.h>

#include <deal.II/base/index_set.h>

#include <utility>

namespace Voussoir
{

Structure::Structure(const Kinematics &kinematics)
    : unknowns_per_body(kinematics.n_unknowns())
{
  own.kinematics = kinematics;
}

Structure::Structure(const ProcessGroup &processes, Part part)
    : own(std::move(part)), group(processes),
      unknowns_per_body(own.kinematics.n_unknowns())
{
  if (processes.size() == 1)
    return;
  const unsigned int n_all_dofs =
      unknowns_per_body * processes.sum(n_own_bodies());
  dealii::IndexSet of_own(n_all_dofs), of_ghosts(n_all_dofs);
  of_own.add_range(dof(own.first, 0), dof(own.first + n_own_bodies(), 0));
  for (const unsigned int ghost : own.ghosts)
    of_ghosts.add_range(dof(ghost, 0), dof(ghost + 1, 0));
  exchange = std::make_shared<const dealii::Utilities::MPI::Partitioner>(
      of_own, of_ghosts, processes.communicator());
}

void Structure::update_ghosts(std::vector<double> &u) const
{
  if (!exchange)
    return;
  AssertDimension(u.size(), n_dofs());
  using dealii::ArrayView;
  std::vector<double> to_send(exchange->n_import_indices());
  std::vector<MPI_Request> requests;
  const ArrayView<double> ghosts(u.data() + n_own_dofs(),
                                 u.size() - n_own_dofs());
  exchange->export_to_ghosted_array_start<double, dealii::MemorySpace::Host>(
      0, ArrayView<const double>(u.data(), n_own_dofs()),
      ArrayView<double>(to_send.data(), to_send.size()), ghosts, requests);
  exchange->export_to_ghosted_array_finish<double, dealii::MemorySpace::Host>(
      ghosts, requests);
}

unsigned int Structure::joint_of_row(const std::size_t k) const
{
  const std::vector<unsigned int> &first = own.joints.first_row;
  return std::upper_bound(first.begin(), first.end(), k) - first.begin() - 1;
}

dealii::Tensor<1, 3> Structure::normal(const unsigned int e) const
{
  dealii::Tensor<1, 3> normal;
  std::copy_n(direction(first_row(e)), n_translations(), normal.begin_raw());
  return normal;
}

ContactRow Structure::row(const std::size_t k) const
{
  const unsigned int T = n_translations(), R = own.kinematics.n_rotations();
  ContactRow row;
  std::copy_n(direction(k), T, row.direction.begin());
  std::copy_n(turn_minus(k), R, row.turn_minus.begin());
  std::copy_n(turn_plus(k), R, row.turn_plus.begin());
  return row;
}

std::vector<ContactRow> Structure::rows(const unsigned int e) const
{
  std::vector<ContactRow> rows;
  for (unsigned int r = 0; r < n_rows(e); ++r)
    rows.push_back(row(e, r));
  return rows;
}

std::vector<unsigned int> Structure::sets(const unsigned int e) const
{
  std::vector<unsigned int> sets;
  if (has_blocks())
    for_each_set(e, [&](const unsigned int size, unsigned int, unsigned int) {
      sets.push_back(size);
    });
  return sets;
}

void Structure::multiply_by_blocks(const std::vector<double> &coefficients,
                                   std::vector<double> &f) const
{
  if (!has_blocks())
  {
    for (std::size_t k = 0; k < f.size(); ++k)
      f[k] *= coefficients[k];
    return;
  }
  for_chunks(
      joints().size(), items_of_a_chunk,
      [&](std::size_t, const unsigned int begin, const unsigned int end) {
        std::vector<double> of_set;
        for (unsigned int e = begin; e < end; ++e)
          for_each_set(e, [&](const unsigned int size, const unsigned int row,
                              const unsigned int coefficient) {
            const double *block =
                &coefficients[first_coefficient(e) + coefficient];
            double *of_rows = &f[first_row(e) + row];
            of_set.assign(of_rows, of_rows + size);
            for (unsigned int i = 0; i < size; ++i)
            {
              of_rows[i] = 0.;
              for (unsigned int j = 0; j < size; ++j)
                of_rows[i] += block[i * size + j] * of_set[j];
            }
          });
      });
}

/** Call @p f with each row among all and its jump. */
template <typename F>
void Structure::for_each_jump(const double *u, const F &f) const
{
  own.kinematics.dispatch([&](const auto T, const auto R) {
    for_chunks(
        joints().size(), items_of_a_chunk,
        [&](std::size_t, const std::size_t begin, const std::size_t end) {
          for (std::size_t e = begin; e < end; ++e)
          {
            const double *plus =
                u + (T + R) * std::size_t(joints()[e].cell_plus);
            const double *minus =
                u + (T + R) * std::size_t(joints()[e].cell_minus);
            for (std::size_t k = first_row(e); k < first_row(e + 1); ++k)
              f(k, jump_in_row<T, R>(k, plus, minus));
          }
        });
  });
}

void Structure::find_all_jumps(const double *u, double *jumps) const
{
  for_each_jump(u, [&](const std::size_t k, const long double jump) {
    jumps[k] = static_cast<double>(jump);
  });
}

void Structure::add_exact_jumps(const std::vector<double> &u,
                                std::vector<double> &to) const
{
  for_each_jump(u.data(), [&](const std::size_t k, const long double jump) {
    to[k] = static_cast<double>(to[k] + jump);
  });
}

long double Structure::exact_jump(const std::size_t k, const double *u) const
{
  const Joint &joint = joints()[joint_of_row(k)];
  return own.kinematics.dispatch([&](const auto T, const auto R) {
    return jump_in_row<T, R>(k, u + dof(joint.cell_plus, 0),
                             u + dof(joint.cell_minus, 0));
  });
}

std::vector<double> Structure::jumps(const std::vector<double> &u) const
{
  std::vector<double> result(n_all_rows());
  find_all_jumps(u.data(), result.data());
  return result;
}

template <unsigned int T, unsigned int R>
void Structure::add_gradient(const unsigned int e,
                             const double factor,
                             const double *f,
                             double *gradient) const
{
  double *plus = gradient + (T + R) * std::size_t(joints()[e].cell_plus);
  double *minus = gradient + (T + R) * std::size_t(joints()[e].cell_minus);
  const std::size_t first = first_row(e), n = n_rows(e);
  for (unsigned int i = 0; i < T; ++i)
  {
    double component = 0.;
    for (std::size_t r = 0; r < n; ++r)
      component += factor * f[r] * own.joints.direction[T * (first + r) + i];
    plus[i] += component;
    minus[i] -= component;
  }
  for (std::size_t r = 0; r < n; ++r)
    for (unsigned int i = 0; i < R; ++i)
    {
      const std::size_t k = R * (first + r) + i;
      plus[T + i] += factor * f[r] * own.joints.turn_plus[k];
      minus[T + i] -= factor * f[r] * own.joints.turn_minus[k];
    }
}

void Structure::add_jump_gradient(const unsigned int e,
                                  const double *f,
                                  double *gradient) const
{
  own.kinematics.dispatch([&](const auto T, const auto R) {
    add_gradient<T, R>(e, 1., f, gradient);
  });
}

void Structure::add_all_jump_gradients(const double factor,
                                       const double *f,
                                       double *gradient) const
{
  own.kinematics.dispatch([&](const auto T, const auto R) {
    for (unsigned int e = 0; e < joints().size(); ++e)
      add_gradient<T, R>(e, factor, f + first_row(e), gradient);
  });
}

double Structure::work(const double *u) const
{
  long double work = 0.;
  for (unsigned int k = 0; k < own.loads.size(); ++k)
    work += own.loads[k] * u[k];
  return group.sum(work);
}

} // namespace Voussoir
