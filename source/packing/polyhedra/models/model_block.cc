// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/models/block_parts.h>
#include <voussoir/packing/polyhedra/models/check_surface.h>
#include <voussoir/packing/polyhedra/models/model_block.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Voussoir
{
using dealii::Point;
using DefectKind = ModelDefect::Kind;

namespace
{
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

/** How far one goes to close a surface. */
enum class Closing
{
  weld,              /**< vertices at one place are one */
  weld_and_subdivide /**< and edges have the vertices that lie within them */
};

/** Weld within a distance, or that of seven digits if it is zero; orient. */
MendedSurface closed_surface(const BlockMesh &mesh,
                             const double distance,
                             const Closing closing)
{
  MendedSurface mended;
  mended.defects = mesh.faults;
  if (!mended.is_usable())
    return mended;
  mended = surface_of(mesh);
  if (mended.is_usable())
    weld(mended,
         distance > 0. ? distance : distance_of_seven_digits(mesh.vertices));
  if (mended.is_usable() && closing == Closing::weld_and_subdivide)
    add_hanging_vertices(mended, distance);
  if (mended.is_usable())
    orient(mended);
  return mended;
}

/** Close the surface, behind the defects that were found before. */
void close_block(ModelBlock &block,
                 const double distance,
                 const Closing closing)
{
  MendedSurface closed = closed_surface(block.mesh, distance, closing);
  std::vector<ModelDefect> &defects = block.mended.defects;
  closed.defects.insert(closed.defects.begin(), defects.begin(), defects.end());
  block.mended = std::move(closed);
  if (block.mended.is_usable())
    block.sums = sums_of(block.mended.surface);
}

/** Close an open block within a tolerance, if that can be done. */
void close_within(ModelBlock &block, const double tolerance)
{
  for (const Closing closing : {Closing::weld, Closing::weld_and_subdivide})
  {
    ModelBlock other = {block.mesh, {}, {}};
    for (const ModelDefect &defect : block.mended.defects)
      if (defect.kind <= DefectKind::unusable_name)
        other.mended.defects.push_back(defect);
    close_block(other, tolerance, closing);
    if (other.mended.is_usable() && is_connected(other.mended.surface.faces))
    {
      block = std::move(other);
      return;
    }
  }
  tell_gaps(block.mended, tolerance);
}

/** Find whether a block is as thin as the tolerance. */
void check_thickness_of_block(ModelBlock &block, const double tolerance)
{
  const double thickness = 2. * block.sums.volume / block.sums.area;
  if (thickness >= least_thickness_over_tolerance * tolerance)
    return;
  ModelDefect thin = {DefectKind::thin};
  thin.size = thickness;
  thin.place = block.sums.centroid;
  thin.detail = text(tolerance);
  block.mended.defects.push_back(thin);
}
} // namespace

bool ModelBlock::has(const ModelDefect::Kind kind) const
{
  return std::any_of(mended.defects.begin(), mended.defects.end(),
                     [&](const ModelDefect &d) { return d.kind == kind; });
}

bool ModelBlock::has_numbers() const
{
  return !has(DefectKind::bad_number) && !has(DefectKind::bad_scale) &&
         mesh.faults.empty();
}

std::vector<ModelBlock> model_blocks(BlockMeshes meshes,
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
    const std::vector<std::vector<unsigned int>> parts =
        mesh.faults.empty() ? parts_of(mesh)
                            : std::vector<std::vector<unsigned int>>();
    if (parts.size() <= 1)
      blocks.push_back({std::move(mesh), {}, {}});
    else
      for (const std::vector<unsigned int> &part : parts)
        blocks.push_back({part_of_block(mesh, part), {}, {}});
    if (parts.size() > 1 && !mesh.name.empty())
      blocks[blocks.size() - parts.size()].mended.defects.push_back(
          {DefectKind::separate_parts, 0,
           static_cast<unsigned int>(parts.size())});
  }
  std::stable_partition(blocks.begin(), blocks.end(),
                        [](const ModelBlock &b) { return !b.mesh.is_support; });
  return blocks;
}

void mend_block(ModelBlock &block)
{
  close_block(block, 0., Closing::weld);
}

void finish_block(ModelBlock &block, const double tolerance)
{
  if (block.has(DefectKind::open))
    close_within(block, tolerance);
  MendedSurface &mended = block.mended;
  const double distance = share_for_planes * tolerance;
  if (!mended.is_usable())
  {
    if (block.has_numbers())
      check_shapes_of_faces(mended);
    return;
  }
  join_coplanar_faces(mended, distance);
  drop_straight_vertices(mended,
                         distance_of_seven_digits(mended.surface.vertices));
  check_faces(mended, distance);
  if (mended.is_usable())
    check_crossings(mended, tolerance);
  if (mended.is_usable())
    check_thickness_of_block(block, tolerance);
}
} // namespace Voussoir
