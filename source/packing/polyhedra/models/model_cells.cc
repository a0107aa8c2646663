// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/group_names.h>
#include <voussoir/packing/polyhedra/models/block_parts.h>
#include <voussoir/packing/polyhedra/models/check_surface.h>
#include <voussoir/packing/polyhedra/models/mend_surface.h>
#include <voussoir/packing/polyhedra/models/model_cells.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace Voussoir
{
using dealii::Point;
using Kind = ModelDefect::Kind;

namespace
{
/**
 * The tolerance over the size of a block: files of meshes have three decimals,
 * or faces that touch but were drawn one by one; what was computed has twelve
 * digits.
 */
constexpr double tolerance_of_meshes = 1e-2, tolerance_of_computed = 1e-9;

/** The error of coordinates from another program, in units of rounding. */
constexpr double rounding_of_coordinates =
    16. * std::numeric_limits<double>::epsilon();

/**
 * The distance of vertices that are one, over the diagonal of the block: that of
 * numbers with seven digits, as in files of single precision.
 */
constexpr double relative_welding_distance = 1e-6;

/**
 * The distance from their common plane of faces that are joined, over the
 * tolerance: they may then still touch others within the tolerance.
 */
constexpr double share_for_planes = 0.1;

/**
 * The thickness of a block over the tolerance below which what lies on both
 * sides of it may be taken to touch through it.
 */
constexpr double least_thickness_over_tolerance = 2.;

/** How much the volumes of two blocks at one place differ that are the same. */
constexpr double volume_of_same = 1e-3;

/** A block on its way to a cell. */
struct ModelBlock
{
  BlockMesh mesh;
  MendedSurface mended;
  SurfaceSums sums; // if it is usable
};

double distance_to_weld(const BlockMesh &mesh)
{
  return relative_welding_distance * diagonal_of(mesh.vertices);
}

/** Weld within a distance, and orient. */
MendedSurface closed_surface(const BlockMesh &mesh, const double distance)
{
  MendedSurface mended = surface_of(mesh);
  if (mended.is_usable())
    weld(mended, distance);
  if (mended.is_usable())
    orient(mended);
  return mended;
}

bool has(const MendedSurface &mended, const Kind kind)
{
  return std::any_of(mended.defects.begin(), mended.defects.end(),
                     [&](const ModelDefect &d) { return d.kind == kind; });
}

/** The parts of all blocks, the fixed ones at the end. */
std::vector<ModelBlock> blocks_of(BlockMeshes &meshes,
                                  const ModelOptions &options)
{
  std::vector<ModelBlock> blocks;
  for (BlockMesh &mesh : meshes.blocks)
  {
    mesh.is_support = mesh.is_support && options.uses_supports;
    for (Point<3> &p : mesh.vertices)
      for (unsigned int d = 0; d < 3; ++d)
        if (options.scale != 1. && std::isfinite(p[d]))
          p[d] *= options.scale;
    const std::vector<std::vector<unsigned int>> parts = parts_of(mesh);
    if (parts.size() <= 1)
      blocks.push_back({std::move(mesh), {}, {}});
    else
      for (const std::vector<unsigned int> &part : parts)
        blocks.push_back({part_of_block(mesh, part), {}, {}});
    if (parts.size() > 1)
      blocks[blocks.size() - parts.size()].mended.defects.push_back(
          {Kind::separate_parts, 0, static_cast<unsigned int>(parts.size())});
  }
  std::stable_partition(blocks.begin(), blocks.end(), [](const ModelBlock &b) {
    return !b.mesh.is_support;
  });
  return blocks;
}

void mend(ModelBlock &block, const double distance)
{
  MendedSurface closed = closed_surface(block.mesh, distance);
  std::vector<ModelDefect> &defects = block.mended.defects;
  closed.defects.insert(closed.defects.begin(), defects.begin(), defects.end());
  block.mended = std::move(closed);
  if (block.mended.is_usable())
    block.sums = sums_of(block.mended.surface);
}

/** The cube root of the mean volume of what has one; else of the boxes. */
double size_of_blocks(const std::vector<ModelBlock> &blocks)
{
  double volume = 0., diagonals = 0.;
  unsigned int n = 0, n_boxes = 0;
  for (const ModelBlock &block : blocks)
    if (block.mended.is_usable())
    {
      volume += block.sums.volume;
      ++n;
    }
    else if (!has(block.mended, Kind::bad_number) &&
             !has(block.mended, Kind::bad_scale))
    {
      diagonals += diagonal_of(block.mesh.vertices);
      ++n_boxes;
    }
  // Of a cube with that diagonal.
  return n > 0 ? std::cbrt(volume / n)
               : diagonals / std::max(n_boxes, 1u) / std::sqrt(3.);
}

double largest_coordinate_of(const std::vector<ModelBlock> &blocks)
{
  double largest = 0.;
  for (const ModelBlock &block : blocks)
    if (!has(block.mended, Kind::bad_number) &&
        !has(block.mended, Kind::bad_scale))
      for (const Point<3> &p : block.mesh.vertices)
        for (unsigned int d = 0; d < 3; ++d)
          largest = std::max(largest, std::abs(p[d]));
  return largest;
}

double tolerance_of(const std::vector<ModelBlock> &blocks,
                    const BlockMeshes &meshes,
                    const double relative)
{
  const double size = size_of_blocks(blocks);
  const double rounding =
      rounding_of_coordinates * largest_coordinate_of(blocks);
  if (relative == 0.)
    return std::max(rounding, size * (meshes.is_computed
                                          ? tolerance_of_computed
                                          : tolerance_of_meshes));
  if (relative * size < rounding)
    throw InputError(text("The tolerance ", relative, " of the size ", size,
                          " of a block is below the rounding ", rounding,
                          " of the coordinates of '", meshes.file.string(),
                          "'; give more, or 0 for an automatic value."));
  return relative * size;
}

/** All that is done to a block once the tolerance is known. */
void finish(ModelBlock &block, const double tolerance)
{
  MendedSurface &mended = block.mended;
  if (has(mended, Kind::open))
  {
    ModelBlock other = {block.mesh, {}, {}};
    if (has(mended, Kind::separate_parts))
      other.mended.defects.push_back(mended.defects.front());
    mend(other, tolerance);
    if (other.mended.is_usable())
      block = std::move(other);
  }
  if (!mended.is_usable())
    return;
  const double distance = share_for_planes * tolerance;
  join_coplanar_faces(mended, distance);
  drop_straight_vertices(mended, distance_to_weld(block.mesh));
  check_faces(mended, distance);
  if (mended.is_usable())
    check_crossings(mended, tolerance);
  const double thickness = 2. * block.sums.volume / block.sums.area;
  if (mended.is_usable() &&
      thickness < least_thickness_over_tolerance * tolerance)
  {
    ModelDefect thin = {Kind::thin};
    thin.size = thickness;
    thin.place = block.sums.centroid;
    thin.detail = text(tolerance);
    mended.defects.push_back(thin);
  }
}

/** Find blocks that are where one before them is. */
void check_repeated_blocks(std::vector<ModelBlock> &blocks,
                           const CellRecords &records,
                           const double tolerance)
{
  namespace bgi = boost::geometry::index;
  std::vector<std::pair<Point<3>, unsigned int>> centroids;
  for (unsigned int b = 0; b < blocks.size(); ++b)
    if (blocks[b].mended.is_usable())
      centroids.emplace_back(blocks[b].sums.centroid, b);
  const bgi::rtree<std::pair<Point<3>, unsigned int>, bgi::rstar<16>> tree(
      centroids);
  for (const auto &[centroid, b] : centroids)
  {
    Point<3> low = centroid, high = centroid;
    for (unsigned int d = 0; d < 3; ++d)
    {
      low[d] -= tolerance;
      high[d] += tolerance;
    }
    const dealii::BoundingBox<3> box({low, high});
    for (auto near = tree.qbegin(bgi::intersects(box)); near != tree.qend();
         ++near)
    {
      const double other = blocks[near->second].sums.volume;
      if (near->second < b && std::abs(other - blocks[b].sums.volume) <=
                                  volume_of_same * other)
      {
        ModelDefect repeated = {Kind::repeated_block};
        repeated.place = centroid;
        repeated.detail = records.describe(near->second);
        blocks[b].mended.defects.push_back(repeated);
        break;
      }
    }
  }
}

/** The file and its records, and the names of groups in the order of cells. */
CellRecords records_of(std::vector<ModelBlock> &blocks,
                       const BlockMeshes &meshes)
{
  CellRecords records;
  records.file = meshes.file.string();
  records.record_name = meshes.record_name;
  std::map<std::string, unsigned int> numbers;
  for (ModelBlock &block : blocks)
  {
    std::string name = block.mesh.name.empty() ? "block" : block.mesh.name;
    if (!fault_of_group_name(name).empty())
    {
      ModelDefect unusable = {Kind::unusable_name};
      unusable.detail = quoted_group_name(name);
      block.mended.defects.push_back(unusable);
      name = "block";
    }
    const auto [entry, is_new] =
        numbers.emplace(name, records.group_names.size());
    if (is_new)
      records.group_names.push_back(name);
    records.group.push_back(entry->second);
    records.records.push_back(block.mesh.record);
  }
  if (records.group_names == std::vector<std::string>{"block"})
  {
    records.group_names.clear();
    records.group.clear();
  }
  return records;
}

void add_cell(const Surface &surface, CellFaces &cells)
{
  std::vector<bool> is_used(surface.vertices.size(), false);
  for (const unsigned int vertex : surface.faces.corners)
    is_used[vertex] = true;
  std::vector<unsigned int> number(surface.vertices.size());
  for (unsigned int v = 0; v < number.size(); ++v)
    if (is_used[v])
    {
      number[v] = cells.vertices.size();
      cells.vertices.push_back(surface.vertices[v]);
    }
  std::vector<unsigned int> loop;
  for (unsigned int f = 0; f < surface.faces.size(); ++f)
  {
    loop.clear();
    for (const unsigned int vertex : surface.faces[f])
      loop.push_back(number[vertex]);
    cells.add_face(loop);
  }
  cells.end_cell();
}
} // namespace

ModelCells cells_of_model(BlockMeshes meshes, const ModelOptions &options)
{
  if (!(std::isfinite(options.scale) && options.scale > 0.))
    throw InputError(text("The scale ", text_of_number(options.scale),
                          " of the model '", meshes.file.string(),
                          "' must be a positive number."));
  std::vector<ModelBlock> blocks = blocks_of(meshes, options);
  ModelCells model;
  static_cast<CellRecords &>(model.cells) = records_of(blocks, meshes);
  for (ModelBlock &block : blocks)
    mend(block, distance_to_weld(block.mesh));
  const double tolerance = tolerance_of(blocks, meshes, options.tolerance);
  for (ModelBlock &block : blocks)
    finish(block, tolerance);
  check_repeated_blocks(blocks, model.cells, tolerance);
  for (unsigned int b = 0; b < blocks.size(); ++b)
    for (ModelDefect defect : blocks[b].mended.defects)
    {
      defect.cell = b;
      model.defects.push_back(defect);
    }
  refuse_defects(model.defects, model.cells);
  for (const ModelBlock &block : blocks)
  {
    add_cell(block.mended.surface, model.cells);
    model.cells.n_fixed += block.mesh.is_support;
  }
  model.cells.tolerance = tolerance;
  model.cells.notices = notices_of(model.defects, model.cells);
  return model;
}
} // namespace Voussoir
