// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/stress/cell_means.h>
#include <voussoir/stress/reconstruction.h>

#include <deal.II/base/work_stream.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <atomic>
#include <map>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/** What one thread keeps from cell to cell: a fan for each number of sides. */
struct Scratch
{
  Scratch() = default;
  // WorkStream copies a sample for each thread; a fan cannot be copied, and
  // each thread makes its own.
  Scratch(const Scratch &) : Scratch()
  {
  }

  Fan &fan(const unsigned int n_sides)
  {
    std::unique_ptr<Fan> &fan = fans[n_sides];
    if (!fan)
      fan = std::make_unique<Fan>(n_sides);
    return *fan;
  }

  std::map<unsigned int, std::unique_ptr<Fan>> fans;
  std::vector<Point<2>> vertices;
  std::vector<Tensor<1, 2>> forces, body_forces;
};

/** Each cell writes to a place of its own: there is nothing to copy. */
struct NoCopyData
{
};

/** Cells per task: a few milliseconds of work. */
constexpr unsigned int chunk_size = 64;
} // namespace

std::vector<std::string> undetermined_cells(const Scene &scene,
                                            const StressField &field)
{
  if (field.undetermined.empty())
    return {};
  const unsigned int c = field.undetermined.front();
  return {text("The stress inside ", field.undetermined.size(),
               " cells is not determined by the forces on their edges, and "
               "their mean stress is written instead. The first is cell ",
               c, " at ", text_of_point(scene.packing.centre(c)),
               "; summary.json lists all.")};
}

void StressParameters::add_parameters(dealii::ParameterHandler &prm)
{
  prm.enter_subsection("Stress");
  prm.add_parameter("Reconstruct", asked_for,
                    "Whether to reconstruct the stress inside the cells and "
                    "write stress.vtu. The mean stress of each cell is "
                    "written to cells.csv in any case.");
  prm.leave_subsection();
}

bool StressParameters::reconstruct() const
{
  return asked_for;
}

StressField reconstruct_stress(const Scene &scene,
                               const InterfaceForces &forces,
                               Terminal &terminal)
{
  const Packing &packing = scene.packing;
  const unsigned int n_cells = packing.n_cells();
  StressField field;
  field.sub_cells.resize(packing.first_side(n_cells));
  std::vector<char> determined(n_cells, true);

  const auto reconstruct_cell = [&](const unsigned int c, Scratch &scratch) {
    const auto sides = packing.sides(c);
    scratch.vertices.clear();
    scratch.forces.clear();
    scratch.body_forces.clear();
    for (unsigned int i = 0; i < sides.size(); ++i)
    {
      scratch.vertices.push_back(packing.vertex(c, i));
      scratch.body_forces.push_back(scene.body.force(packing, c, i));
      const unsigned int k = sides[i].index;
      if (sides[i].on_boundary)
        scratch.forces.push_back(packing.boundary_edges()[k].length *
                                 scene.traction[k]);
      else
      {
        const Packing::Interface &interface = packing.interfaces()[k];
        const Tensor<1, 2> f = forces.on_cell_minus(interface, k);
        scratch.forces.push_back(interface.cell_minus == c ? f : -f);
      }
    }
    const dealii::ArrayView<Fan::SubCell> sub_cells(
        field.sub_cells.data() + packing.first_side(c), sides.size());
    determined[c] = scratch.fan(sides.size())
                        .solve(packing.centre(c), scratch.vertices,
                               scratch.forces, scratch.body_forces, sub_cells);
  };

  // In blocks, for a progress line between them.
  const unsigned int block = std::max(1024U, n_cells / 20);
  for (unsigned int begin = 0; begin < n_cells; begin += block)
  {
    terminal.progress("Stress", text("cell ", begin, " of ", n_cells));
    using Iterator = boost::counting_iterator<unsigned int>;
    dealii::WorkStream::run(
        Iterator(begin), Iterator(std::min(n_cells, begin + block)),
        [&](const Iterator &c, Scratch &scratch, NoCopyData &) {
          reconstruct_cell(*c, scratch);
        },
        std::function<void(const NoCopyData &)>(), Scratch(), NoCopyData(),
        2 * dealii::MultithreadInfo::n_threads(), chunk_size);
  }

  for (unsigned int c = 0; c < n_cells; ++c)
    if (!determined[c])
      field.undetermined.push_back(c);
  if (!field.undetermined.empty())
  {
    const auto means = cell_mean_stresses(scene, forces);
    for (const unsigned int c : field.undetermined)
      for (unsigned int i = 0; i < packing.n_sides(c); ++i)
        field.sub_cells[packing.first_side(c) + i] = {means[c], {}};
  }
  return field;
}
} // namespace Voussoir
