// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_vtu_vtu_file_h
#define voussoir_output_vtu_vtu_file_h

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <type_traits>
#include <vector>

namespace Voussoir
{
/**
 * Writes an unstructured grid as VTK's XML, with values that are constant in
 * each cell and values at the points: a .vtu file, or a .pvtu file that lists
 * several of these as the pieces of one grid.
 *
 * Numbers are binary, appended to the XML in blocks that zlib compresses, or
 * LZ4 from a million cells on. No array is ever kept: a block is asked for when
 * its turn comes, by all threads at a time, so that a grid costs hardly more
 * memory than its description.
 */
class VtuFile
{
public:
  /** VTK's number for the shape of the cells. */
  enum class Shape : std::uint8_t
  {
    vertex = 1,        /**< a point */
    line = 3,          /**< two points */
    polyline = 4,      /**< any number of points, in a row */
    polygon = 7,       /**< any number of points, around it */
    quadrilateral = 9, /**< four points, around it */
    tetrahedron = 10,  /**< four points, the last above the others */
    polyhedron = 42    /**< any number of points, with faces */
  };

  /**
   * Puts the values of the items from @p begin to @p end - 1, all components
   * of one and then of the next, where the pointer says. Called by several
   * threads at a time.
   */
  template <typename Number>
  using Fill =
      std::function<void(std::size_t begin, std::size_t end, Number *values)>;

  /** Points, or cells: how many, and what there is of each. */
  template <typename Number>
  struct Items
  {
    std::size_t number; /**< of the points or cells */
    Fill<Number> fill;  /**< three coordinates (L), or what the grid asks for */
  };

  /**
   * A grid of quadrilaterals on @p points that they may share.
   *
   * @param corners of each the numbers of the four points around it.
   */
  static VtuFile quadrilaterals(const Items<double> &points,
                                const Items<std::int64_t> &corners);

  /**
   * A grid of cells of the same @p shape that share no points: those of the
   * first come first.
   *
   * @param ends of each cell how many points it and those before it have.
   */
  static VtuFile separate(Shape shape,
                          const Items<double> &points,
                          const Items<std::int64_t> &ends);

  /** Let the cells have shapes of their own: VTK's numbers for these. */
  void set_shapes(const Fill<std::uint8_t> &shapes)
  {
    cells[2] = make_array("types", 1, number_of_cells(), shapes);
  }

  /**
   * A grid of polyhedra that share no points, as separate().
   *
   * @param faces of each cell a sequence of numbers: that of its faces, and for
   *   each face that of its points and these.
   * @param face_ends of each cell how many numbers it and those before it have.
   */
  static VtuFile polyhedra(const Items<double> &points,
                           const Items<std::int64_t> &ends,
                           const Items<std::int64_t> &faces,
                           const Items<std::int64_t> &face_ends);

  /**
   * Give every cell @p n_components values: three make a vector and nine a
   * tensor, row by row. Number is double, int32_t or uint8_t.
   */
  template <typename Number>
  void add_cell_field(const std::string &name,
                      const unsigned int n_components,
                      const Fill<Number> &values)
  {
    const std::size_t n_cells = number_of_cells();
    cell_fields.push_back(make_array(name, n_components, n_cells, values));
  }

  /** Give every point three values, a vector. */
  void add_point_vector(const std::string &name, const Fill<double> &values)
  {
    point_fields.push_back(make_array(name, 3, points.n_items, values));
  }

  /** Give every point nine values, a tensor row by row. */
  void add_point_tensor(const std::string &name, const Fill<double> &values)
  {
    point_fields.push_back(make_array(name, 9, points.n_items, values));
  }

  /** Write the .vtu; @p out must be able to go back. */
  void write(std::ostream &out) const;

  /** Write the .pvtu for @p pieces, files written with the same fields. */
  void write_record(std::ostream &out,
                    const std::vector<std::string> &pieces) const;

private:
  struct Array
  {
    std::string name, type;
    unsigned int n_components;
    std::size_t n_items, item_size;
    Fill<char> fill;
  };

  template <typename Number>
  static Array make_array(const std::string &name,
                          const unsigned int n_components,
                          const std::size_t n_items,
                          const Fill<Number> &values)
  {
    const std::string kind = std::is_floating_point_v<Number> ? "Float"
                             : std::is_signed_v<Number>       ? "Int"
                                                              : "UInt";
    return {
        name,
        kind + std::to_string(8 * sizeof(Number)),
        n_components,
        n_items,
        n_components * sizeof(Number),
        [values](const std::size_t begin, const std::size_t end, char *bytes) {
          values(begin, end, reinterpret_cast<Number *>(bytes));
        }};
  }
  void write_data(std::ostream &out, const Array &array) const;

  VtuFile(const Items<double> &points,
          const Array &connectivity,
          const Items<std::int64_t> &ends,
          Shape shape);

  std::size_t number_of_cells() const { return cells[1].n_items; }

  Array points;
  /** connectivity, offsets and types; of polyhedra also what faces are. */
  std::vector<Array> cells;
  std::vector<Array> cell_fields;
  std::vector<Array> point_fields;
};
} // namespace Voussoir

#endif
