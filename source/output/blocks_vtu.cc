// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/blocks_vtu.h>
#include <voussoir/output/vtu_file.h>
#include <voussoir/output/vtu_values.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <tuple>

namespace Voussoir
{
using VtuValues::scalar;
using VtuValues::StressInvariants;
using VtuValues::tensor;
using VtuValues::vector;

namespace
{
/** A grid of one polygon for each cell, with what is known of any cell. */
class BlockGrid
{
public:
  explicit BlockGrid(const Packing &packing);
  BlockGrid(const BlockGrid &) = delete; // file asks this object

  /** Add a field of @p value(cell), the array of its components. */
  template <typename Value>
  void add(const std::string &name, const Value &value);

  /** Add the displacement, which is @p value(cell) at all points of a cell. */
  template <typename Value>
  void add_displacement(const Value &value);

  void write(std::ostream &out) const
  {
    file.write(out);
  }

private:
  /** Fill points with @p value(cell, k), k counting the points of the cell. */
  template <typename Value>
  void fill_points(std::size_t begin,
                   std::size_t end,
                   double *place,
                   const Value &value) const;

  const Packing &packing;
  VtuFile file;
};

BlockGrid::BlockGrid(const Packing &cells)
    : packing(cells),
      file(VtuFile::separate(
          VtuFile::Shape::polygon,
          {packing.first_side(packing.n_cells()),
           [this](auto begin, auto end, double *place) {
             fill_points(begin, end, place, [this](auto... cell_and_k) {
               return packing.vertex(cell_and_k...);
             });
           }},
          {packing.n_cells(),
           [this](auto begin, auto end, std::int64_t *place) {
             for (; begin < end; ++begin)
               *place++ = packing.first_side(begin + 1);
           }}))
{
  add("cell", [](unsigned int c) { return scalar(std::int32_t(c)); });
  add("group", [this](unsigned int c) {
    return scalar(std::int32_t(packing.group(c)));
  });
}

template <typename Value>
void BlockGrid::add(const std::string &name, const Value &value)
{
  using Components = decltype(value(0));
  using Number = typename Components::value_type;
  file.add_cell_field<Number>(
      name, std::tuple_size<Components>::value,
      [value](std::size_t c, const std::size_t end, Number *place) {
        for (; c < end; ++c)
        {
          const Components components = value(c);
          place = std::copy(components.begin(), components.end(), place);
        }
      });
}

template <typename Value>
void BlockGrid::add_displacement(const Value &value)
{
  file.add_point_vector(
      "displacement", [this, value](auto begin, auto end, double *place) {
        fill_points(begin, end, place,
                    [&](unsigned int c, unsigned int) { return value(c); });
      });
}

template <typename Value>
void BlockGrid::fill_points(const std::size_t begin,
                            const std::size_t end,
                            double *place,
                            const Value &value) const
{
  const auto first = [this](const unsigned int c) {
    return packing.first_side(c);
  };
  unsigned int c = VtuValues::cell_of(begin, packing.n_cells(), first);
  for (std::size_t p = begin; p < end; ++p)
  {
    c += (p == first(c + 1));
    const auto components = vector(value(c, p - first(c)));
    place = std::copy(components.begin(), components.end(), place);
  }
}
} // namespace

void write_blocks_vtu(std::ostream &out, const Results &results)
{
  using Cell = unsigned int;
  BlockGrid grid(results.scene.packing);
  const auto &stress = results.mean_stresses;
  const auto invariants = [&](Cell c) {
    return StressInvariants(stress[c]);
  };
  grid.add("load", [&](Cell c) { return vector(results.scene.load[c]); });
  grid.add("stress", [&](Cell c) { return tensor(stress[c]); });
  grid.add("principal_stress_1",
           [&](Cell c) { return scalar(invariants(c).principal_1); });
  grid.add("principal_stress_2",
           [&](Cell c) { return scalar(invariants(c).principal_2); });
  grid.add("von_mises",
           [&](Cell c) { return scalar(invariants(c).von_mises); });
  grid.add("torque", [&](Cell c) { return scalar(results.torques[c]); });
  grid.add_displacement([&](Cell c) { return results.displacement[c]; });
  grid.write(out);
}

void write_mechanism_vtu(std::ostream &out, const Collapse &collapse)
{
  const Packing &packing = collapse.scene.packing;
  const double largest = std::sqrt(packing.area() / packing.n_cells());
  BlockGrid grid(packing);
  grid.add_displacement(
      [&](unsigned int c) { return largest * collapse.displacement[c]; });
  grid.write(out);
}
} // namespace Voussoir
