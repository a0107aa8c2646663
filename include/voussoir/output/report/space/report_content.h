// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_space_report_content_h
#define voussoir_output_report_space_report_content_h

#include <voussoir/packing/polyhedra/cell_faces.h>
#include <voussoir/packing/polyhedra/face_contacts.h>

#include <deal.II/base/tensor.h>

#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
/** A number for each block, or for each joint. */
struct SpaceField
{
  /** The name that the reader sees, such as "Normal force". */
  std::string name;
  /** The unit of the values; empty for a pure number, or if not named. */
  std::string unit;
  /** One value a block or joint; others than finite ones are missing. */
  std::vector<double> values;
};

/** What the page of a packing in space shows. */
struct SpaceReport
{
  /** The title of the page; empty for the name of the program. */
  std::string title;
  /** The blocks; always there. */
  const CellFaces *cells = nullptr;
  /**
   * The joints between them; none if null. A pair of one face twice is a
   * joint with the ground.
   */
  const FaceContacts *contacts = nullptr;
  /** Fields with one value a block, CellFaces::n_fixed ones included. */
  std::vector<SpaceField> cell_fields;
  /** Fields with one value a pair of FaceContacts::faces. */
  std::vector<SpaceField> contact_fields;
  /** Labels and texts, for the table below the picture. */
  std::vector<std::pair<std::string, std::string>> summary;
  /** What the run warned of, a sentence each. */
  std::vector<std::string> warnings = {};
  /** What was wrong with the blocks, and was mended or is tolerated. */
  std::vector<CellDefect> defects = {};
  /** The motion of a block, to first order. */
  struct BlockMotion
  {
    /** Of its centroid, of any size; a length. */
    dealii::Tensor<1, 3> displacement;
    /** The vector of its angle, in the unit of that over one of length. */
    dealii::Tensor<1, 3> rotation;
  };
  /** That of each block, CellFaces::n_fixed ones included; empty for none. */
  std::vector<BlockMotion> motion = {};
  /** True if it is to be seen at once, as what the loads do. */
  bool collapses = false;
};

/**
 * Check that each number of a report means something.
 *
 * @throws InputError if a vertex is not finite or out of all bounds, if a face
 *   or a contact has the number of a vertex or face that does not exist, or if
 *   a field has not one value for each block or joint.
 */
void check_content(const SpaceReport &report);
} // namespace Voussoir

#endif
