// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/stress/fan.h>
#include <voussoir/stress/least_norm.h>
#include <voussoir/stress/reconstruction.h>
#include <voussoir/stress/short_sides.h>

#include <deal.II/base/parallel.h>
#include <deal.II/base/thread_local_storage.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/** Set @p cell to cell @p c of a packing. */
void read(const Packing<2> &packing,
          const CellForces &of_all,
          const unsigned int c,
          LoadedCell &cell)
{
  const unsigned int first = packing.first_side(c);
  cell.centre = packing.centre(c);
  cell.vertices.clear();
  cell.forces.clear();
  cell.shifts.clear();
  cell.body_forces.assign(packing.n_sides(c), Tensor<1, 2>());
  for (unsigned int i = 0; i < packing.n_sides(c); ++i)
  {
    cell.vertices.push_back(packing.vertex(c, i));
    cell.forces.push_back(of_all.on_side[first + i]);
    if (!of_all.shift_on_side.empty())
      cell.shifts.push_back(of_all.shift_on_side[first + i]);
    if (!of_all.body.empty())
      cell.body_forces[i] = of_all.body[first + i];
  }
}

/** The cell of a thread, and the solvers that it keeps from cell to cell. */
class Solvers
{
public:
  explicit Solvers(const Reconstruction &how)
      : how(how), short_sides(how.cut(), how.shortest_side())
  {}

  /** Find the stress in the cell; see CellStress::solve(). */
  bool solve(const dealii::ArrayView<SubCellStress> &sub_cells)
  {
    if (!short_sides.leave_out(cell))
      return cell_stress(cell.vertices.size()).solve(cell, sub_cells);
    CellStress &of_rest = cell_stress(short_sides.rest().vertices.size());
    in_rest.resize(of_rest.n_sub_cells());
    if (!of_rest.solve(short_sides.rest(), {in_rest.data(), in_rest.size()}))
      return false;
    short_sides.fill(in_rest, sub_cells);
    return true;
  }

  LoadedCell cell;

private:
  CellStress &cell_stress(const unsigned int n_sides)
  {
    if (n_sides >= by_sides.size())
      by_sides.resize(n_sides + 1);
    std::unique_ptr<CellStress> &with_n_sides = by_sides[n_sides];
    if (!with_n_sides)
      with_n_sides = how.cell_stress(n_sides);
    return *with_n_sides;
  }

  const Reconstruction &how;
  std::vector<std::unique_ptr<CellStress>> by_sides;
  ShortSides short_sides;
  std::vector<SubCellStress> in_rest;
};

/** Cells per task: a millisecond of work, or more. */
constexpr unsigned int chunk_size = 256;
} // namespace

std::vector<std::string> undetermined_cells(const Scene &scene,
                                            const StressField &field)
{
  if (field.undetermined.empty())
    return {};
  const unsigned int c = field.undetermined.front();
  return {text("The stress inside ", counted(field.undetermined.size(), "cell"),
               " is not determined by the forces on their edges, and "
               "the mean stress is written instead. The first is cell ",
               c, " at ", text_of_point(scene.packing.centre(c)),
               "; summary.json lists all.")};
}

void StressParameters::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  add_choice<Accuracy>(
      prm, "Accuracy", accuracy,
      {{Accuracy::draft, "draft",
        "the forces and the mean stress of each cell; no stress.vtu."},
       {Accuracy::standard, "standard",
        "the stress inside each cell as in the paper, on one quadrilateral a "
        "side."},
       {Accuracy::fine, "fine",
        "the same on three quadrilaterals a side or more; see 'Stress'.",
        "Stress"}},
      "What is computed beyond the forces.");
  prm.enter_subsection("Stress");
  prm.add_parameter("Refinements", n_refinements,
                    "With 'Accuracy = fine': how many times each of the three "
                    "quadrilaterals a side is cut in four.",
                    Integer(0, 4));
  prm.add_parameter("Raviart-Thomas degree", degree,
                    "With 'Accuracy = fine': the degree of the elements.",
                    Integer(0, 1));
  prm.leave_subsection();
}

double Reconstruction::shortest_side() const
{
  return is_refined ? LeastNorm::shortest_side : Fan::shortest_side;
}

std::unique_ptr<CellStress>
Reconstruction::cell_stress(const unsigned int n_sides) const
{
  if (is_refined)
    return std::make_unique<LeastNorm>(n_sides, n_refinements, degree);
  return std::make_unique<Fan>(n_sides);
}

StressField reconstruct_stress(const Packing<2> &packing,
                               const CellForces &forces,
                               const Reconstruction &how,
                               Terminal &terminal)
{
  const unsigned int n_cells = packing.n_cells();
  StressField field;
  field.cut = how.cut();
  field.sub_cells.resize(field.first(packing, n_cells, 0));
  field.n_sub_cells = field.sub_cells.size();
  std::vector<char> determined(n_cells, true);

  const auto reconstruct_cell = [&](const unsigned int c, Solvers &solvers) {
    read(packing, forces, c, solvers.cell);
    const std::size_t first = field.first(packing, c, 0);
    const dealii::ArrayView<SubCellStress> sub_cells(
        field.sub_cells.data() + first, field.first(packing, c + 1, 0) - first);
    determined[c] = solvers.solve(sub_cells);
    if (!determined[c])
    {
      // The mean stress as in cell_mean_stresses().
      const Tensor<2, 2> mean = solvers.cell.moments() / packing.area(c);
      std::fill(
          sub_cells.begin(), sub_cells.end(),
          SubCellStress{mean, {}, 0.5 * std::abs(mean[0][1] - mean[1][0])});
    }
  };

  // In blocks, to say between them how far this has come.
  dealii::Threads::ThreadLocalStorage<std::unique_ptr<Solvers>> of_threads;
  const unsigned int block = std::max(1024U, n_cells / 100);
  for (unsigned int begin = 0; begin < n_cells; begin += block)
  {
    terminal.progress(begin, n_cells, "cells");
    const auto reconstruct_cells = [&](const unsigned int b,
                                       const unsigned int e) {
      std::unique_ptr<Solvers> &solvers = of_threads.get();
      if (!solvers)
        solvers = std::make_unique<Solvers>(how);
      for (unsigned int c = b; c < e; ++c)
        reconstruct_cell(c, *solvers);
    };
    dealii::parallel::apply_to_subranges(
        begin, std::min(n_cells, begin + block), reconstruct_cells, chunk_size);
  }

  for (unsigned int c = 0; c < n_cells; ++c)
    if (!determined[c])
      field.undetermined.push_back(c);
  return field;
}

StressField reconstruct_stress(const Scene &scene,
                               const InterfaceForces &forces,
                               const Reconstruction &how,
                               Terminal &terminal)
{
  return reconstruct_stress(
      scene.packing, cell_forces(scene, forces, all_cells(scene.packing)), how,
      terminal);
}
} // namespace Voussoir
