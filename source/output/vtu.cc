// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/vtu.h>
#include <voussoir/output/vtu_file.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <tuple>
#include <utility>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
template <typename Number>
std::array<Number, 1> scalar(const Number value)
{
  return {{value}};
}

std::array<double, 3> vector(const Tensor<1, 2> &v)
{
  return {{v[0], v[1], 0.}};
}

std::array<double, 9> tensor(const Tensor<2, 2> &t)
{
  return {{t[0][0], t[0][1], 0., t[1][0], t[1][1], 0., 0., 0., 0.}};
}

/** The larger and the smaller principal stress, of the symmetric part. */
std::pair<double, double> principal_stresses(const Tensor<2, 2> &s)
{
  const double mean = 0.5 * (s[0][0] + s[1][1]); // by Mohr's circle
  const double radius =
      std::hypot(0.5 * (s[0][0] - s[1][1]), 0.5 * (s[0][1] + s[1][0]));
  return {mean + radius, mean - radius};
}

/**
 * The points of a cell's sub-cells: the centre, and triangle by triangle those
 * that are its own: all but the centre and those on the spoke to its second
 * vertex, which belong to the next triangle.
 */
struct SubCellPoints
{
  explicit SubCellPoints(const SubTriangulation &cut);

  /** A corner of a sub-cell: point @p number of the triangle @p later. */
  struct Corner
  {
    bool is_centre;
    unsigned int later, number;
  };

  std::vector<SubTriangulation::Vertex> own;
  /** Around each sub-cell of a triangle. */
  std::vector<std::array<Corner, 4>> corners;
};

SubCellPoints::SubCellPoints(const SubTriangulation &cut)
{
  const auto number = [this](const double a, const double b) {
    const auto found = std::find_if(own.begin(), own.end(), [&](const auto &v) {
      return v.a == a && v.b == b;
    });
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

/**
 * The sub-cells of a packing as a grid of quadrilaterals. Those of one
 * cell share their points, and those of different cells do not: cells are
 * bodies of their own, which may part.
 */
class SubCellGrid
{
public:
  using Shift = std::function<Tensor<1, 2>(unsigned int cell)>;

  /** @param shift how far each cell is moved; nullptr: not at all. */
  SubCellGrid(const Packing &packing,
              const SubTriangulation &cut,
              const Shift &shift = nullptr);
  SubCellGrid(const SubCellGrid &) = delete; // file asks this object

  void write(std::ostream &out) const
  {
    file.write(out);
  }

  void write_record(std::ostream &out,
                    const std::vector<std::string> &pieces) const
  {
    file.write_record(out, pieces);
  }

  /**
   * Add a field from @p values(cell, k), the array of its components in
   * sub-cell k, which are counted through all cells of the packing.
   */
  template <typename Values>
  void add(const std::string &name, const Values &values);

private:
  std::size_t first_point(unsigned int cell) const;
  std::size_t first_sub_cell(unsigned int cell) const;
  template <typename First>
  unsigned int cell_of(std::size_t i, const First &first) const;
  void fill_points(std::size_t begin, std::size_t end, double *place) const;
  void
  fill_corners(std::size_t begin, std::size_t end, std::int64_t *place) const;

  const Packing &packing;
  const Shift shift;
  const SubCellPoints points;
  VtuFile file;
};

SubCellGrid::SubCellGrid(const Packing &packing,
                         const SubTriangulation &cut,
                         const Shift &shift)
    : packing(packing), shift(shift), points(cut),
      file(
          VtuFile::Shape::quadrilateral,
          first_point(packing.n_cells()),
          [this](auto... arguments) { fill_points(arguments...); },
          first_sub_cell(packing.n_cells()),
          [this](auto... arguments) { fill_corners(arguments...); })
{
}

std::size_t SubCellGrid::first_point(const unsigned int cell) const
{
  return cell + points.own.size() * packing.first_side(cell);
}

std::size_t SubCellGrid::first_sub_cell(const unsigned int cell) const
{
  return points.corners.size() * packing.first_side(cell);
}

/** The cell of the item @p i, the first item of each cell being given. */
template <typename First>
unsigned int SubCellGrid::cell_of(const std::size_t i, const First &first) const
{
  unsigned int begin = 0, end = packing.n_cells();
  while (begin + 1 < end)
  {
    const unsigned int middle = begin + (end - begin) / 2;
    (first(middle) <= i ? begin : end) = middle;
  }
  return begin;
}

void SubCellGrid::fill_points(const std::size_t begin,
                              const std::size_t end,
                              double *place) const
{
  const auto first = [this](const unsigned int c) {
    return first_point(c);
  };
  unsigned int c = cell_of(begin, first);
  for (std::size_t p = begin; p < end; ++p)
  {
    c += (p == first(c + 1));
    const Point<2> &centre = packing.centre(c);
    Point<2> x = centre;
    if (p > first(c))
    {
      const unsigned int k = p - first(c) - 1;
      const unsigned int side = k / points.own.size();
      const auto [a, b] = points.own[k % points.own.size()];
      // In this form vertices, and the middles of sides, are the same to the
      // last bit from both cells.
      x = (1. - a - b) * centre + a * packing.vertex(c, side) +
          b * packing.vertex(c, side + 1);
    }
    const auto components = vector(shift ? x + shift(c) : x);
    place = std::copy(components.begin(), components.end(), place);
  }
}

void SubCellGrid::fill_corners(const std::size_t begin,
                               const std::size_t end,
                               std::int64_t *place) const
{
  const auto first = [this](const unsigned int c) {
    return first_sub_cell(c);
  };
  unsigned int c = cell_of(begin, first);
  for (std::size_t k = begin; k < end; ++k)
  {
    c += (k == first(c + 1));
    const unsigned int side = (k - first(c)) / points.corners.size();
    for (const auto &corner : points.corners[k % points.corners.size()])
      *place++ = first_point(c) +
                 (corner.is_centre
                      ? 0
                      : 1 + corner.number +
                            points.own.size() *
                                ((side + corner.later) % packing.n_sides(c)));
  }
}

template <typename Values>
void SubCellGrid::add(const std::string &name, const Values &values)
{
  using Components = decltype(values(0, std::size_t()));
  using Number = typename Components::value_type;
  file.add_field<Number>(
      name, std::tuple_size<Components>::value,
      [=](std::size_t k, const std::size_t end, Number *place) {
        const auto first = [this](unsigned int c) {
          return first_sub_cell(c);
        };
        unsigned int c = cell_of(k, first);
        for (; k < end; ++k)
        {
          c += (k == first(c + 1));
          const Components components = values(c, k);
          place = std::copy(components.begin(), components.end(), place);
        }
      });
}

/** The grid of stress.vtu with its fields. */
class StressGrid : public SubCellGrid
{
public:
  explicit StressGrid(const StressedCells &cells);
};

StressGrid::StressGrid(const StressedCells &cells)
    : SubCellGrid(cells.packing, cells.stress.cut)
{
  using Cell = unsigned int;
  const auto &sub_cells = cells.stress.sub_cells;
  const auto &undetermined = cells.stress.undetermined;
  const Packing &packing = cells.packing;
  const auto &u = cells.displacement;
  const unsigned int first = cells.first_cell;
  add("stress", [&](Cell, auto k) { return tensor(sub_cells[k].stress); });
  add("principal_stress_1", [&](Cell, auto k) {
    return scalar(principal_stresses(sub_cells[k].stress).first);
  });
  add("principal_stress_2", [&](Cell, auto k) {
    return scalar(principal_stresses(sub_cells[k].stress).second);
  });
  add("von_mises", [&](Cell, auto k) {
    const auto [s1, s2] = principal_stresses(sub_cells[k].stress);
    return scalar(std::sqrt(s1 * s1 - s1 * s2 + s2 * s2));
  });
  add("skew", [&](Cell, auto k) { return scalar(sub_cells[k].skew); });
  add("div", [&](Cell, auto k) { return vector(sub_cells[k].divergence); });
  add("cell", [=](Cell c, auto) { return scalar(std::int32_t(first + c)); });
  add("group",
      [&](Cell c, auto) { return scalar(std::int32_t(packing.group(c))); });
  add("displacement", [&](Cell c, auto) { return vector(u[c]); });
  add("reconstructed", [&, first](Cell c, auto) {
    return scalar(std::uint8_t(!std::binary_search(
        undetermined.begin(), undetermined.end(), first + c)));
  });
}
} // namespace

void write_stress_vtu(std::ostream &out, const StressedCells &cells)
{
  StressGrid(cells).write(out);
}

void write_stress_pvtu(std::ostream &out,
                       const StressedCells &cells,
                       const std::vector<std::string> &pieces)
{
  StressGrid(cells).write_record(out, pieces);
}

void write_interfaces_vtu(std::ostream &out, const Results &results)
{
  const Scene &scene = results.scene;
  const InterfaceForces &forces = results.forces;
  const auto &interfaces = scene.packing.interfaces();
  const auto fill_points = [&](std::size_t p, std::size_t end, double *place) {
    for (; p < end; ++p)
    {
      const Packing::Interface &i = interfaces[p / 2];
      const auto x = vector(p % 2 == 0 ? i.start : i.end);
      place = std::copy(x.begin(), x.end(), place);
    }
  };
  const auto fill_ends = [](std::size_t e, std::size_t end, auto *place) {
    std::iota(place, place + 2 * (end - e), 2 * e);
  };
  VtuFile file(VtuFile::Shape::line, 2 * interfaces.size(), fill_points,
               interfaces.size(), fill_ends);
  const auto add = [&](const std::string &name, const auto &value) {
    using Number = decltype(value(0));
    file.add_field<Number>(name, 1,
                           [value](std::size_t e, std::size_t end, Number *to) {
                             for (; e < end; ++e)
                               *to++ = value(e);
                           });
  };
  add("normal_force", [&](std::size_t e) { return forces.normal[e]; });
  add("tangential_force", [&](std::size_t e) { return forces.tangential[e]; });
  add("normal_stress",
      [&](std::size_t e) { return forces.normal[e] / interfaces[e].length; });
  add("tangential_stress", [&](std::size_t e) {
    return forces.tangential[e] / interfaces[e].length;
  });
  add("strength", [&](std::size_t e) { return scene.strength[e]; });
  add("utilisation",
      [&](std::size_t e) { return utilisation(scene, forces, e); });
  add("cell_minus",
      [&](std::size_t e) { return std::int32_t(interfaces[e].cell_minus); });
  add("cell_plus", [&](std::size_t e) {
    const unsigned int plus = interfaces[e].cell_plus;
    return plus == scene.packing.ground() ? -1 : std::int32_t(plus);
  });
  if (!results.never_pressed.empty())
  {
    add("never_pressed",
        [&](std::size_t e) { return std::uint8_t(results.never_pressed[e]); });
    add("always_sliding",
        [&](std::size_t e) { return std::uint8_t(results.always_sliding[e]); });
  }
  file.write(out);
}

void write_mechanism_vtu(std::ostream &out, const Collapse &collapse)
{
  const Packing &packing = collapse.scene.packing;
  const double largest = std::sqrt(packing.area() / packing.n_cells());
  const auto movement = [&](const unsigned int c) {
    return largest * collapse.displacement[c];
  };
  SubCellGrid grid(packing, SubTriangulation::fan(), movement);
  grid.add("displacement",
           [&](unsigned int c, auto) { return vector(movement(c)); });
  grid.add("cell",
           [](unsigned int c, auto) { return scalar(std::int32_t(c)); });
  grid.write(out);
}
} // namespace Voussoir
