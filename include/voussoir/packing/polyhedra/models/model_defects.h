// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_models_model_defects_h
#define voussoir_packing_polyhedra_models_model_defects_h

#include <voussoir/packing/cell_records.h>
#include <voussoir/packing/polyhedra/cell_defects.h>

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <string>
#include <vector>

namespace Voussoir
{
/** What is wrong with a block of a model, and was mended or must be. */
struct ModelDefect
{
  /**
   * The kinds: those that were mended, then those of the file and of the shape
   * of a block that are refused.
   */
  enum class Kind
  {
    /** Entries of a list of meshes that are none, left out. */
    skipped_entry,
    /** Several closed surfaces of one name, each of which is a cell. */
    separate_parts,
    /** A name that no group of cells can have; the cell is a "block". */
    unusable_name,
    /** Vertices at one place, welded into one; size: their distance. */
    welded_vertex,
    /** Vertices within an edge that has them in one of its two faces only,
     * added to the other; size: their distance from it. */
    hanging_vertex,
    /** Faces with a vertex twice in a row, or a spike; taken once. */
    repeated_vertex,
    /** Faces with less than three different vertices, left out. */
    degenerate_face,
    /** Faces listed before, left out. */
    repeated_face,
    /** Faces that ran the other way round, turned. */
    turned_face,
    /** Faces in the plane of a neighbour, joined to it. */
    joined_face,
    /** Vertices within a straight edge, left out. */
    straight_vertex,
    /** Faces whose vertices are off their plane; size: the distance. */
    bent_face,
    /** Cells that penetrate another; size: how deeply. */
    overlap,

    /** An object of the file has two values of one key. From here on the
     * model is refused. */
    repeated_key,
    /** A block of the file without a shape. */
    no_mesh,
    /** A block whose shape is no mesh. */
    other_shape,
    /** A part of a hierarchy that is not in the file. */
    unknown_element,
    /** An element that is in a hierarchy twice. */
    repeated_element,
    /** A transformation that is no matrix of 4 by 4 numbers. */
    bad_matrix,
    /** A transformation that is no affine map. */
    projective_map,
    /** A transformation that makes all blocks flat. */
    singular_map,
    /** A mark of a support that is neither true nor false. */
    bad_flag,
    /** A coordinate that is no number. */
    bad_coordinate,
    /** A coordinate that is not there. */
    missing_coordinate,
    /** The number of a vertex that is no whole number. */
    bad_index,
    /** A face with a vertex that is not there. */
    unknown_vertex,
    /** A face that is no list of vertices. */
    bad_face,
    /** Half-edges that are no loop. */
    bad_half_edges,

    /** No face, or no vertex. From here on the shape is wrong. */
    no_face,
    /** A coordinate that is not finite. */
    bad_number,
    /** Coordinates too large or too small to reckon with; size: theirs. */
    bad_scale,
    /** Edges of one face only. */
    open,
    /** Edges of one face only, beside others at more than the tolerance; size:
     * that distance. */
    gap,
    /** Edges of more than two faces. */
    branching,
    /** No inside: the faces cannot be turned to agree. */
    one_sided,
    /** Less than four faces; size: their number. */
    few_faces,
    /** No volume; size: the volume over the area. */
    no_volume,
    /** Faces without an area, of which no neighbour could be extended. */
    flat_face,
    /** Faces that cross or touch themselves. */
    crossing_face,
    /** Faces that run along an edge twice, as around a hole. */
    bridged_face,
    /** Faces so far from their plane that they have none; size: how far. */
    warped_face,
    /** Faces that cross other faces of the block; size: how far. */
    crossing_surface,
    /** As thin as the tolerance; size: the thickness. */
    thin,
    /** A block where another one is. */
    repeated_block,
    /** A block inside of another one. */
    enclosed_block
  };

  /** What it is. */
  Kind kind;
  /** The cell that has it, by its number in CellFaces; invalid if none does. */
  unsigned int cell = 0;
  /** The number of faces, edges, vertices or parts that have it. */
  unsigned int count = 1;
  /** The first or the worst of the faces, numbered from zero in its block in
   * the file; invalid if it is not of a face. */
  unsigned int face = dealii::numbers::invalid_unsigned_int;
  /** What the kind says, of the worst one; else zero. */
  double size = 0.;
  /** Where the first or the worst one is; a length. */
  dealii::Point<3> place = {};
  /** What the message needs besides: a name, another cell, or all of it if the
   * fault is one of the file. */
  std::string detail = {};

  /** True if the block cannot be used. */
  bool is_refusal() const { return kind >= Kind::repeated_key; }
  /** True if the file cannot be understood there. */
  bool is_of_file() const { return is_refusal() && kind < Kind::no_face; }
};

/** The kind in a few words, such as "faces listed twice". */
std::string text_of(ModelDefect::Kind kind);

/**
 * A sentence on a defect without its cell, such as "is open: ...; close the
 * surface." or "has 2 faces listed twice; they are left out.".
 */
std::string text_of(const ModelDefect &defect);

/** A defect that was mended, or is tolerated, for tables and files. */
CellDefect cell_defect(const ModelDefect &defect);

/** CellRecords::describe(), with the name of the cell's group in quotes. */
std::string describe_named(const CellRecords &records, unsigned int cell);

/**
 * One sentence for each kind of defect that was mended, with the numbers of
 * all, and the first or the worst.
 */
std::vector<std::string> notices_of(const std::vector<ModelDefect> &defects,
                                    const CellRecords &records);

/**
 * @throws InputError that names the defects that cannot be mended, of each kind
 *   the first five in full, if there are any.
 */
void refuse_defects(const std::vector<ModelDefect> &defects,
                    const CellRecords &records);
} // namespace Voussoir

#endif
