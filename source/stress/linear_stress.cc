// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/stress/linear_stress.h>
#include <voussoir/stress/loaded_faces.h>

#include <deal.II/base/parallel.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/** The gradients of six components; the divergences. */
constexpr unsigned int n_gradients = 18, n_divergences = 3;
/** Each entry pq of a symmetric tensor, and the component m that it is. */
constexpr struct
{
  unsigned int m, p, q;
} all_entries[] = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 1, 2}, {3, 2, 1},
                   {4, 2, 0}, {4, 0, 2}, {5, 0, 1}, {5, 1, 0}};
/** What lets the smallest of several solutions be taken, over the largest. */
constexpr double shift_of_gradients = 1e-13;
/** The cells that a task has at least. */
constexpr unsigned int least_cells_of_task = 64;

/** The fit of one cell after the other. */
class LinearFit
{
public:
  LinearFit()
      : matrix(n_gradients + n_divergences, n_gradients + n_divergences),
        right(n_gradients + n_divergences),
        solution(n_gradients + n_divergences)
  {}

  /** Fill in the gradient and the residual. */
  void find(const std::vector<LoadedFace> &faces,
            double size,
            double volume,
            LinearStress &stress);

private:
  void add_equation(const double *coefficients, double value, double weight);
  void add_face(const LoadedFace &face, const LinearStress &stress);

  dealii::FullMatrix<double> matrix;
  dealii::Vector<double> right, solution;
  /** The unit of length. */
  double length = 1.;
};

/** Add the normal equations of one equation. */
void LinearFit::add_equation(const double *coefficients,
                             const double value,
                             const double weight)
{
  for (unsigned int a = 0; a < n_gradients; ++a)
  {
    if (coefficients[a] == 0.)
      continue;
    right[a] += weight * coefficients[a] * value;
    for (unsigned int b = 0; b < n_gradients; ++b)
      matrix(a, b) += weight * coefficients[a] * coefficients[b];
  }
}

/** The force and the moment through a face, in units of length one. */
void LinearFit::add_face(const LoadedFace &face, const LinearStress &stress)
{
  const double area = face.area / (length * length);
  const Tensor<1, 3> arm = (face.centroid - stress.about) / length;
  const Tensor<2, 3> second = face.second / std::pow(length, 4);
  const Tensor<1, 3> force =
      (face.force - face.area * (stress.mean * face.normal)) /
      (length * length);
  const Tensor<1, 3> moment = face.moment / std::pow(length, 3);
  const double polar = trace(second) / area;
  for (unsigned int i = 0; i < 3; ++i)
  {
    // Rows i of the force and of the moment, for each gradient.
    double of_force[n_gradients] = {}, of_moment[n_gradients] = {};
    for (const auto &[m, p, q] : all_entries)
      // d sigma_pq / dx_k times n_q, in direction p.
      for (unsigned int k = 0; k < 3; ++k)
      {
        const unsigned int g = 3 * m + k;
        if (p == i)
          of_force[g] += area * arm[k] * face.normal[q];
        // e_i . ((x - x_f) x e_p) = eps_iap (x - x_f)_a
        const unsigned int a = 3 - i - p;
        if (p != i)
          of_moment[g] +=
              ((i + 1) % 3 == a ? 1. : -1.) * second[a][k] * face.normal[q];
      }
    add_equation(of_force, force[i], 1. / area);
    add_equation(of_moment, moment[i], 1. / (area * polar));
  }
}

void LinearFit::find(const std::vector<LoadedFace> &faces,
                     const double size,
                     const double volume,
                     LinearStress &stress)
{
  length = size;
  matrix = 0.;
  right = 0.;
  Tensor<1, 3> sum;
  double of_forces = 0.;
  for (const LoadedFace &face : faces)
  {
    add_face(face, stress);
    sum += face.force;
    of_forces += face.force.norm_square() / face.area;
  }
  double largest = 0.;
  for (unsigned int a = 0; a < n_gradients; ++a)
    largest = std::max(largest, matrix(a, a));
  for (unsigned int a = 0; a < n_gradients; ++a)
    matrix(a, a) += shift_of_gradients * largest;
  for (const auto &[m, p, q] : all_entries)
    matrix(n_gradients + p, 3 * m + q) = matrix(3 * m + q, n_gradients + p) =
        1.;
  for (unsigned int p = 0; p < 3; ++p)
    right[n_gradients + p] = sum[p] / volume * length;
  matrix.gauss_jordan();
  matrix.vmult(solution, right);
  if (!std::all_of(solution.begin(), solution.end(),
                   [](const double value) { return std::isfinite(value); }))
    solution = 0.; // the mean alone
  for (const auto &[m, p, q] : all_entries)
    for (unsigned int k = 0; k < 3; ++k)
      stress.gradient[k][p][q] = solution[3 * m + k] / length;
  double of_rest = 0.;
  for (const LoadedFace &face : faces)
    of_rest +=
        (face.force - face.area * (stress.at(face.centroid) * face.normal))
            .norm_square() /
        face.area;
  stress.residual = of_forces > 0. ? std::sqrt(of_rest / of_forces) : 0.;
}
} // namespace

std::vector<Tensor<2, 3>> cell_mean_stresses(const SpaceScene &scene,
                                             const FaceForces &forces)
{
  const Packing<3> &packing = scene.packing();
  std::vector<Tensor<2, 3>> mean = scene.loads.first_moment;
  for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
  {
    const Packing<3>::Interface &i = packing.interfaces()[e];
    for (unsigned int k = forces.first[e]; k < forces.first[e + 1]; ++k)
    {
      const PointForce &of = forces.list[k];
      mean[i.cell_minus] +=
          outer_product(of.force, of.place - packing.centre(i.cell_minus));
      if (i.cell_plus != packing.ground())
        mean[i.cell_plus] -=
            outer_product(of.force, of.place - packing.centre(i.cell_plus));
    }
  }
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    mean[c] /= packing.volume(c);
  return mean;
}

std::vector<LinearStress>
linear_stresses(const SpaceScene &scene,
                const FaceForces &forces,
                const std::vector<Tensor<2, 3>> &means)
{
  const Packing<3> &packing = scene.packing();
  const std::vector<std::vector<LoadedFace>> faces =
      loaded_faces(scene, forces);
  std::vector<LinearStress> stresses(packing.n_cells());
  dealii::parallel::apply_to_subranges(
      0U, packing.n_cells(),
      [&](const unsigned int begin, const unsigned int end) {
        LinearFit fit;
        for (unsigned int c = begin; c < end; ++c)
        {
          stresses[c].about = packing.moments(c).centroid;
          stresses[c].mean = 0.5 * (means[c] + transpose(means[c]));
          fit.find(faces[c], std::cbrt(packing.volume(c)), packing.volume(c),
                   stresses[c]);
        }
      },
      least_cells_of_task);
  return stresses;
}
} // namespace Voussoir
