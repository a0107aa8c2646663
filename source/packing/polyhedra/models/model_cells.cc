// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/group_names.h>
#include <voussoir/packing/polyhedra/models/block_places.h>
#include <voussoir/packing/polyhedra/models/model_block.h>
#include <voussoir/packing/polyhedra/models/model_cells.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace Voussoir
{
using dealii::Point;
using DefectKind = ModelDefect::Kind;

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
    else if (block.has_numbers())
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
    if (block.has_numbers())
      for (const Point<3> &p : block.mesh.vertices)
        for (unsigned int d = 0; d < 3; ++d)
          largest = std::max(largest, std::abs(p[d]));
  return largest;
}

double model_tolerance(const std::vector<ModelBlock> &blocks,
                       const BlockMeshes &meshes,
                       const double relative)
{
  const double size = size_of_blocks(blocks);
  const double rounding =
      rounding_of_coordinates * largest_coordinate_of(blocks);
  if (relative == 0.)
    return std::max(rounding,
                    size * (meshes.is_computed ? tolerance_of_computed
                                               : tolerance_of_meshes));
  if (relative * size < rounding)
    throw InputError(text("The tolerance ", relative, " of the size ", size,
                          " of a block is below the rounding ", rounding,
                          " of the coordinates of '", meshes.file.string(),
                          "'; give more, or 0 for an automatic value."));
  return relative * size;
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
      ModelDefect unusable = {DefectKind::unusable_name};
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

ModelCells cells_of_model(const BlockMeshes &meshes,
                          const ModelOptions &options)
{
  if (!(std::isfinite(options.scale) && options.scale > 0.))
    throw InputError(text("The scale ", text_of_number(options.scale),
                          " of the model '", meshes.file.string(),
                          "' must be a positive number."));
  std::vector<ModelBlock> blocks = model_blocks(meshes, options);
  ModelCells model;
  static_cast<CellRecords &>(model.cells) = records_of(blocks, meshes);
  for (ModelBlock &block : blocks)
    mend_block(block);
  const double tolerance = model_tolerance(blocks, meshes, options.tolerance);
  for (ModelBlock &block : blocks)
    finish_block(block, tolerance);
  check_repeated_blocks(blocks, model.cells, tolerance);
  check_enclosed_blocks(blocks, model.cells, tolerance);
  model.defects = meshes.faults;
  for (unsigned int b = 0; b < blocks.size(); ++b)
    for (ModelDefect defect : blocks[b].mended.defects)
    {
      defect.cell = b;
      model.defects.push_back(defect);
    }
  refuse_defects(model.defects, model.cells);
  for (ModelDefect &defect : model.defects)
  {
    if (defect.kind == DefectKind::separate_parts ||
        defect.kind == DefectKind::unusable_name)
      defect.place = blocks[defect.cell].sums.centroid;
    model.cells.defects.push_back(cell_defect(defect));
  }
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
