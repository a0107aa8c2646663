// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/vtu/stress_vtu.h>
#include <voussoir/output/vtu/vtu_file.h>
#include <voussoir/output/vtu/vtu_values.h>
#include <voussoir/stress/stress_invariants.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>

namespace Voussoir
{
using dealii::Point;
using VtuValues::scalar;
using VtuValues::tensor;
using VtuValues::vector;

namespace
{
/**
 * The points of a cell's sub-cells: the centre, and triangle by triangle those
 * that are its own: all but the centre and those on the spoke to its second
 * vertex, which belong to the next triangle.
 */
struct SubCellPoints
{
  explicit SubCellPoints(const SubTriangulation &cut)
  {
    const auto number = [this](const double a, const double b) {
      const auto found =
          std::find_if(own.begin(), own.end(),
                       [&](const auto &v) { return v.a == a && v.b == b; });
      const unsigned int n = found - own.begin();
      if (found == own.end())
        own.push_back({a, b});
      return n;
    };
    for (const SubTriangulation::Quadrilateral &sub_cell : cut.of_triangle())
    {
      std::array<Corner, 4> around;
      const std::array<unsigned int, 4> lexicographic = {{0, 1, 3, 2}};
      for (unsigned int v = 0; v < 4; ++v)
      {
        const auto [a, b] = sub_cell[lexicographic[v]];
        if (a == 0. && b == 0.)
          around[v] = {true, 0, 0};
        else if (a == 0.)
          around[v] = {false, 1, number(b, 0.)};
        else
          around[v] = {false, 0, number(a, b)};
      }
      corners.push_back(around);
    }
  }

  /** A corner of a sub-cell: point @p number of the triangle @p later. */
  struct Corner
  {
    bool is_centre;
    unsigned int later, number;
  };

  std::vector<SubTriangulation::Vertex> own;
  /** The corners of each sub-cell of a triangle, around it. */
  std::vector<std::array<Corner, 4>> corners;
};

/**
 * The grid of stress.vtu: the sub-cells as quadrilaterals, with their fields.
 * Sub-cells of one cell share their points, and those of different cells do
 * not: cells are bodies of their own, which may part.
 */
class StressGrid
{
public:
  explicit StressGrid(const StressedCells &shown);
  StressGrid(const StressGrid &) = delete; // file asks this object

  const VtuFile &as_file() const { return file; }

private:
  void add_fields();
  void
  fill_corners(std::size_t begin, std::size_t end, std::int64_t *place) const;

  std::size_t first_point(const unsigned int cell) const
  {
    return cell + points.own.size() * packing.first_side(cell);
  }

  std::size_t first_sub_cell(const unsigned int cell) const
  {
    return points.corners.size() * packing.first_side(cell);
  }

  auto points_of_cells() const
  {
    return VtuValues::ItemsByCell{
        packing.n_cells(),
        [this](const unsigned int c) { return first_point(c); }};
  }
  auto sub_cells_of_cells() const
  {
    return VtuValues::ItemsByCell{
        packing.n_cells(),
        [this](const unsigned int c) { return first_sub_cell(c); }};
  }

  /**
   * Add a field from @p values(cell, k), the array of its components in
   * sub-cell k, which are counted through all cells of the packing.
   */
  template <typename Values>
  void add(const std::string &name, const Values &values)
  {
    using Components = decltype(values(0, std::size_t()));
    using Number = typename Components::value_type;
    file.add_cell_field<Number>(
        name, std::tuple_size<Components>::value,
        [this, values](auto begin, auto end, Number *place) {
          sub_cells_of_cells().fill(begin, end, place,
                                    [&](unsigned int c, std::size_t k) {
                                      return values(c, first_sub_cell(c) + k);
                                    });
        });
  }

  /** Point @p k of a cell: the centre, and then its own of each triangle. */
  Point<2> point(const unsigned int cell, const unsigned int k) const
  {
    const Point<2> &centre = packing.centre(cell);
    if (k == 0)
      return centre;
    const unsigned int side = (k - 1) / points.own.size();
    const auto [a, b] = points.own[(k - 1) % points.own.size()];
    // In this form vertices, and the middles of sides, are the same to the last
    // bit from both cells.
    return (1. - a - b) * centre + a * packing.vertex(cell, side) +
           b * packing.vertex(cell, side + 1);
  }

  /** The number of a cell in the whole packing. */
  unsigned int number_of(unsigned int cell) const
  {
    return shown.numbers != nullptr ? (*shown.numbers)[cell]
                                    : shown.first_cell + cell;
  }

  const StressedCells shown;
  const Packing<2> &packing;
  const SubCellPoints points;
  VtuFile file;
};

StressGrid::StressGrid(const StressedCells &shown)
    : shown(shown), packing(shown.packing), points(shown.stress.cut),
      file(VtuFile::quadrilaterals(
          {first_point(packing.n_cells()),
           [this](auto begin, auto end, double *place) {
             points_of_cells().fill(begin, end, place,
                                    [this](auto... cell_and_k) {
                                      return vector(point(cell_and_k...));
                                    });
           }},
          {first_sub_cell(packing.n_cells()),
           [this](auto... arguments) { fill_corners(arguments...); }}))
{
  add_fields();
}

void StressGrid::add_fields()
{
  using Cell = unsigned int;
  const auto &sub_cells = shown.stress.sub_cells;
  const auto invariants = [&sub_cells](const std::size_t k) {
    return StressInvariants(sub_cells[k].stress);
  };
  add("stress", [&](Cell, auto k) { return tensor(sub_cells[k].stress); });
  add("principal_stress_1",
      [=](Cell, auto k) { return scalar(invariants(k).principal_1); });
  add("principal_stress_2",
      [=](Cell, auto k) { return scalar(invariants(k).principal_2); });
  add("von_mises",
      [=](Cell, auto k) { return scalar(invariants(k).von_mises); });
  add("skew", [&](Cell, auto k) { return scalar(sub_cells[k].skew); });
  add("div", [&](Cell, auto k) { return vector(sub_cells[k].divergence); });
  add("cell",
      [this](Cell c, auto) { return scalar(std::int32_t(number_of(c))); });
  add("group",
      [this](Cell c, auto) { return scalar(std::int32_t(packing.group(c))); });
  add("reconstructed", [this](Cell c, auto) {
    const auto &undetermined = shown.stress.undetermined;
    return scalar(std::uint8_t(!std::binary_search(
        undetermined.begin(), undetermined.end(), number_of(c))));
  });
  file.add_point_vector("displacement", [this](auto begin, auto end,
                                               double *place) {
    points_of_cells().fill(
        begin, end, place, [this](const Cell c, const unsigned int k) {
          return vector(shown.motion.at(c, point(c, k) - packing.centre(c)));
        });
  });
}

void StressGrid::fill_corners(const std::size_t begin,
                              const std::size_t end,
                              std::int64_t *place) const
{
  sub_cells_of_cells().fill(
      begin, end, place, [&](unsigned int c, std::size_t k) {
        const unsigned int side = k / points.corners.size();
        std::array<std::int64_t, 4> numbers;
        unsigned int v = 0;
        for (const auto &corner : points.corners[k % points.corners.size()])
          numbers[v++] = first_point(c) +
                         (corner.is_centre
                              ? 0
                              : 1 + corner.number +
                                    points.own.size() * ((side + corner.later) %
                                                         packing.n_sides(c)));
        return numbers;
      });
}
} // namespace

void write_stress_vtu(std::ostream &out, const StressedCells &cells)
{
  StressGrid(cells).as_file().write(out);
}

void write_stress_pvtu(std::ostream &out,
                       const StressedCells &cells,
                       const std::vector<std::string> &pieces)
{
  StressGrid(cells).as_file().write_record(out, pieces);
}
} // namespace Voussoir
